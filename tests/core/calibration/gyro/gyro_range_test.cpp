#include "core/calibration/gyro/gyro_range.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/geometry/angle.h"
#include "core/simulation/random.h"

namespace hedr {
namespace {

// Of half a minute at 50 Hz: 1 °/s, and noise of 0.2 °/s.
std::vector<GyroSample> standingSamples(std::uint64_t seed) {
    Random random(seed);
    std::vector<GyroSample> samples;
    for (int i = 1; i <= 1500; ++i)
        samples.push_back({0.02 * i, 0.02, radFromDeg(1.0 + 0.2 * random.normal())});
    return samples;
}

TEST(GyroRange, TellsAClippedGyro) {
    std::vector<GyroSample> samples = standingSamples(4);
    EXPECT_FALSE(isClipped(samples));
    for (GyroSample& sample : samples)
        sample.rate_rad_s = std::min(sample.rate_rad_s, radFromDeg(1.4));
    EXPECT_TRUE(isClipped(samples));
    for (GyroSample& sample : samples) sample.rate_rad_s *= -1.0;
    EXPECT_TRUE(isClipped(samples));
    EXPECT_FALSE(complaintAboutClipped(samples).empty());
}

TEST(GyroRange, TakesACoarseGyroForNoneThatIsClipped) {
    for (const double step_deg_s : {0.02, 0.1, 0.3}) {
        for (std::uint64_t seed = 0; seed < 200; ++seed) {
            std::vector<GyroSample> samples = standingSamples(seed);
            for (GyroSample& sample : samples)
                sample.rate_rad_s = std::round(sample.rate_rad_s / radFromDeg(step_deg_s));
            EXPECT_FALSE(isClipped(samples)) << step_deg_s << ", seed " << seed;
        }
    }
}

}  // namespace
}  // namespace hedr
