#include "ui/calibration/result_card.h"

#include <algorithm>
#include <cmath>

#include "ui/calibration/calibration_sheet.h"
#include "ui/calibration/result_rows.h"
#include "ui/calibration/verdict_box.h"

namespace hedr {
namespace {

// Shows the values in as many rows; the rows stay, so that nothing flickers.
template <class Row, class Value>
void showRows(std::vector<Row*>& rows, const std::vector<Value>& values, QVBoxLayout& column,
              const Theme& theme, bool roomy) {
    while (rows.size() < values.size()) {
        rows.push_back(new Row(column.parentWidget()));
        rows.back()->setTheme(theme);
        rows.back()->setRoomy(roomy);
        column.addWidget(rows.back());
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (i < values.size()) {
            rows[i]->show(values[i]);
        } else {
            rows[i]->setVisible(false);
        }
    }
}

QString remarksOf(const Calibration& calibration) {
    QStringList remarks;
    for (const std::string& remark : calibration.remarks) remarks << QString::fromStdString(remark);
    return remarks.join(u'\n');
}

bool isFinal(const Calibration& calibration) {
    return calibration.verdict != Verdict::kNotProven && calibration.progress.share >= 1.0;
}

}  // namespace

ResultCard::ResultCard(QWidget* parent)
    : Card(parent),
      caption_(new QLabel(this)),
      rows_area_(new QWidget),
      rows_column_(new QVBoxLayout(rows_area_)),
      found_column_(new QVBoxLayout),
      figures_column_(new QVBoxLayout),
      line_(new QFrame(rows_area_)),
      proof_title_(new QLabel(rows_area_)),
      proof_(new ProofBars(rows_area_)),
      remarks_(new QLabel(rows_area_)),
      scroll_(new ScrollBox(rows_area_, this)),
      verdict_(new VerdictBox(this)) {
    setAccessibleName(tr("Result"));
    scroll_->setAccessibleName(tr("Values"));
    line_->setFixedHeight(1);
    line_->setObjectName(QStringLiteral("line"));
    caption_->setIndent(ScrollBox::kReach_px);
    caption_->setProperty("role", QStringLiteral("caption"));
    for (QLabel* label : {proof_title_, remarks_}) {
        label->setProperty("role", QStringLiteral("detail"));
        label->setTextFormat(Qt::PlainText);
        label->setWordWrap(true);
    }
    // The figures are details: what decides, and what the operator should know, comes before them.
    for (QVBoxLayout* column : {found_column_, figures_column_}) column->setSpacing(0);
    rows_column_->addLayout(found_column_);
    rows_column_->addWidget(line_);
    auto* proof = new QVBoxLayout;
    proof->setSpacing(8);
    proof->addWidget(proof_title_);
    proof->addWidget(proof_);
    rows_column_->addLayout(proof);
    rows_column_->addWidget(remarks_);
    rows_column_->addLayout(figures_column_);
    rows_column_->addStretch();
    auto* below = new QVBoxLayout;
    below->setContentsMargins(ScrollBox::kReach_px, 8, ScrollBox::kReach_px, 0);
    below->addWidget(verdict_);
    auto* column = new QVBoxLayout(this);
    column->setSpacing(8);
    column->addWidget(caption_);
    column->addWidget(scroll_, 1);
    column->addLayout(below);
}

void ResultCard::setTheme(const Theme& theme) {
    Card::setTheme(theme);
    setStyleSheet(calibrationSheet(theme));
    line_->setStyleSheet(QStringLiteral("border: none; background: ") + theme.hairline.name());
    for (FoundRow* row : found_) row->setTheme(theme);
    for (FigureRow* row : figures_) row->setTheme(theme);
    proof_->setTheme(theme);
    verdict_->setTheme(theme);
}

void ResultCard::setRoomy(bool roomy) {
    const int padding_px = roomy ? 24 : 16;
    const int side_px = padding_px - ScrollBox::kReach_px;
    layout()->setContentsMargins(side_px, padding_px, side_px, padding_px);
    rows_column_->setSpacing(roomy ? 16 : 8);
    roomy_ = roomy;
    for (FoundRow* row : found_) row->setRoomy(roomy);
    for (FigureRow* row : figures_) row->setRoomy(roomy);
    proof_->setRoomy(roomy);
}

void ResultCard::resizeEvent(QResizeEvent* event) {
    Card::resizeEvent(event);
    alignColumns();
}

// The margins stand below one another, right of all values but the overlong.
void ResultCard::alignColumns() {
    constexpr double kGrid_px = 8.0;
    constexpr double kBetween_px = 16.0;
    constexpr double kLongest = 0.56;  // of the width
    double from_px = 144.0;
    for (const FoundRow* row : found_) {
        const double wanted_px = row->valueWidth() + kBetween_px;
        if (wanted_px <= kLongest * width()) from_px = std::max(from_px, wanted_px);
    }
    from_px = std::ceil(from_px / kGrid_px) * kGrid_px;
    for (FoundRow* row : found_) row->setSecondColumn(from_px);
    for (FigureRow* row : figures_) row->setSecondColumn(from_px);
}

void ResultCard::show(const Calibration& calibration) {
    caption_->setText(isFinal(calibration) ? tr("RESULT") : tr("RESULT SO FAR"));
    showRows(found_, calibration.found, *found_column_, theme(), roomy_);
    showRows(figures_, calibration.figures, *figures_column_, theme(), roomy_);
    alignColumns();
    const VerdictText verdict = verdictText(calibration);
    proof_->show(calibration.proof, verdict.tone);
    proof_title_->setText(proof_->accessibleName());
    remarks_->setText(remarksOf(calibration));
    remarks_->setVisible(!calibration.remarks.empty());
    verdict_->show(verdict);
}

}  // namespace hedr
