#include "ui/calibration/calibration_page.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QPainter>
#include <algorithm>

#include "ui/calibration/button_state.h"
#include "ui/calibration/calibration_sheet.h"
#include "ui/calibration/evidence_card.h"
#include "ui/calibration/page_header.h"
#include "ui/calibration/result_card.h"
#include "ui/calibration/steps_card.h"
#include "ui/style_sheet.h"

namespace hedr {
namespace {

constexpr QSize kRoomy_px{1200, 800};

// Of the outer cards, in steps of 8 px; the evidence has the rest.
int cardWidth(int page_px, double share, int least_px, int most_px) {
    return std::clamp(static_cast<int>(share * page_px) / 8 * 8, least_px, most_px);
}

}  // namespace

CalibrationPage::CalibrationPage(QWidget* parent)
    : QWidget(parent),
      header_(new PageHeader(this)),
      steps_(new StepsCard(this)),
      evidence_(new EvidenceCard(this)),
      result_(new ResultCard(this)),
      cancel_(new QPushButton(this)),
      secondary_(new QPushButton(this)),
      also_(new QPushButton(this)),
      primary_(new QPushButton(this)),
      promise_(new QLabel(tr("Everything is kept: who, when, robot, floor, raw data, old and new "
                             "values. Nothing is written to the robot unless you ask for it."),
                          this)),
      cards_(new QHBoxLayout),
      buttons_(new QHBoxLayout),
      below_header_(new QVBoxLayout) {
    layOut();
    evidence_->setTabsAfter(steps_->lastInTabOrder());
    promise_->setWordWrap(true);
    promise_->setProperty("role", QStringLiteral("caption"));
    connect(cancel_, &QPushButton::clicked, this, &CalibrationPage::canceled);
    connect(primary_, &QPushButton::clicked, this, &CalibrationPage::primaryRequested);
    connect(also_, &QPushButton::clicked, this, &CalibrationPage::alsoRequested);
    connect(secondary_, &QPushButton::clicked, this, &CalibrationPage::secondaryRequested);
    connect(steps_, &StepsCard::entryEdited, this, &CalibrationPage::entryEdited);
    connect(steps_, &StepsCard::procedureActionRequested, this,
            &CalibrationPage::procedureActionRequested);
}

void CalibrationPage::layOut() {
    for (QPushButton* button : {cancel_, secondary_, also_, primary_}) {
        button->setMinimumWidth(144);
        button->setFocusPolicy(Qt::StrongFocus);
    }
    cards_->addWidget(steps_);
    cards_->addWidget(evidence_, 1);
    cards_->addWidget(result_);
    buttons_->addWidget(cancel_);
    buttons_->addStretch();
    buttons_->addWidget(secondary_);
    buttons_->addWidget(also_);
    buttons_->addWidget(primary_);
    below_header_->addLayout(cards_, 1);
    below_header_->addLayout(buttons_);
    below_header_->addWidget(promise_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(header_);
    column->addLayout(below_header_, 1);
}

void CalibrationPage::setTheme(const Theme& theme) {
    theme_ = theme;
    header_->setTheme(theme);
    steps_->setTheme(theme);
    evidence_->setTheme(theme);
    result_->setTheme(theme);
    promise_->setStyleSheet(calibrationSheet(theme));
    for (QPushButton* button : {cancel_, secondary_, also_})
        button->setStyleSheet(buttonSheet(theme));
    primary_->setStyleSheet(primaryButtonSheet(theme));
    update();
}

void CalibrationPage::show(const CalibrationView& view) {
    header_->show(view.title, view.context);
    steps_->show(view);
    evidence_->show(view.calibration.plots);
    result_->show(view.calibration);
    showButton(*cancel_, view.leave);
    showButton(*secondary_, view.secondary);
    showButton(*also_, view.also);
    showPrimary(view.primary);
    setAccessibleName(view.title);
    setVisible(true);
}

// A button that is switched off hands the focus on, which would make the next key press something
// else. The page keeps it instead, until the button is on again.
void CalibrationPage::showPrimary(const PageButton& state) {
    const bool usable = state.enabled && !state.text.isEmpty();
    const bool focused = primary_->hasFocus() || hasFocus();
    if (primary_->hasFocus() && !usable) setFocus();
    showButton(*primary_, state);
    if (focused && usable) primary_->setFocus();
}

void CalibrationPage::focusFirst() { primary_->isEnabled() ? primary_->setFocus() : setFocus(); }

void CalibrationPage::paintEvent(QPaintEvent*) {
    QPainter(this).fillRect(rect(), theme_.background);
}

void CalibrationPage::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    const bool roomy = width() >= kRoomy_px.width() && height() >= kRoomy_px.height();
    const int margin_px = roomy ? 32 : 16;
    const int gap_px = roomy ? 24 : 16;
    header_->setFixedHeight(roomy ? 72 : 56);
    header_->setMargin(margin_px);
    below_header_->setContentsMargins(margin_px, margin_px, margin_px, margin_px);
    below_header_->setSpacing(gap_px);
    cards_->setSpacing(gap_px);
    buttons_->setSpacing(gap_px);
    steps_->setFixedWidth(cardWidth(width(), 0.2625, 272, 420));
    result_->setFixedWidth(cardWidth(width(), 0.24, 288, 368));
    steps_->setRoomy(roomy);
    evidence_->setRoomy(roomy);
    result_->setRoomy(roomy);
}

void CalibrationPage::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape) {
        cancel_->click();
    } else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        // Of a field it says that this was all.
        if (qobject_cast<QLineEdit*>(focusWidget())) return focusFirst();
        auto* focused = qobject_cast<QAbstractButton*>(focusWidget());
        (focused && isAncestorOf(focused) ? focused : primary_)->click();
    } else {
        QWidget::keyPressEvent(event);
    }
}

}  // namespace hedr
