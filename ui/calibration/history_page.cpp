#include "ui/calibration/history_page.h"

#include <QKeyEvent>
#include <QPainter>
#include <algorithm>

#include "ui/calibration/button_state.h"
#include "ui/calibration/calibration_sheet.h"
#include "ui/calibration/history_card.h"
#include "ui/calibration/history_row.h"
#include "ui/calibration/page_header.h"
#include "ui/style_sheet.h"

namespace hedr {
namespace {

constexpr QSize kRoomy_px{1200, 800};
constexpr std::size_t kLongestPath = 4096;  // bytes

// Of the list, in steps of 8 px; the details have the rest.
int listWidth(int page_px) {
    constexpr double kShare = 0.36;
    return std::clamp(static_cast<int>(kShare * page_px) / 8 * 8, 408, 448);
}

QString entryNameOf(const HistoryEntry& entry) { return QString::fromStdString(entry.name); }

QString contextOf(const HistoryView& view) {
    const auto count = view.entries.size();
    const QString entries =
        count == 1 ? HistoryPage::tr("1 entry") : HistoryPage::tr("%1 entries").arg(count);
    return listed({shownWords(view.robot.toStdString()), count == 0 ? QString() : entries});
}

// Empty where it can be done and would change something.
QString whyNotRestored(const HistoryEntry& entry, RestoreTo to, const std::optional<Vehicle>& now) {
    if (!entry.record) return HistoryPage::tr("This entry cannot be read.");
    const CalibrationRecord& record = *entry.record;
    const auto then = parseVehicle(
        to == RestoreTo::kBefore ? record.vehicle_before : record.vehicle_after, entry.name);
    if (!then) return HistoryPage::tr("What the vehicle file said then cannot be read.");
    if (now == *then) return HistoryPage::tr("The vehicle file has these numbers already.");
    return {};
}

PageButton unlessRefused(PageButton button, const QString& why_not) {
    if (why_not.isEmpty()) return button;
    button.enabled = false;
    button.tip = why_not;
    return button;
}

PageButton beforeButton(const HistoryEntry& entry, const std::optional<Vehicle>& now) {
    return unlessRefused(
        {HistoryPage::tr("Restore values before"), true,
         HistoryPage::tr("The vehicle file gets the numbers that it had before this calibration. "
                         "What it has now is kept in the history.")},
        whyNotRestored(entry, RestoreTo::kBefore, now));
}

// What was not taken over left the file as it was: there is nothing after it.
PageButton afterButton(const HistoryEntry& entry, const std::optional<Vehicle>& now) {
    if (entry.record && !entry.record->taken_over) return {};
    return unlessRefused(
        {HistoryPage::tr("Restore values after"), true,
         HistoryPage::tr("The vehicle file gets the numbers that it had after this calibration. "
                         "What it has now is kept in the history.")},
        whyNotRestored(entry, RestoreTo::kAfter, now));
}

PageButton exportButton(const HistoryEntry& entry) {
    return unlessRefused(
        {HistoryPage::tr("Export…"), true,
         HistoryPage::tr("Copies the entry with its samples. They are compared with the hashes "
                         "that were taken of them.")},
        entry.record ? QString() : HistoryPage::tr("This entry cannot be read."));
}

}  // namespace

HistoryPage::HistoryPage(QWidget* parent)
    : QWidget(parent),
      header_(new PageHeader(this)),
      list_(new HistoryList(this)),
      card_(new HistoryCard(this)),
      back_(new QPushButton(tr("Back"), this)),
      export_(new QPushButton(this)),
      before_(new QPushButton(this)),
      after_(new QPushButton(this)),
      promise_(new QLabel(this)),
      cards_(new QHBoxLayout),
      buttons_(new QHBoxLayout),
      below_header_(new QVBoxLayout) {
    layOut();
    promise_->setTextFormat(Qt::PlainText);
    promise_->setWordWrap(true);
    promise_->setProperty("role", QStringLiteral("caption"));
    back_->setToolTip(tr("Leave everything as it is (Esc)"));
    connect(list_, &HistoryList::chosen, this, &HistoryPage::choose);
    connect(list_, &HistoryList::closeWished, this, &HistoryPage::closed);
    connect(back_, &QPushButton::clicked, this, &HistoryPage::closed);
    connect(export_, &QPushButton::clicked, this, [this] { emit exportWished(chosen_); });
    connect(before_, &QPushButton::clicked, this,
            [this] { emit restoreWished(chosen_, RestoreTo::kBefore); });
    connect(after_, &QPushButton::clicked, this,
            [this] { emit restoreWished(chosen_, RestoreTo::kAfter); });
}

void HistoryPage::layOut() {
    for (QPushButton* button : {back_, export_, before_, after_}) {
        button->setMinimumWidth(144);
        button->setFocusPolicy(Qt::StrongFocus);
    }
    cards_->addWidget(list_);
    cards_->addWidget(card_, 1);
    buttons_->addWidget(back_);
    buttons_->addStretch();
    for (QPushButton* button : {export_, before_, after_}) buttons_->addWidget(button);
    below_header_->addLayout(cards_, 1);
    below_header_->addLayout(buttons_);
    below_header_->addWidget(promise_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(header_);
    column->addLayout(below_header_, 1);
}

void HistoryPage::setTheme(const Theme& theme) {
    theme_ = theme;
    header_->setTheme(theme);
    list_->setTheme(theme);
    card_->setTheme(theme);
    promise_->setStyleSheet(calibrationSheet(theme));
    for (QPushButton* button : {back_, export_, before_, after_})
        button->setStyleSheet(buttonSheet(theme));
    update();
}

void HistoryPage::show(const HistoryView& view) {
    view_ = view;
    if (!chosenEntry())
        chosen_ = view_.entries.empty() ? QString() : entryNameOf(view_.entries.back());
    header_->show(tr("Calibration history"), contextOf(view_));
    setAccessibleName(tr("Calibration history"));
    const QString file = shownWords(view_.vehicle_file.toStdString(), kLongestPath);
    promise_->setText(!view_.news.isEmpty()
                          ? view_.news
                          : tr("Everything is kept beside the vehicle file %1. Whoever goes back "
                               "to earlier values loses nothing.")
                                .arg(file));
    promise_->setVisible(!file.isEmpty() || !view_.news.isEmpty());
    list_->show(view_.entries, chosen_);
    fitList();
    showChosen();
    setVisible(true);
}

void HistoryPage::choose(const QString& entry) {
    if (entry == chosen_) return;
    chosen_ = entry;
    list_->choose(entry);
    showChosen();
}

void HistoryPage::showChosen() {
    const HistoryEntry* entry = chosenEntry();
    card_->setVisible(entry);
    if (entry) card_->show(*entry, view_.now);
    showState(*export_, entry ? exportButton(*entry) : PageButton{});
    showState(*before_, entry ? beforeButton(*entry, view_.now) : PageButton{});
    showState(*after_, entry ? afterButton(*entry, view_.now) : PageButton{});
}

// A button that is switched off hands the focus on, and the next key press would undo what the last
// one did. The list has it instead.
void HistoryPage::showState(QPushButton& button, const PageButton& state) {
    if (button.hasFocus() && (!state.enabled || state.text.isEmpty())) focusFirst();
    showButton(button, state);
}

const HistoryEntry* HistoryPage::chosenEntry() const {
    const auto entry = std::ranges::find(view_.entries, chosen_, entryNameOf);
    return entry == view_.entries.end() ? nullptr : &*entry;
}

void HistoryPage::focusFirst() { view_.entries.empty() ? back_->setFocus() : list_->focusChosen(); }

void HistoryPage::paintEvent(QPaintEvent*) { QPainter(this).fillRect(rect(), theme_.background); }

// Without an entry there are no details, and it says so across the page.
void HistoryPage::fitList() {
    const bool alone = view_.entries.empty();
    list_->setMinimumWidth(listWidth(width()));
    list_->setMaximumWidth(alone ? QWIDGETSIZE_MAX : listWidth(width()));
}

void HistoryPage::resizeEvent(QResizeEvent* event) {
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
    fitList();
    list_->setRoomy(roomy);
    card_->setRoomy(roomy);
}

void HistoryPage::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape) {
        back_->click();
    } else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        auto* focused = qobject_cast<QAbstractButton*>(focusWidget());
        if (focused && isAncestorOf(focused)) focused->click();
    } else {
        QWidget::keyPressEvent(event);
    }
}

}  // namespace hedr
