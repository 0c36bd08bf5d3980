#include "ui/calibration/parameter_words.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/geometry/angle.h"

namespace hedr {
namespace {

constexpr double kDegrees = degFromRad(1.0);

struct ParameterRow {
    std::string_view key;
    const char* name;
    const char* unit;
    double per_si;
};

constexpr std::array kParameterRows{
    ParameterRow{"wheelbase_m", QT_TRANSLATE_NOOP("ParameterWords", "Wheelbase"), "m", 1.0},
    ParameterRow{"left_wheel_diameter_m", QT_TRANSLATE_NOOP("ParameterWords", "Left wheel"), "mm",
                 1e3},
    ParameterRow{"right_wheel_diameter_m", QT_TRANSLATE_NOOP("ParameterWords", "Right wheel"), "mm",
                 1e3},
    ParameterRow{"ticks_per_revolution", QT_TRANSLATE_NOOP("ParameterWords", "Ticks per turn"), "",
                 1.0},
    ParameterRow{"gyro_scale", QT_TRANSLATE_NOOP("ParameterWords", "Gyro scale"), "", 1.0},
    ParameterRow{"gyro_bias_rad_s", QT_TRANSLATE_NOOP("ParameterWords", "Gyro bias"), "°/s",
                 kDegrees},
    ParameterRow{"gyro_noise_rad_s_sqrthz", QT_TRANSLATE_NOOP("ParameterWords", "Gyro noise"),
                 "°/√h", kDegrees * 60.0},
    ParameterRow{"gyro_bias_walk_rad_s_sqrts",
                 QT_TRANSLATE_NOOP("ParameterWords", "Wander of the bias"), "°/h/√h",
                 kDegrees * 3600.0 * 60.0},
    ParameterRow{"gyro_drift_c1_rad_s",
                 QT_TRANSLATE_NOOP("ParameterWords", "Change while warming up"), "°/s", kDegrees},
    ParameterRow{"gyro_drift_c2_rad_s", QT_TRANSLATE_NOOP("ParameterWords", "Bias when cold"),
                 "°/s", kDegrees},
    ParameterRow{"gyro_drift_time_s", QT_TRANSLATE_NOOP("ParameterWords", "Time constant (63 %)"),
                 "min", 1.0 / 60.0},
    ParameterRow{"mag_centre_x", QT_TRANSLATE_NOOP("ParameterWords", "Compass centre x"), "", 1.0},
    ParameterRow{"mag_centre_y", QT_TRANSLATE_NOOP("ParameterWords", "Compass centre y"), "", 1.0},
    ParameterRow{"mag_range_x", QT_TRANSLATE_NOOP("ParameterWords", "Compass range x"), "", 1.0},
    ParameterRow{"mag_range_y", QT_TRANSLATE_NOOP("ParameterWords", "Compass range y"), "", 1.0},
    ParameterRow{"mag_correlation", QT_TRANSLATE_NOOP("ParameterWords", "Compass correlation"), "",
                 1.0},
    ParameterRow{"max_speed_m_s", QT_TRANSLATE_NOOP("ParameterWords", "Top speed"), "m/s", 1.0},
};

QString parameterText(const char* text) {
    return QCoreApplication::translate("ParameterWords", text);
}

// None while the samples do not tell.
std::optional<double> marginOf(const Estimate& estimate) {
    const bool known = std::isfinite(estimate.value) && estimate.standard_error >= 0.0 &&
                       estimate.degrees_of_freedom > 0.0;
    const double margin = known ? estimate.margin() : 0.0;
    return known && std::isfinite(margin) ? std::optional(margin) : std::nullopt;
}

QString marginText(const Estimate& estimate, const ReadUnit& unit, int decimals) {
    const auto text = [&](double si) { return plainNumber(si * unit.per_si, decimals); };
    if (estimate.lopsided == 0.0) return QStringLiteral("± ") + text(estimate.margin());
    const Interval interval = estimate.interval();
    return QStringLiteral("+%1 −%2").arg(text(interval.high - estimate.value),
                                         text(estimate.value - interval.low));
}

// Where there is no margin, of the value itself.
int decimalsOf(const FoundParameter& found, double margin, const ReadUnit& unit) {
    if (margin > 0.0) return decimalsFor(margin * unit.per_si, 2);
    return decimalsFor(found.was.value_or(found.now.value) * unit.per_si, 4);
}

}  // namespace

ParameterWords parameterWords(std::string_view key) {
    const auto row = std::ranges::find(kParameterRows, key, &ParameterRow::key);
    if (row == kParameterRows.end()) {
        return {QString::fromUtf8(key.data(), static_cast<qsizetype>(key.size())), {}};
    }
    return {parameterText(row->name), {QString::fromUtf8(row->unit), row->per_si}};
}

FoundText foundText(const FoundParameter& found) {
    const auto [name, unit] = parameterWords(found.key);
    const std::optional<double> margin = marginOf(found.now);
    const double now = found.now.value * unit.per_si;
    const int decimals = decimalsOf(found, margin.value_or(0.0), unit);
    FoundText text{.name = name};
    text.value = margin ? withUnit(plainNumber(now, decimals), unit) : QStringLiteral("–");
    text.margin =
        margin ? marginText(found.now, unit, decimals) : parameterText("not measured yet");
    if (found.follows) text.margin = parameterText("goes with the others");
    text.was = parameterText("was not set");
    if (found.was) {
        const QString was = withUnit(plainNumber(*found.was * unit.per_si, decimals), unit);
        text.was = parameterText(found.stays ? "stays at %1" : "was %1").arg(was);
    }
    return text;
}

}  // namespace hedr
