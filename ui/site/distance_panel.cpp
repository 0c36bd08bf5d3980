#include "ui/site/distance_panel.h"

#include <QHBoxLayout>
#include <QVBoxLayout>
#include <array>
#include <cmath>

#include "ui/format.h"
#include "ui/style_sheet.h"

namespace hedr {
namespace {

struct Unit {
    const char* name;
    double length_m;
};
constexpr std::array kUnits{Unit{"mm", 1e-3}, Unit{"cm", 1e-2}, Unit{"km", 1e3}, Unit{"ft", 0.3048},
                            Unit{"m", 1.0}};

}  // namespace

std::optional<double> lengthFromText(const QString& text) {
    QString digits = text.trimmed().replace(QChar(u','), QChar(u'.'));
    double unit_m = 1.0;
    for (const Unit& unit : kUnits) {
        if (!digits.endsWith(QLatin1String(unit.name))) continue;
        digits.chop(static_cast<int>(qstrlen(unit.name)));
        unit_m = unit.length_m;
        break;
    }
    bool ok = false;
    const double length_m = unit_m * digits.trimmed().toDouble(&ok);
    constexpr double kLongest_m = 1e5;
    if (!ok || !std::isfinite(length_m) || length_m <= 0.0 || length_m > kLongest_m) return {};
    return length_m;
}

DistancePanel::DistancePanel(QWidget* parent)
    : QWidget(parent),
      length_(new QLabel(this)),
      advice_(new QLabel(this)),
      field_(new QLineEdit(this)),
      use_(new QPushButton(tr("Use"), this)) {
    length_->setProperty("role", QStringLiteral("value"));
    advice_->setProperty("role", QStringLiteral("text"));
    advice_->setWordWrap(true);
    field_->setAccessibleName(tr("Distance"));
    field_->setPlaceholderText(tr("12.5 m"));
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    row->addWidget(field_, 1);
    row->addWidget(use_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    column->addWidget(length_);
    column->addWidget(advice_);
    column->addLayout(row);
    connect(use_, &QPushButton::clicked, this, &DistancePanel::give);
    connect(field_, &QLineEdit::returnPressed, this, &DistancePanel::give);
    connect(field_, &QLineEdit::textChanged, this, [this] {
        use_->setEnabled(lengthFromText(field_->text()).has_value() && field_->isEnabled());
    });
}

void DistancePanel::setTheme(const Theme& theme) {
    for (QLabel* label : {length_, advice_}) label->setStyleSheet(formSheet(theme));
    field_->setStyleSheet(formSheet(theme));
    use_->setStyleSheet(primaryButtonSheet(theme));
}

void DistancePanel::show(const Alignment& alignment) {
    const bool both = alignment.ruler.size() == 2;
    const double length_m =
        both ? alignment.placement.resolution_m * (alignment.ruler[1] - alignment.ruler[0]).length()
             : 0.0;
    length_->setText(both ? formatDistance(length_m) : tr("No distance yet"));
    advice_->setText(
        !both ? tr("A corridor's length or a door's width on the drawing will do; "
                   "longer is better.")
        : alignment.distance_m
            ? tr("One pixel is %1.").arg(formatResolution(alignment.placement.resolution_m))
            : tr("How long is it really?"));
    const bool was_enabled = field_->isEnabled();
    field_->setEnabled(both && length_m > 0.0);
    use_->setEnabled(field_->isEnabled() && lengthFromText(field_->text()).has_value());
    if (field_->isEnabled() && !was_enabled) field_->setFocus();
}

void DistancePanel::give() {
    const auto length_m = lengthFromText(field_->text());
    if (length_m && field_->isEnabled()) emit distanceGiven(*length_m);
}

}  // namespace hedr
