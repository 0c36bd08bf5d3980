#include "ui/calibration/evidence_units.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/geometry/angle.h"

namespace hedr {
namespace {

// With plain spaces, as it is typed.
std::string typed(QString text) {
    return text.replace(QChar(0x00A0), ' ').replace(QChar(0x2212), '-').toStdString();
}

std::string readAs(const char* si_unit, double value_si) {
    return typed(figureValue({.name = "", .value = value_si, .unit = si_unit}));
}

TEST(EvidenceUnits, AreThoseThatAnOperatorReads) {
    EXPECT_EQ(readAs("m", 1.2345), "1.23 m");
    EXPECT_EQ(readAs("m", 0.0123), "12.3 mm");
    EXPECT_EQ(readAs("rad", kPi), "180°");
    EXPECT_EQ(readAs("rad/s", radFromDeg(-0.5)), "-0.500 °/s");
    EXPECT_EQ(readAs("rad/s", radFromDeg(0.05)), "3.00 °/min");
    EXPECT_EQ(readAs("rad/s", radFromDeg(0.001)), "3.60 °/h");
    EXPECT_EQ(readAs("s", 0.02), "20.0 ms");
    EXPECT_EQ(readAs("s", 42.0), "42.0 s");
    EXPECT_EQ(readAs("s", 340.0), "5.67 min");
    EXPECT_EQ(readAs("s", 14400.0), "4.00 h");
    EXPECT_EQ(readAs("", 1.0041), "1.00");
    EXPECT_EQ(readAs("°C", 21.04), "21.0 °C");
    EXPECT_EQ(readAs("m", 0.0), "0 mm");
    EXPECT_EQ(readAs("m", std::numeric_limits<double>::quiet_NaN()), "– mm");
}

TEST(EvidenceUnits, AgreeWithThoseOfGyroDataSheets) {
    EXPECT_NEAR(readUnit("rad/s/sqrt(Hz)", 1.0).per_si * radFromDeg(0.005), 0.3, 1e-12);
    EXPECT_NEAR(readUnit("rad/s/sqrt(s)", 1.0).per_si * radFromDeg(1.0 / 3600.0) / 60.0, 1.0,
                1e-12);
}

TEST(EvidenceUnits, ShowTwoDigitsOfWhatIsNotKnown) {
    const EvidenceFigure figure{"Drift", radFromDeg(0.0123), "rad/s",
                                Interval{radFromDeg(0.0121), radFromDeg(0.0125)}};
    EXPECT_EQ(typed(figureValue(figure)), "0.738 °/min");
    EXPECT_EQ(typed(figureInterval(figure)), "0.726 to 0.750");
    EXPECT_EQ(figureInterval({"Drift", 1.0, "rad/s", {}}), "");
}

TEST(EvidenceUnits, CountDecimalsAfterRounding) {
    EXPECT_EQ(decimalsFor(0.0021, 2), 4);
    EXPECT_EQ(decimalsFor(0.0996, 2), 2);
    EXPECT_EQ(decimalsFor(12.0, 2), 0);
    EXPECT_EQ(decimalsFor(1234.0, 2), 0);
    EXPECT_EQ(decimalsFor(1e-30, 2), 9);
    EXPECT_EQ(decimalsFor(0.0, 2), 0);
    EXPECT_EQ(decimalsFor(std::numeric_limits<double>::infinity(), 2), 0);
}

TEST(EvidenceUnits, NeverShowMinusNothing) {
    EXPECT_EQ(plainNumber(-0.0004, 3), "0.000");
    EXPECT_EQ(plainNumber(-0.0006, 3), QString(QChar(0x2212)) + "0.001");
}

TEST(EvidenceUnits, CompareErrorsInOneUnitWithTheSameDecimals) {
    EXPECT_EQ(typed(errorValue(0.205, "m", 0.205)), "0.205 m");
    EXPECT_EQ(typed(errorValue(0.016, "m", 0.205)), "0.016 m");
}

TEST(EvidenceUnits, CountAsPeopleCount) {
    EXPECT_EQ(figureValue({"Turns used", 4.0}), "4");
    EXPECT_EQ(figureValue({"Share", 0.25}), "0.250");
}

}  // namespace
}  // namespace hedr
