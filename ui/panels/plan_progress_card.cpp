#include "ui/panels/plan_progress_card.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "ui/style_sheet.h"

namespace hedr {

PlanProgressCard::PlanProgressCard(const QString& work, QWidget* parent)
    : Card(parent),
      work_(work),
      label_(new QLabel(this)),
      bar_(new QProgressBar(this)),
      cancel_(new QPushButton(tr("Cancel"), this)) {
    setAccessibleName(work);
    label_->setProperty("role", QStringLiteral("text"));
    bar_->setTextVisible(false);
    bar_->setFixedHeight(8);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(20, 12, 12, 12);
    row->setSpacing(20);
    auto* column = new QVBoxLayout;
    column->setSpacing(8);
    column->addWidget(label_);
    column->addWidget(bar_);
    row->addLayout(column, 1);
    row->addWidget(cancel_);
    connect(cancel_, &QPushButton::clicked, this, &PlanProgressCard::canceled);
    setVisible(false);
}

void PlanProgressCard::setTheme(const Theme& theme) {
    Card::setTheme(theme);
    label_->setStyleSheet(formSheet(theme));
    bar_->setStyleSheet(formSheet(theme));
    cancel_->setStyleSheet(buttonSheet(theme));
}

void PlanProgressCard::setProgress(double progress) {
    const int percent = qBound(0, qRound(100.0 * progress), 100);
    label_->setText(tr("%1… %2 %").arg(work_).arg(percent));
    bar_->setValue(percent);
}

}  // namespace hedr
