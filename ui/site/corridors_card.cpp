#include "ui/site/corridors_card.h"

#include <QHBoxLayout>
#include <QVBoxLayout>
#include <cmath>

#include "core/geometry/angle.h"
#include "ui/format.h"
#include "ui/style_sheet.h"

namespace hedr {
namespace {

constexpr int kWidth_px = 332;

// Corridors are the same after every quarter turn.
double folded(double direction_rad) {
    constexpr double kFold_rad = 0.5 * kPi;
    return direction_rad - kFold_rad * std::floor(direction_rad / kFold_rad);
}

}  // namespace

CorridorsCard::CorridorsCard(QWidget* parent)
    : Card(parent),
      direction_(new QLabel(this)),
      advice_(new QLabel(this)),
      bar_(new QProgressBar(this)),
      plan_(new QPushButton(tr("From the plan"), this)),
      none_(new QPushButton(tr("Tell none"), this)) {
    setAccessibleName(tr("Corridors"));
    setFixedWidth(kWidth_px);
    direction_->setProperty("role", QStringLiteral("value"));
    advice_->setProperty("role", QStringLiteral("text"));
    advice_->setWordWrap(true);
    bar_->setTextVisible(false);
    bar_->setFixedHeight(8);
    plan_->setToolTip(tr("Find the direction of the plan's walls again"));
    none_->setToolTip(tr("Let the estimators learn the direction while the robot drives"));
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(8);
    buttons->addWidget(plan_, 1);
    buttons->addWidget(none_, 1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(20, 16, 20, 20);
    column->setSpacing(8);
    column->addWidget(direction_);
    column->addWidget(advice_);
    column->addWidget(bar_);
    column->addSpacing(8);
    column->addLayout(buttons);
    connect(plan_, &QPushButton::clicked, this, &CorridorsCard::planWished);
    connect(none_, &QPushButton::clicked, this, &CorridorsCard::noneWished);
    setProgress(std::nullopt);
    setVisible(false);
}

void CorridorsCard::setTheme(const Theme& theme) {
    Card::setTheme(theme);
    for (QLabel* label : {direction_, advice_}) label->setStyleSheet(formSheet(theme));
    bar_->setStyleSheet(formSheet(theme));
    const QString narrow = QStringLiteral("QPushButton { padding: 0 8px; font-size: 15px; }");
    for (QPushButton* button : {plan_, none_}) button->setStyleSheet(buttonSheet(theme) + narrow);
}

void CorridorsCard::show(std::optional<double> direction_rad, const QString& advice) {
    direction_->setText(direction_rad ? tr("At %1").arg(formatAngle(folded(*direction_rad)))
                                      : tr("Not told"));
    none_->setEnabled(direction_rad.has_value());
    advice_->setText(advice);
}

void CorridorsCard::setProgress(std::optional<double> share) {
    bar_->setVisible(share.has_value());
    if (share) bar_->setValue(qBound(0, qRound(100.0 * *share), 100));
}

void CorridorsCard::offerPlan(bool offered) { plan_->setEnabled(offered); }

}  // namespace hedr
