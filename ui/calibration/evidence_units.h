#pragma once

#include <QString>
#include <string_view>

#include "core/calibration/evidence.h"

namespace hedr {

// The unit in which an operator reads a value.
struct ReadUnit {
    QString name{};       // "°/s"; empty: a bare number
    double per_si = 1.0;  // so many of it are one SI unit
};

// For values of about that size. A unit that is not known is shown as it is.
ReadUnit readUnit(std::string_view si_unit, double size_si);

// So many that `number` shows that many of its digits; nothing finite to count: 0.
int decimalsFor(double number, int significant);

// Never "-0" nor "nan"; a true minus.
QString plainNumber(double number, int decimals);
QString withUnit(const QString& number, const ReadUnit& unit);

// "12.4 °/min", and "11.9 to 12.9" where its interval is known.
QString figureValue(const EvidenceFigure& figure);
QString figureInterval(const EvidenceFigure& figure);

// A held-out error, "0.205 m", in the unit and with the decimals that go with its `size_si`.
QString errorValue(double error_si, const std::string& si_unit, double size_si);

}  // namespace hedr
