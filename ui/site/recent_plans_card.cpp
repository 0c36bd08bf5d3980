#include "ui/site/recent_plans_card.h"

#include <QFileInfo>

#include "ui/site/plan_row.h"
#include "ui/style_sheet.h"

namespace hedr {

RecentPlansCard::RecentPlansCard(QWidget* parent)
    : RowListCard(parent),
      title_(new QLabel(tr("Open a floor plan"), this)),
      column_(new QVBoxLayout) {
    setAccessibleName(title_->text());
    title_->setProperty("role", QStringLiteral("title"));
    title_->setContentsMargins(8, 0, 0, 8);
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(12, 20, 12, 12);
    all->setSpacing(0);
    all->addWidget(title_);
    all->addLayout(column_);
    column_->setSpacing(2);
    setVisible(false);
}

void RecentPlansCard::setTheme(const Theme& theme) {
    Card::setTheme(theme);
    title_->setStyleSheet(formSheet(theme));
    for (PlanRow* row : rows_) row->setTheme(theme);
}

void RecentPlansCard::setFiles(const QStringList& files) {
    qDeleteAll(rows_);
    rows_.clear();
    files_ = files;
    for (const QString& file : files) {
        PlanRow* row =
            addRow(QStringLiteral("plan"), QFileInfo(file).fileName(), QFileInfo(file).path());
        connect(row, &QAbstractButton::clicked, this, [this, file] { emit fileChosen(file); });
    }
    PlanRow* another = addRow(QStringLiteral("folder"), tr("Open another…"), {});
    connect(another, &QAbstractButton::clicked, this, &RecentPlansCard::anotherWished);
    fitToRows();
}

PlanRow* RecentPlansCard::addRow(const QString& icon, const QString& name, const QString& detail) {
    auto* row = new PlanRow(icon, name, detail, this);
    row->setTheme(theme());
    row->setVisible(true);
    column_->addWidget(row);
    rows_.push_back(row);
    return row;
}

void RecentPlansCard::setGlance(const QString& file, const PlanGlance& glance) {
    const qsizetype index = files_.indexOf(file);
    if (index < 0) return;
    rows_.at(static_cast<std::size_t>(index))->setPicture(glance.picture);
}

void RecentPlansCard::fitToRows() {
    title_->ensurePolished();
    layout()->activate();
    resize(sizeHint());
}

std::vector<RowButton*> RecentPlansCard::rows() const { return {rows_.begin(), rows_.end()}; }

}  // namespace hedr
