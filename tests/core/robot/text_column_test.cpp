#include "core/robot/text_column.h"

#include <gtest/gtest.h>

#include "core/geometry/angle.h"

namespace hedr {
namespace {

using enum TextQuantity;

struct Meaning {
    const char* name;
    TextQuantity quantity;
    double scale;
    bool has_unit;
};

class TextColumnName : public testing::TestWithParam<Meaning> {};

TEST_P(TextColumnName, IsUnderstood) {
    const auto column = textColumn(GetParam().name);
    ASSERT_TRUE(column) << GetParam().name;
    EXPECT_EQ(column->quantity, GetParam().quantity) << GetParam().name;
    EXPECT_DOUBLE_EQ(column->scale, GetParam().scale) << GetParam().name;
    EXPECT_EQ(column->has_unit, GetParam().has_unit) << GetParam().name;
}

constexpr double kDegree = radFromDeg(1.0);

INSTANTIATE_TEST_SUITE_P(
    Names, TextColumnName,
    testing::Values(
        Meaning{"t_s", kTime, 1.0, true}, Meaning{"t", kTime, 1.0, false},
        Meaning{"Time", kTime, 1.0, false}, Meaning{"time (ms)", kTime, 1e-3, true},
        Meaning{"millis", kTime, 1e-3, true}, Meaning{"millis()", kTime, 1e-3, true},
        Meaning{"us", kTime, 1e-6, true}, Meaning{"t [\u00B5s]", kTime, 1e-6, true},
        Meaning{"time_micros", kTime, 1e-6, true}, Meaning{"left", kLeftTicks, 1.0, false},
        Meaning{"L", kLeftTicks, 1.0, false}, Meaning{"encL", kLeftTicks, 1.0, false},
        Meaning{"enc_left", kLeftTicks, 1.0, false}, Meaning{"left_count", kLeftTicks, 1.0, true},
        Meaning{"left_ticks", kLeftTicks, 1.0, true}, Meaning{"left_m", kLeftTravel, 1.0, true},
        Meaning{"Left [mm]", kLeftTravel, 1e-3, true},
        Meaning{"Right Encoder", kRightTicks, 1.0, false},
        Meaning{"right_cm", kRightTravel, 1e-2, true}, Meaning{"dist_m", kDistance, 1.0, true},
        Meaning{"gyro_z_rad_s", kYawRate, 1.0, true}, Meaning{"gyroZ", kYawRate, 1.0, false},
        Meaning{"gyro_dps", kYawRate, kDegree, true},
        Meaning{"gz [deg/s]", kYawRate, kDegree, true},
        Meaning{"gz [\u00B0/s]", kYawRate, kDegree, true},
        Meaning{"gz_mdps", kYawRate, 1e-3 * kDegree, true},
        Meaning{"yaw_rate_cw_dps", kYawRate, -kDegree, true},
        Meaning{"yaw_rate_ccw_dps", kYawRate, kDegree, true},
        Meaning{"heading_deg", kHeading, kDegree, true},
        Meaning{"heading_cw_deg", kHeading, -kDegree, true},
        Meaning{"compass_deg", kHeading, -kDegree, true}, Meaning{"theta", kHeading, 1.0, false},
        Meaning{"odo_heading_rad", kHeading, 1.0, true}, Meaning{"odo_x_m", kX, 1.0, true},
        Meaning{"x_mm", kX, 1e-3, true}, Meaning{"Y", kY, 1.0, false},
        Meaning{"mag_x", kMagX, 1.0, false}, Meaning{"magZ [uT]", kMagZ, 1.0, true},
        Meaning{"temperature_c", kTemperature, 1.0, true},
        Meaning{"temp", kTemperature, 1.0, false}, Meaning{"battery_mV", kBattery, 1e-3, true},
        Meaning{"vbat", kBattery, 1.0, false}));

TEST(TextColumn, OfAnotherMeaningIsNotKnown) {
    for (const char* name : {"", "-", "state", "left_speed", "v", "gyro_x", "temp_f", "battery_pct",
                             "Hello world", "$GPRMC", "rightful", "x_deg", "t_m", "millis_us"}) {
        EXPECT_FALSE(textColumn(name)) << name;
    }
    EXPECT_FALSE(textColumn(std::string(200, 't')));
}

TEST(TextColumn, KnowsItsOwnNames) {
    for (std::size_t i = 0; i < kTextQuantities; ++i) {
        const auto quantity = static_cast<TextQuantity>(i);
        const auto column = textColumn(textQuantityName(quantity));
        ASSERT_TRUE(column);
        EXPECT_EQ(column->quantity, quantity);
        EXPECT_EQ(column->scale, 1.0);
    }
}

}  // namespace
}  // namespace hedr
