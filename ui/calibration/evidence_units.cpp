#include "ui/calibration/evidence_units.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/geometry/angle.h"

namespace hedr {
namespace {

constexpr double kDegree = degFromRad(1.0);
constexpr double kMinute = 60.0;
constexpr double kHour = 3600.0;

struct UnitRow {
    std::string_view si;
    const char* read;
    double per_si;
    double from;  // fits sizes from so many of it on; the rows of a unit go from large to small
};

// The last row of a unit takes what is left. 0.0017 °/s is a tenth of a degree a minute.
constexpr std::array kUnitRows{
    UnitRow{"m", "m", 1.0, 0.1},
    UnitRow{"m", "mm", 1e3, 0.0},
    UnitRow{"rad", "°", kDegree, 0.0},
    UnitRow{"rad/s", "°/s", kDegree, 0.1},
    UnitRow{"rad/s", "°/min", kDegree* kMinute, 0.1},
    UnitRow{"rad/s", "°/h", kDegree* kHour, 0.0},
    UnitRow{"rad/s²", "°/s per min", kDegree* kMinute, 0.0},
    UnitRow{"rad/m", "°/m", kDegree, 0.0},
    UnitRow{"s", "h", 1.0 / kHour, 3.0},
    UnitRow{"s", "min", 1.0 / kMinute, 2.0},
    UnitRow{"s", "s", 1.0, 0.1},
    UnitRow{"s", "ms", 1e3, 0.0},
    UnitRow{"rad/s/sqrt(Hz)", "°/√h", kDegree* kMinute, 0.0},
    UnitRow{"rad/sqrt(s)", "°/√h", kDegree* kMinute, 0.0},
    UnitRow{"rad/s/sqrt(s)", "°/h/√h", kDegree* kHour* kMinute, 0.0},
};

QString unitText(const char* text) { return QCoreApplication::translate("EvidenceUnits", text); }

// Two digits of what is not known, three where that is not told; a count has none.
int figureDecimals(const EvidenceFigure& figure, const ReadUnit& unit) {
    const bool is_count = figure.unit.empty() && figure.value == std::round(figure.value);
    if (is_count && !figure.interval) return 0;
    if (!figure.interval) return decimalsFor(figure.value * unit.per_si, 3);
    const double half = 0.5 * (figure.interval->high - figure.interval->low);
    return decimalsFor(half * unit.per_si, 2);
}

}  // namespace

ReadUnit readUnit(std::string_view si_unit, double size_si) {
    const UnitRow* fitting = nullptr;
    for (const UnitRow& row : kUnitRows) {
        if (row.si != si_unit) continue;
        fitting = &row;
        if (std::abs(size_si) * row.per_si >= row.from) break;
    }
    if (fitting) return {QString::fromUtf8(fitting->read), fitting->per_si};
    return {QString::fromUtf8(si_unit.data(), static_cast<qsizetype>(si_unit.size())), 1.0};
}

int decimalsFor(double number, int significant) {
    constexpr int kMost = 9;
    if (!std::isfinite(number) || number == 0.0) return 0;
    // As it is after rounding: 0.0996 with two digits is 0.10.
    const QString rounded = QString::number(std::abs(number), 'e', significant - 1);
    const int exponent = rounded.mid(rounded.indexOf(u'e') + 1).toInt();
    return std::clamp(significant - 1 - exponent, 0, kMost);
}

QString plainNumber(double number, int decimals) {
    if (!std::isfinite(number)) return QStringLiteral("–");
    QString text = QString::number(std::abs(number), 'f', decimals);
    const bool zero = text.count(u'0') + text.count(u'.') == text.size();
    if (number < 0.0 && !zero) text.prepend(QChar(u'\u2212'));
    return text;
}

QString withUnit(const QString& number, const ReadUnit& unit) {
    if (unit.name.isEmpty()) return number;
    if (unit.name == QStringLiteral("°")) return number + unit.name;
    return number + QChar(u'\u00A0') + unit.name;
}

QString figureValue(const EvidenceFigure& figure) {
    const ReadUnit unit = readUnit(figure.unit, figure.value);
    return withUnit(plainNumber(figure.value * unit.per_si, figureDecimals(figure, unit)), unit);
}

QString figureInterval(const EvidenceFigure& figure) {
    if (!figure.interval) return {};
    const ReadUnit unit = readUnit(figure.unit, figure.value);
    const int decimals = figureDecimals(figure, unit);
    return unitText("%1 to %2")
        .arg(plainNumber(figure.interval->low * unit.per_si, decimals),
             plainNumber(figure.interval->high * unit.per_si, decimals));
}

QString errorValue(double error_si, const std::string& si_unit, double size_si) {
    const ReadUnit unit = readUnit(si_unit, size_si);
    const int decimals = decimalsFor(size_si * unit.per_si, 3);
    return withUnit(plainNumber(error_si * unit.per_si, decimals), unit);
}

}  // namespace hedr
