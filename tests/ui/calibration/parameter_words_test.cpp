#include "ui/calibration/parameter_words.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/geometry/angle.h"
#include "core/robot/vehicle_keys.h"

namespace hedr {
namespace {

QString typed(QString text) { return text.replace(QChar(0x00A0), ' ').replace(QChar(0x2212), '-'); }

TEST(ParameterWords, AreThereForEveryKeyOfTheVehicleFile) {
    const auto has_words = [](const VehicleKey& key) {
        const ParameterWords words = parameterWords(key.name);
        EXPECT_FALSE(words.name.contains('_')) << key.name;
        EXPECT_GT(words.unit.per_si, 0.0) << key.name;
    };
    for (const VehicleKey& key : vehicleKeys()) has_words(key);
    for (const VehicleKeyGroup& group : vehicleKeyGroups()) {
        for (const VehicleKey& key : group.keys) has_words(key);
    }
}

TEST(ParameterWords, AreTheKeyItselfWhereItIsNotKnown) {
    EXPECT_EQ(parameterWords("track_width_m").name, "track_width_m");
    EXPECT_EQ(parameterWords("track_width_m").unit.name, "");
}

TEST(FoundText, ShowsTwoDigitsOfTheMargin) {
    const FoundText text = foundText({"wheelbase_m", 0.41, {0.55314, 0.0009, 8.0}});
    EXPECT_EQ(text.name, "Wheelbase");
    EXPECT_EQ(typed(text.value), "0.5531 m");
    EXPECT_EQ(text.margin, "± 0.0021");
    EXPECT_EQ(typed(text.was), "was 0.4100 m");
}

TEST(FoundText, SaysWhereAMarginReachesFurtherUpThanDown) {
    const Estimate warm_up = estimateWithin(338.4, {300.0, 390.0}, 97.0);
    const FoundText text = foundText({"gyro_drift_time_s", {}, warm_up});
    EXPECT_EQ(typed(text.value), "5.64 min");
    EXPECT_EQ(text.margin, "+0.86 −0.64");
}

TEST(FoundText, IsInTheUnitThatIsRead) {
    const FoundText wheel = foundText({"left_wheel_diameter_m", 0.2, {0.19959, 0.00013}});
    EXPECT_EQ(typed(wheel.value), "199.59 mm");
    EXPECT_EQ(wheel.margin, "± 0.25");
    const FoundText bias =
        foundText({"gyro_bias_rad_s", {}, {radFromDeg(-0.111), radFromDeg(0.002)}});
    EXPECT_EQ(typed(bias.value), "-0.1110 °/s");
    EXPECT_EQ(bias.margin, "± 0.0039");
    EXPECT_EQ(bias.was, "was not set");
}

TEST(FoundText, DoesNotPretendToKnow) {
    const double nan = std::nan("");
    const double infinity = std::numeric_limits<double>::infinity();
    for (const Estimate& estimate :
         {Estimate{nan, 0.1}, Estimate{1.0, nan}, Estimate{1.0, infinity}, Estimate{1.0, 0.1, 0.0},
          Estimate{1.0, -1.0}}) {
        const FoundText text = foundText({"wheelbase_m", 0.41, estimate});
        EXPECT_EQ(text.value, "–");
        EXPECT_EQ(text.margin, "not measured yet");
        EXPECT_EQ(typed(text.was), "was 0.4100 m");
    }
}

TEST(FoundText, ShowsAnExactValueWithFourDigits) {
    const FoundText text = foundText({"ticks_per_revolution", {}, {36000.0, 0.0}});
    EXPECT_EQ(text.value, "36000");
    EXPECT_EQ(text.margin, "± 0");
}

}  // namespace
}  // namespace hedr
