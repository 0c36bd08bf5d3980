#include "ui/format.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/geometry/angle.h"

namespace hedr {
namespace {

QString plain(QString text) { return text.replace(QChar(0x00A0), QChar(' ')); }

TEST(Format, CountsHeadingsCounterClockwiseFromZeroTo359) {
    EXPECT_EQ(formatHeading(radFromDeg(270.0)), "270°");
    EXPECT_EQ(formatHeading(radFromDeg(-90.0)), "270°");
    EXPECT_EQ(formatHeading(radFromDeg(359.7)), "0°");
    EXPECT_EQ(formatHeading(radFromDeg(-0.2)), "0°");
    EXPECT_EQ(formatHeading(radFromDeg(3.0 * 360.0 + 12.0)), "12°");
}

TEST(Format, PutsUnitsBehindNumbers) {
    EXPECT_EQ(plain(formatSpeed(0.618)), "0.62 m/s");
    EXPECT_EQ(plain(formatDistance(42.46)), "42.5 m");
    EXPECT_EQ(plain(formatDistance(1240.0)), "1.24 km");
    EXPECT_EQ(plain(formatLoss(0.004)), "0.4 %");
    EXPECT_EQ(plain(formatFrameRate(119.6)), "120 Hz");
    EXPECT_EQ(formatDuration(18 * 60 + 42.9), "00:18:42");
    EXPECT_EQ(formatDuration(100.0 * 3600.0), "100:00:00");
}

TEST(Format, WritesATrueMinusAndNoMinusZero) {
    EXPECT_EQ(plain(formatRadioStrength(-71)), "−71 dBm");
    EXPECT_EQ(plain(formatSpeed(-0.001)), "0.00 m/s");
    EXPECT_EQ(plain(formatDrift(radFromDeg(3.1 / 60.0))), "+3.1 °/min");
    EXPECT_EQ(plain(formatDrift(radFromDeg(-3.1 / 60.0))), "−3.1 °/min");
    EXPECT_EQ(plain(formatDrift(1e-9)), "0.0 °/min");
}

TEST(Format, ChoosesTheUnitThatKeepsNumbersShort) {
    EXPECT_EQ(plain(formatBytes(0)), "0 B");
    EXPECT_EQ(plain(formatBytes(999)), "999 B");
    EXPECT_EQ(plain(formatBytes(999'999)), "1.0 MB");
    EXPECT_EQ(plain(formatBytes(3'100'000)), "3.1 MB");
    EXPECT_EQ(plain(formatAge(7.9)), "7 s");
    EXPECT_EQ(plain(formatAge(130.0)), "2 min");
    EXPECT_EQ(plain(formatAge(7200.0)), "2 h");
}

TEST(Format, ShowsADashForWhatIsNotANumber) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(plain(formatSpeed(nan)), "– m/s");
    EXPECT_EQ(formatHeading(nan), "–");
    EXPECT_EQ(formatDuration(nan), "–");
}

}  // namespace
}  // namespace hedr
