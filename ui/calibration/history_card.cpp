#include "ui/calibration/history_card.h"

#include <QCoreApplication>
#include <QScrollBar>
#include <algorithm>
#include <limits>

#include "core/robot/vehicle_edit.h"
#include "core/text/clean_text.h"
#include "ui/calibration/calibration_sheet.h"
#include "ui/calibration/history_row.h"
#include "ui/calibration/parameter_words.h"
#include "ui/calibration/verdict_box.h"
#include "ui/error_text.h"

namespace hedr {
namespace {

constexpr std::size_t kLongestSentence = 1000;  // bytes

QString lineWords(const char* text) { return QCoreApplication::translate("HistoryLine", text); }

struct LineNumbers {
    std::optional<double> before{};
    std::optional<double> found{};
    std::optional<double> now{};
};

HistoryLine lineOf(const LineNumbers& numbers, const ParameterWords& words, int decimals) {
    const ReadUnit& unit = words.unit;
    const auto text = [&](std::optional<double> si) {
        constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
        return plainNumber(si.value_or(kUnknown) * unit.per_si, decimals);
    };
    return {.name = unit.name.isEmpty() ? words.name : words.name + ", " + unit.name,
            .before = text(numbers.before),
            .found = text(numbers.found),
            .now = text(numbers.now)};
}

// A key that has no name is shown as it is.
ParameterWords wordsOf(const std::string& key) {
    const auto [name, unit] = parameterWords(key);
    return {shownWords(name.toStdString()), unit};
}

// As on the page of a calibration: two digits of the margin, and where there is none, of the value.
int decimalsOf(const RecordedParameter& found, const ReadUnit& unit) {
    const double margin = found.now.margin() * unit.per_si;
    if (margin > 0.0) return decimalsFor(margin, 2);
    return decimalsFor(found.was.value_or(found.now.value) * unit.per_si, 4);
}

HistoryLine lineOf(const RecordedParameter& found, std::optional<double> now) {
    const ParameterWords words = wordsOf(found.key);
    HistoryLine line =
        lineOf({found.was, found.now.value, now}, words, decimalsOf(found, words.unit));
    const FoundParameter same{
        .key = found.key, .was = found.was, .now = found.now, .follows = found.follows};
    line.note = foundText(same).margin;
    if (found.stays) line.note += lineWords(", the file kept what it had");
    return line;
}

// Four digits, or more, so that the difference can be seen.
HistoryLine lineOf(const NumberChange& change, std::optional<double> now) {
    const ParameterWords words = wordsOf(change.key);
    const double after = change.after.value_or(change.before.value_or(0.0));
    const double difference = after - change.before.value_or(after);
    const int decimals = std::max(decimalsFor(after * words.unit.per_si, 4),
                                  decimalsFor(difference * words.unit.per_si, 2));
    return lineOf({change.before, change.after, now}, words, decimals);
}

QString remarksOf(const CalibrationRecord& record) {
    QStringList remarks;
    for (const std::string& remark : record.remarks)
        remarks << shownWords(remark, kLongestSentence);
    return remarks.join(u'\n');
}

QString factsOf(const CalibrationRecord& record) {
    QStringList facts{shownWords(record.robot), shownWords(record.surface)};
    if (record.temperature_c)
        facts << withUnit(plainNumber(*record.temperature_c, 1), {QStringLiteral("°C")});
    facts << shownWords(record.program_version);
    facts << (record.raw.empty()       ? lineWords("no raw data")
              : record.raw.size() == 1 ? lineWords("raw data: 1 file")
                                       : lineWords("raw data: %1 files").arg(record.raw.size()));
    // Where the line breaks, the dot stays with what is before it.
    return listed(facts).replace(QStringLiteral(" ·"), QStringLiteral("\u00A0·"));
}

QString sentenceCase(QString words) {
    if (!words.isEmpty()) words[0] = words[0].toUpper();
    return words;
}

QString proofOf(const CalibrationRecord& record) {
    if (!record.proof || record.proof->parts == 0) return {};
    const Proof& proof = *record.proof;
    const std::string unit = cleanText(proof.unit);
    const double most = std::max(proof.before, proof.after);
    return lineWords("%1, held out: was %2, then %3")
        .arg(sentenceCase(shownWords(proof.what)), errorValue(proof.before, unit, most),
             errorValue(proof.after, unit, most));
}

}  // namespace

std::vector<HistoryLine> historyLines(const CalibrationRecord& record,
                                      const std::optional<Vehicle>& now) {
    const auto in_file = [&](const std::string& key) {
        return now ? vehicleNumber(*now, key) : std::nullopt;
    };
    std::vector<HistoryLine> lines;
    for (const RecordedParameter& found : record.found)
        lines.push_back(lineOf(found, in_file(found.key)));
    if (!lines.empty()) return lines;
    const auto before = parseVehicle(record.vehicle_before, {});
    const auto after = parseVehicle(record.vehicle_after, {});
    if (!before || !after) return lines;
    for (const NumberChange& change : numberChanges(*before, *after))
        lines.push_back(lineOf(change, in_file(change.key)));
    return lines;
}

HistoryCard::HistoryCard(QWidget* parent)
    : Card(parent),
      caption_(new QLabel(this)),
      title_(new QLabel(this)),
      rows_area_(new QWidget),
      rows_column_(new QVBoxLayout(rows_area_)),
      grid_(new QGridLayout),
      remarks_(new QLabel(rows_area_)),
      facts_(new QLabel(rows_area_)),
      scroll_(new ScrollBox(rows_area_, this)),
      verdict_(new VerdictBox(this)) {
    setAccessibleName(tr("Entry"));
    scroll_->setAccessibleName(tr("Values"));
    caption_->setProperty("role", QStringLiteral("caption"));
    title_->setProperty("role", QStringLiteral("title"));
    remarks_->setProperty("role", QStringLiteral("words"));
    facts_->setProperty("role", QStringLiteral("detail"));
    for (QLabel* label : {caption_, title_, remarks_, facts_}) {
        label->setTextFormat(Qt::PlainText);
        label->setWordWrap(true);
    }
    layOut();
    addRow();
    const Row& heads = rows_.front();
    heads.before->setText(tr("before"));
    heads.now->setText(tr("file now"));
    for (QLabel* label : {heads.before, heads.found, heads.now})
        label->setProperty("role", QStringLiteral("caption"));
}

void HistoryCard::layOut() {
    grid_->setHorizontalSpacing(16);
    grid_->setVerticalSpacing(2);
    grid_->setColumnStretch(0, 1);
    rows_column_->setSpacing(16);
    rows_column_->addLayout(grid_);
    rows_column_->addWidget(remarks_);
    rows_column_->addWidget(facts_);
    rows_column_->addStretch();
    auto* head = new QVBoxLayout;
    head->setContentsMargins(ScrollBox::kReach_px, 0, ScrollBox::kReach_px, 0);
    head->setSpacing(4);
    head->addWidget(title_);
    head->addWidget(caption_);
    auto* below = new QVBoxLayout;
    below->setContentsMargins(ScrollBox::kReach_px, 8, ScrollBox::kReach_px, 0);
    below->addWidget(verdict_);
    auto* column = new QVBoxLayout(this);
    column->setSpacing(8);
    column->addLayout(head);
    column->addWidget(scroll_, 1);
    column->addLayout(below);
}

void HistoryCard::setTheme(const Theme& theme) {
    Card::setTheme(theme);
    setStyleSheet(calibrationSheet(theme));
    verdict_->setTheme(theme);
}

void HistoryCard::setRoomy(bool roomy) {
    const int padding_px = roomy ? 24 : 16;
    const int side_px = padding_px - ScrollBox::kReach_px;
    layout()->setContentsMargins(side_px, padding_px, side_px, padding_px);
    grid_->setHorizontalSpacing(roomy ? 32 : 16);
}

void HistoryCard::Row::setVisible(bool visible) const {
    for (QLabel* label : {name, before, found, now}) label->setVisible(visible);
    note->setVisible(visible && !note->text().isEmpty());
}

void HistoryCard::addRow() {
    const Row row{new QLabel(rows_area_), new QLabel(rows_area_), new QLabel(rows_area_),
                  new QLabel(rows_area_), new QLabel(rows_area_)};
    const int values = 2 * static_cast<int>(rows_.size());
    int at = 0;
    for (QLabel* label : {row.name, row.before, row.found, row.now}) {
        label->setProperty("role", QStringLiteral("text"));
        label->setAlignment((at == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignTop);
        label->setContentsMargins(0, 8, 0, 0);
        grid_->addWidget(label, values, at++);
    }
    row.name->setWordWrap(true);
    row.note->setAlignment(Qt::AlignRight);
    row.note->setWordWrap(true);
    row.note->setProperty("role", QStringLiteral("caption"));
    grid_->addWidget(row.note, values + 1, 0, 1, 3);
    for (QLabel* label : {row.name, row.before, row.found, row.now, row.note})
        label->setTextFormat(Qt::PlainText);
    rows_.push_back(row);
}

void HistoryCard::showLines(const std::vector<HistoryLine>& lines, const QString& found) {
    while (rows_.size() <= lines.size()) addRow();
    rows_.front().setVisible(!lines.empty());
    for (std::size_t i = 1; i < rows_.size(); ++i) {
        const Row& row = rows_[i];
        const HistoryLine line = i <= lines.size() ? lines[i - 1] : HistoryLine{};
        row.name->setText(line.name);
        row.before->setText(line.before);
        row.found->setText(line.found);
        row.now->setText(line.now);
        row.note->setText(line.note);
        const QString noted = line.note.isEmpty() ? line.found : line.found + u' ' + line.note;
        row.name->setAccessibleDescription(
            tr("before %1, %2 %3, file now %4").arg(line.before, found, noted, line.now));
        row.setVisible(i <= lines.size());
    }
}

void HistoryCard::showRecord(const CalibrationRecord& record, const std::optional<Vehicle>& now) {
    const bool changed_only = record.found.empty();
    rows_.front().found->setText(changed_only ? tr("after") : tr("found ± 95 %"));
    showLines(historyLines(record, now), changed_only ? tr("after") : tr("found"));
    remarks_->setText(remarksOf(record));
    remarks_->setVisible(!record.remarks.empty());
    facts_->setText(factsOf(record));
    facts_->setVisible(true);
}

void HistoryCard::showDamage() {
    showLines({}, {});
    remarks_->setVisible(false);
    facts_->setVisible(false);
}

void HistoryCard::show(const HistoryEntry& entry, const std::optional<Vehicle>& now) {
    if (entry_ != entry.name) scroll_->verticalScrollBar()->setValue(0);
    entry_ = entry.name;
    const HistoryText text = historyText(entry);
    title_->setText(text.title);
    caption_->setText(listed({text.when, text.who}));
    caption_->setVisible(!caption_->text().isEmpty());
    setAccessibleDescription(listed({text.title, text.when, text.verdict}));
    VerdictText verdict{.word = sentenceCase(text.verdict), .tone = text.tone};
    if (entry.record) {
        showRecord(*entry.record, now);
        verdict.interval = proofOf(*entry.record);
        verdict.reason = shownWords(entry.record->reason, kLongestSentence);
    } else {
        showDamage();
        verdict.reason =
            shownWords(errorText(entry.record.error()).toStdString(), kLongestSentence);
    }
    verdict_->show(verdict);
    setVisible(true);
}

}  // namespace hedr
