#include "ui/site/align_card.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "ui/site/choices_panel.h"
#include "ui/site/distance_panel.h"
#include "ui/site/move_panel.h"
#include "ui/site/points_panel.h"
#include "ui/style_sheet.h"

namespace hedr {
namespace {

constexpr int kWidth_px = 332;

}  // namespace

AlignCard::AlignCard(QWidget* parent)
    : Card(parent),
      points_(new PointsPanel(this)),
      distance_(new DistancePanel(this)),
      hand_(new MovePanel(this)),
      choices_(new ChoicesPanel(this)),
      straighten_(new QPushButton(tr("Straighten a photo…"), this)) {
    setAccessibleName(tr("Align the plan"));
    setFixedWidth(kWidth_px);
    auto* tabs = new QHBoxLayout;
    tabs->setSpacing(0);
    for (const AlignMethodEntry& entry : alignMethods()) {
        auto* tab = new QPushButton(entry.name, this);
        tab->setCheckable(true);
        tabs->addWidget(tab);
        tabs_[entry.method] = tab;
        connect(tab, &QPushButton::clicked, this,
                [this, method = entry.method] { emit methodChosen(method); });
    }
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(20, 12, 20, 20);
    column->setSpacing(12);
    column->addLayout(tabs);
    for (QWidget* panel : std::initializer_list<QWidget*>{points_, distance_, hand_, choices_}) {
        column->addWidget(panel);
        panel->setVisible(false);
    }
    straighten_->setToolTip(tr("For a plan that was photographed at an angle (S)"));
    column->addWidget(straighten_);
    connect(straighten_, &QPushButton::clicked, this, &AlignCard::straightenWished);
    setVisible(false);
}

void AlignCard::setTheme(const Theme& theme) {
    Card::setTheme(theme);
    for (const auto& [method, tab] : tabs_) tab->setStyleSheet(segmentSheet(theme));
    points_->setTheme(theme);
    distance_->setTheme(theme);
    hand_->setTheme(theme);
    choices_->setTheme(theme);
    straighten_->setStyleSheet(flatButtonSheet(theme) + QStringLiteral(R"(
QPushButton { text-align: center; min-height: 32px; })"));
}

void AlignCard::offerStraightening(bool offered) { straighten_->setVisible(offered); }

void AlignCard::setMethod(AlignMethod method) {
    for (const auto& [of, tab] : tabs_) tab->setChecked(of == method);
    points_->setVisible(method == AlignMethod::kPoints);
    distance_->setVisible(method == AlignMethod::kDistance);
    hand_->setVisible(method == AlignMethod::kMove);
    choices_->setVisible(method == AlignMethod::kTurn || method == AlignMethod::kTrail);
}

}  // namespace hedr
