#include "ui/calibration/procedure_list.h"

#include "ui/calibration/calibration_sheet.h"
#include "ui/calibration/procedure_row.h"

namespace hedr {
namespace {

constexpr int kRowInset_px = 8;  // of the words in a row

}  // namespace

ProcedureList::ProcedureList(QWidget* parent)
    : RowListCard(parent),
      title_(new QLabel(tr("Calibrate"), this)),
      rows_area_(new QWidget),
      rows_column_(new QVBoxLayout(rows_area_)),
      scroll_(new ScrollBox(rows_area_, this)) {
    rows_column_->setSpacing(0);
    rows_column_->addStretch();
    setAccessibleName(title_->text());
    title_->setProperty("role", QStringLiteral("title"));
    title_->setContentsMargins(kRowInset_px + ScrollBox::kReach_px, 0, 0, 0);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 20, 8, 12);
    column->setSpacing(8);
    column->addWidget(title_);
    column->addWidget(scroll_);
    setVisible(false);
}

void ProcedureList::setTheme(const Theme& theme) {
    Card::setTheme(theme);
    setStyleSheet(calibrationSheet(theme));
    for (ProcedureRow* row : rows_) row->setTheme(theme);
}

void ProcedureList::show(const std::vector<ProcedureEntry>& entries) {
    while (rows_.size() < entries.size()) {
        auto* row = new ProcedureRow(rows_area_);
        row->setTheme(theme());
        rows_column_->insertWidget(static_cast<int>(rows_.size()), row);
        connect(row, &QAbstractButton::clicked, this,
                [this, row] { emit chosen(row->procedure()); });
        rows_.push_back(row);
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        if (i < entries.size()) {
            rows_[i]->show(entries[i]);
        } else {
            rows_[i]->setVisible(false);
        }
    }
    setVisible(true);
}

std::vector<RowButton*> ProcedureList::rows() const { return {rows_.begin(), rows_.end()}; }

void ProcedureList::reached(RowButton* row) { scroll_->keepInSight(row); }

}  // namespace hedr
