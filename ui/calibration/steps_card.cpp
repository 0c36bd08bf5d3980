#include "ui/calibration/steps_card.h"

#include <QHBoxLayout>
#include <algorithm>
#include <utility>

#include "ui/calibration/button_state.h"
#include "ui/calibration/calibration_sheet.h"
#include "ui/calibration/entry_rows.h"
#include "ui/calibration/step_row.h"
#include "ui/fonts.h"
#include "ui/style_sheet.h"

namespace hedr {
namespace {

std::size_t nextOf(const std::vector<CalibrationStep>& steps) {
    const auto next = std::ranges::find(steps, false, &CalibrationStep::done);
    return static_cast<std::size_t>(next - steps.begin());
}

QString progressTitle(const CalibrationView& view) {
    const std::vector<CalibrationStep>& steps = view.calibration.steps;
    const std::size_t next = nextOf(steps);
    if (!view.progress_title.isEmpty()) return view.progress_title;
    return next < steps.size() ? QString::fromStdString(steps[next].title)
                               : StepsCard::tr("All steps are done");
}

}  // namespace

StepsCard::StepsCard(QWidget* parent)
    : Card(parent),
      caption_(new QLabel(tr("WHAT TO DO"), this)),
      rows_area_(new QWidget),
      rows_column_(new QVBoxLayout(rows_area_)),
      entries_(new EntryRows(rows_area_)),
      scroll_(new ScrollBox(rows_area_, this)),
      progress_title_(new QLabel(this)),
      percent_(new QLabel(this)),
      bar_(new QProgressBar(this)),
      known_(new QLabel(this)),
      procedure_action_(new QPushButton(this)) {
    setAccessibleName(tr("What to do"));
    scroll_->setAccessibleName(tr("Steps"));
    rows_column_->addWidget(entries_);
    rows_column_->addStretch();
    caption_->setIndent(ScrollBox::kReach_px);
    caption_->setProperty("role", QStringLiteral("caption"));
    progress_title_->setProperty("role", QStringLiteral("step"));
    progress_title_->setWordWrap(true);
    percent_->setProperty("role", QStringLiteral("detail"));
    percent_->setAlignment(Qt::AlignRight | Qt::AlignBottom);
    percent_->setFixedWidth(QFontMetrics(uiFont(14)).boundingRect(tr("%1 %").arg(100)).width() + 4);
    bar_->setTextVisible(false);
    bar_->setFixedHeight(8);
    bar_->setAccessibleName(tr("Information gained"));
    known_->setProperty("role", QStringLiteral("detail"));
    known_->setTextFormat(Qt::PlainText);
    known_->setWordWrap(true);
    known_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    known_->setMinimumHeight(40);  // room for two lines is kept
    procedure_action_->setVisible(false);
    auto* head = new QHBoxLayout;
    head->addWidget(progress_title_, 1);
    head->addWidget(percent_, 0, Qt::AlignBottom);
    auto* below = new QVBoxLayout;
    below->setContentsMargins(ScrollBox::kReach_px, 8, ScrollBox::kReach_px, 0);
    below->setSpacing(8);
    below->addLayout(head);
    below->addWidget(bar_);
    below->addWidget(known_);
    below->addWidget(procedure_action_, 0, Qt::AlignLeft);
    auto* column = new QVBoxLayout(this);
    column->setSpacing(8);
    column->addWidget(caption_);
    column->addWidget(scroll_, 1);
    column->addLayout(below);
    connect(entries_, &EntryRows::edited, this, &StepsCard::entryEdited);
    connect(procedure_action_, &QPushButton::clicked, this, &StepsCard::procedureActionRequested);
}

void StepsCard::setTheme(const Theme& theme) {
    Card::setTheme(theme);
    setStyleSheet(calibrationSheet(theme));
    procedure_action_->setStyleSheet(buttonSheet(theme));
    for (StepRow* row : rows_) row->setTheme(theme);
}

void StepsCard::setRoomy(bool roomy) {
    const int padding_px = roomy ? 24 : 16;
    const int side_px = padding_px - ScrollBox::kReach_px;
    layout()->setContentsMargins(side_px, padding_px, side_px, padding_px);
    rows_column_->setSpacing(roomy ? 40 : 24);
}

void StepsCard::show(const CalibrationView& view) {
    showSteps(view.calibration.steps);
    entries_->show(view.entries);
    showProgress(view);
    showButton(*procedure_action_, view.procedure_action);
}

void StepsCard::showSteps(const std::vector<CalibrationStep>& steps) {
    while (rows_.size() < steps.size()) {
        auto* row = new StepRow(static_cast<int>(rows_.size()) + 1, rows_area_);
        row->setTheme(theme());
        rows_column_->insertWidget(static_cast<int>(rows_.size()), row);
        rows_.push_back(row);
    }
    const std::size_t next = nextOf(steps);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        if (i >= steps.size()) {
            rows_[i]->setVisible(false);
            continue;
        }
        rows_[i]->show(steps[i], i == next       ? StepRow::State::kNow
                                 : steps[i].done ? StepRow::State::kDone
                                                 : StepRow::State::kLater);
    }
    // Once, when it becomes the next one: the operator may look elsewhere.
    if (std::exchange(next_, next) != next && next < rows_.size()) {
        scroll_->keepInSight(rows_[next]);
    }
}

void StepsCard::showProgress(const CalibrationView& view) {
    const CalibrationProgress& progress = view.calibration.progress;
    // Written so that NaN is nothing.
    const int percent = progress.share > 0.0 ? qRound(100.0 * std::min(progress.share, 1.0)) : 0;
    progress_title_->setText(progressTitle(view));
    percent_->setText(tr("%1 %").arg(percent));
    bar_->setValue(percent);
    QStringList words{QString::fromStdString(progress.known),
                      QString::fromStdString(progress.more)};
    words.removeAll(QString());
    known_->setText(words.join(u'\n'));
}

}  // namespace hedr
