#include "ui/calibration/history_row.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>
#include <QPainter>
#include <QRegularExpression>
#include <QScrollBar>
#include <algorithm>

#include "core/calibration/procedures.h"
#include "core/text/clean_text.h"
#include "ui/calibration/calibration_sheet.h"
#include "ui/calibration/tone_mark.h"
#include "ui/calibration/verdict_text.h"
#include "ui/fonts.h"

namespace hedr {
namespace {

constexpr int kInset_px = 12;
constexpr int kMark_px = 24;

QString historyWords(const char* text) { return QCoreApplication::translate("History", text); }

QString titleOf(const std::string& procedure) {
    if (procedure == "restore") return historyWords("Restored");
    const Procedure* found = findProcedure(procedure);
    return shownWords(found ? found->title : std::string_view(procedure));
}

QString localTime(const QDateTime& time) {
    return QLocale::c().toString(time.toLocalTime(), QStringLiteral("d MMM yyyy, HH:mm"));
}

QString whenOf(const std::string& time_utc) {
    const QDateTime time = QDateTime::fromString(QString::fromStdString(time_utc), Qt::ISODate);
    return time.isValid() ? localTime(time) : shownWords(time_utc);
}

// The name of a folder of the history is "2026-11-28T235900Z-wheels", the second one of a second
// ends in "-2".
HistoryText textOfName(const std::string& name) {
    static const QRegularExpression kParts(
        QStringLiteral("^(\\d{4}-\\d\\d-\\d\\dT\\d{6})Z-(.+?)(-\\d+)?$"));
    HistoryText text{.title = shownWords(name)};
    const QRegularExpressionMatch parts = kParts.match(QString::fromStdString(name));
    if (!parts.hasMatch()) return text;
    QDateTime time =
        QDateTime::fromString(parts.captured(1), QStringLiteral("yyyy-MM-dd'T'HHmmss"));
    time.setTimeSpec(Qt::UTC);
    text.title = titleOf(parts.captured(2).toStdString());
    if (time.isValid()) text.when = localTime(time);
    return text;
}

QString verdictOf(const CalibrationRecord& record) {
    if (record.verdict == Verdict::kAccepted && !record.taken_over)
        return historyWords("accepted, not taken over");
    return verdictWord(record.verdict);
}

}  // namespace

QString shownWords(std::string_view text, std::size_t longest_bytes) {
    static const QRegularExpression kLongPart(QStringLiteral("(\\S{24})(?=\\S)"));
    return QString::fromStdString(cleanText(text, longest_bytes))
        .replace(kLongPart, QStringLiteral("\\1\u200B"));
}

QString listed(QStringList facts) {
    facts.removeAll(QString());
    return facts.join(QStringLiteral(" · "));
}

HistoryText historyText(const HistoryEntry& entry) {
    if (!entry.record) {
        HistoryText text = textOfName(entry.name);
        text.verdict = historyWords("cannot be read");
        text.tone = Tone::kAlarm;
        return text;
    }
    const CalibrationRecord& record = *entry.record;
    return {.title = titleOf(record.procedure),
            .when = whenOf(record.time_utc),
            .who = shownWords(record.who),
            .surface = shownWords(record.surface),
            .verdict = verdictOf(record),
            .tone = verdictTone(record.verdict)};
}

HistoryRow::HistoryRow(QWidget* parent) : RowButton(parent) {
    setCheckable(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void HistoryRow::show(const HistoryEntry& entry) {
    entry_ = QString::fromStdString(entry.name);
    text_ = historyText(entry);
    setText(text_.title);
    setAccessibleName(text_.title);
    setAccessibleDescription(listed({text_.when, text_.who, text_.surface, text_.verdict}));
    setToolTip(accessibleName().toHtmlEscaped() + QStringLiteral("<br>") +
               accessibleDescription().toHtmlEscaped());
    setVisible(true);
    update();
}

void HistoryRow::setChosen(bool chosen) {
    setChecked(chosen);
    setFocusPolicy(chosen ? Qt::StrongFocus : Qt::ClickFocus);
}

void HistoryRow::focusInEvent(QFocusEvent* event) {
    RowButton::focusInEvent(event);
    emit reached();
}

// A bar tells it without the colour, too.
void HistoryRow::paintChosen(QPainter& painter) const {
    constexpr double kBar_px = 4.0;
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme().chip);
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 8.0, 8.0);
    painter.setBrush(theme().accent);
    painter.drawRoundedRect(QRectF(1.0, 12.0, kBar_px, height() - 24.0), 2.0, 2.0);
}

void HistoryRow::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintGround(painter);
    if (isChecked() && !hasFocus()) paintChosen(painter);
    const QRect inside = rect().adjusted(kInset_px, 10, -kInset_px, -10);
    const QRect upper = inside.adjusted(0, 0, 0, -inside.height() / 2);
    const auto draw = [&](const QRect& place, const QString& text) {
        painter.drawText(place, Qt::AlignLeft | Qt::AlignVCenter,
                         painter.fontMetrics().elidedText(text, Qt::ElideRight, place.width()));
    };
    painter.setFont(uiFont(14));
    painter.setPen(theme().dim);
    draw(upper.translated(0, upper.height()), listed({text_.when, text_.who, text_.surface}));
    const int verdict_px = painter.fontMetrics().horizontalAdvance(text_.verdict) + 1;
    const QColor colour = colourOf(text_.tone, theme());
    painter.setPen(colour);
    draw(upper.adjusted(upper.width() - verdict_px, 0, 0, 0), text_.verdict);
    const int mark_from_px = upper.right() + 1 - verdict_px - kMark_px;
    drawToneMark(painter, {mark_from_px + 8.0, upper.center().y() + 1.0}, text_.tone, colour);
    painter.setFont(uiFont(16, QFont::DemiBold));
    painter.setPen(theme().ink);
    draw(QRect(upper.topLeft(), QSize(mark_from_px - 8 - upper.left(), upper.height())), text());
}

HistoryList::HistoryList(QWidget* parent)
    : RowListCard(parent),
      caption_(new QLabel(tr("NEWEST FIRST"), this)),
      empty_(new QLabel(tr("Nothing has been calibrated yet."), this)),
      rows_area_(new QWidget),
      rows_column_(new QVBoxLayout(rows_area_)),
      scroll_(new ScrollBox(rows_area_, this)) {
    setAccessibleName(tr("Entries"));
    caption_->setProperty("role", QStringLiteral("caption"));
    caption_->setIndent(kInset_px + ScrollBox::kReach_px);
    empty_->setProperty("role", QStringLiteral("hint"));
    empty_->setAlignment(Qt::AlignCenter);
    empty_->setWordWrap(true);
    rows_column_->setSpacing(0);
    rows_column_->addStretch();
    // Its rows scroll it, and one of them can be reached: it is no stop besides. After ScrollBox,
    // which makes it one.
    connect(scroll_->verticalScrollBar(), &QScrollBar::rangeChanged, scroll_,
            [this] { scroll_->setFocusPolicy(Qt::NoFocus); });
    auto* column = new QVBoxLayout(this);
    column->setSpacing(8);
    column->addWidget(caption_);
    column->addWidget(empty_, 1);
    column->addWidget(scroll_, 1);
}

void HistoryList::setTheme(const Theme& theme) {
    Card::setTheme(theme);
    setStyleSheet(calibrationSheet(theme));
    for (HistoryRow* row : rows_) row->setTheme(theme);
}

void HistoryList::setRoomy(bool roomy) {
    const int side_px = roomy ? 8 : 4;
    const int padding_px = roomy ? 24 : 16;
    layout()->setContentsMargins(side_px, padding_px, side_px, roomy ? 16 : 8);
}

void HistoryList::addRow() {
    auto* row = new HistoryRow(rows_area_);
    row->setTheme(theme());
    rows_column_->insertWidget(static_cast<int>(rows_.size()), row);
    setTabOrder(rows_.empty() ? static_cast<QWidget*>(scroll_) : rows_.back(), row);
    const auto say = [this, row] { emit chosen(row->entry()); };
    connect(row, &HistoryRow::reached, this, say);
    connect(row, &QAbstractButton::clicked, this, say);
    rows_.push_back(row);
}

// The focus goes with the chosen entry, before a row that is left over would hand it on.
void HistoryList::show(const std::vector<HistoryEntry>& entries, const QString& entry) {
    const bool focused = std::ranges::any_of(rows_, &QWidget::hasFocus);
    shown_ = entries.size();
    while (rows_.size() < shown_) addRow();
    for (std::size_t i = 0; i < shown_; ++i) rows_[i]->show(entries[shown_ - 1 - i]);
    choose(entry);
    if (focused) focusChosen();
    for (std::size_t i = shown_; i < rows_.size(); ++i) rows_[i]->setVisible(false);
    caption_->setVisible(shown_ > 0);
    scroll_->setVisible(shown_ > 0);
    empty_->setVisible(shown_ == 0);
}

void HistoryList::choose(const QString& entry) {
    for (HistoryRow* row : rows_) row->setChosen(row->entry() == entry);
    if (const HistoryRow* row = chosenRow()) scroll_->keepInSight(row);
}

void HistoryList::focusChosen() {
    if (HistoryRow* row = chosenRow()) row->setFocus();
}

HistoryRow* HistoryList::chosenRow() const {
    const auto row = std::ranges::find_if(rows_, &HistoryRow::isChecked);
    return row == rows_.end() ? nullptr : *row;
}

std::vector<RowButton*> HistoryList::rows() const {
    return {rows_.begin(), rows_.begin() + static_cast<std::ptrdiff_t>(shown_)};
}

void HistoryList::reached(RowButton* row) { scroll_->keepInSight(row); }

}  // namespace hedr
