#include "ui/site/move_panel.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "core/geometry/angle.h"
#include "ui/format.h"
#include "ui/style_sheet.h"

namespace hedr {

MovePanel::MovePanel(QWidget* parent)
    : QWidget(parent),
      rotation_(new QLabel(this)),
      scale_(new QLabel(this)),
      left_(new QPushButton(tr("Turn left"), this)),
      right_(new QPushButton(tr("Turn right"), this)) {
    rotation_->setProperty("role", QStringLiteral("value"));
    scale_->setProperty("role", QStringLiteral("text"));
    left_->setToolTip(tr("A quarter turn counter-clockwise"));
    right_->setToolTip(tr("A quarter turn clockwise"));
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    row->addWidget(left_);
    row->addWidget(right_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    column->addWidget(rotation_);
    column->addWidget(scale_);
    column->addLayout(row);
    connect(left_, &QPushButton::clicked, this, [this] { emit turnWished(kPi / 2.0); });
    connect(right_, &QPushButton::clicked, this, [this] { emit turnWished(-kPi / 2.0); });
}

void MovePanel::setTheme(const Theme& theme) {
    for (QLabel* label : {rotation_, scale_}) label->setStyleSheet(formSheet(theme));
    const QString narrow = QStringLiteral("QPushButton { padding: 0 8px; font-size: 15px; }");
    for (QPushButton* button : {left_, right_}) button->setStyleSheet(buttonSheet(theme) + narrow);
}

void MovePanel::show(const PlanPlacement& placement) {
    rotation_->setText(
        tr("turned by %1").arg(formatAngle(wrapAngle(placement.origin.heading_rad))));
    scale_->setText(tr("One pixel is %1.").arg(formatResolution(placement.resolution_m)));
}

}  // namespace hedr
