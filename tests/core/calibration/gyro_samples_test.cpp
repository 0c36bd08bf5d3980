#include "core/calibration/gyro_samples.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hedr {
namespace {

SensorReport rateAt(double t_s, double rad_s) {
    return {.robot_time_s = t_s, .gyro = GyroRate{rad_s}};
}
SensorReport angleAt(double t_s, std::uint32_t urad) {
    return {.robot_time_s = t_s, .gyro = GyroAngle{urad}};
}

TEST(GyroSamples, AreRatesAsTheyCame) {
    const auto samples =
        gyroSamplesOf(std::vector{rateAt(0.0, 1.0), rateAt(0.1, 2.0), rateAt(0.2, 4.0)});
    ASSERT_TRUE(samples);
    EXPECT_EQ(samples->rates_rad_s(), (std::vector<double>{2.0, 4.0}));
    EXPECT_DOUBLE_EQ(samples->mean_rad_s(), 3.0);
    EXPECT_NEAR(samples->period_s, 0.1, 1e-12);
}

TEST(GyroSamples, AreMeanRatesOfAnglesThatWrap) {
    const auto samples =
        gyroSamplesOf(std::vector{angleAt(0.0, 4294967196U), angleAt(0.5, 100), angleAt(1.0, 0)});
    ASSERT_TRUE(samples);
    EXPECT_NEAR(samples->samples[0].rate_rad_s, 400e-6, 1e-12);
    EXPECT_NEAR(samples->samples[1].rate_rad_s, -200e-6, 1e-12);
}

TEST(GyroSamples, CountWhatIsBrokenAndWhatIsMissing) {
    const auto samples = gyroSamplesOf(
        std::vector{rateAt(0.0, 1.0), rateAt(0.1, NAN), rateAt(0.1, 1.0), rateAt(0.2, 1.0),
                    rateAt(0.15, 1.0), rateAt(0.3, 1.0), rateAt(5.0, 1.0), rateAt(5.1, 1.0)});
    ASSERT_TRUE(samples);
    EXPECT_EQ(samples->broken, 2U);
    EXPECT_EQ(samples->gaps, 1U);
    EXPECT_NEAR(samples->longest_gap_s, 4.7, 1e-12);
}

TEST(GyroSamples, NeedTwoReadings) {
    EXPECT_EQ(gyroSamplesOf({}).error().code, ErrorCode::kNoData);
    EXPECT_FALSE(gyroSamplesOf(std::vector{rateAt(0.0, 1.0), rateAt(0.1, 1.0)}));
    EXPECT_FALSE(gyroSamplesOf(std::vector<SensorReport>(5)));
}

TEST(GyroSamples, OfAnAngleMakeTheSameLogOfRates) {
    const std::vector angles{angleAt(0.0, 5), angleAt(0.1, 25), angleAt(0.3, 15)};
    const std::vector<SensorReport> rates = withGyroRates(angles);
    EXPECT_EQ(rates[0].gyro, Gyro());
    EXPECT_NEAR(std::get<GyroRate>(rates[1].gyro).rad_s, 200e-6, 1e-12);
    EXPECT_NEAR(std::get<GyroRate>(rates[2].gyro).rad_s, -50e-6, 1e-12);
}

}  // namespace
}  // namespace hedr
