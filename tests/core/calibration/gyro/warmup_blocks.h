#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "core/calibration/gyro/warmup_curve.h"
#include "core/geometry/angle.h"
#include "core/simulation/random.h"

namespace hedr {

// The Gyrostar of Barshan and Durrant-Whyte 1994.
inline constexpr GyroDrift kGyrostar{radFromDeg(0.153), radFromDeg(-0.264), 60.0 * 5.64};
inline const double kGyrostarNoise_rad_s_sqrthz = radFromDeg(0.2) * std::sqrt(0.03);

// A bias that flickers: the sum of processes that forget themselves within times of every size.
class Flicker {
  public:
    // The flat part of the Allan deviation is 0.664 times that.
    Flicker(double instability_rad_s, double step_s, Random& random) : random_(random) {
        size_ = instability_rad_s * std::sqrt(std::log(kRatio) / std::numbers::pi);
        double time_s = 0.5;
        for (Part& part : parts_) {
            part.keep = std::exp(-step_s / time_s);
            part.value = random.normal();
            time_s *= kRatio;
        }
    }

    double next() {
        double sum = 0.0;
        for (Part& part : parts_) {
            part.value =
                part.keep * part.value + std::sqrt(1.0 - part.keep * part.keep) * random_.normal();
            sum += part.value;
        }
        return size_ * sum;
    }

  private:
    static constexpr double kRatio = 2.5;
    struct Part {
        double keep = 0.0;
        double value = 0.0;
    };
    std::array<Part, 11> parts_{};  // to an hour and a half
    double size_ = 0.0;
    Random& random_;
};

// A simulated record of a standing gyro, as means over a hundred blocks or of two seconds.
struct BlockRecord {
    GyroDrift curve = kGyrostar;
    double minutes = 20.0;
    double noise_rad_s_sqrthz = kGyrostarNoise_rad_s_sqrthz;
    double flicker_rad_s = 0.0;
    RoomTemperature room = RoomTemperature::kSteady;  // as it is told
    std::function<double(double t_s)> besides{};      // rate that is no warm-up
};

inline std::vector<WarmupBlock> blocksOf(const BlockRecord& record, Random& random) {
    const double duration_s = 60.0 * record.minutes;
    const double block_s = std::max(2.0, duration_s / 100.0);
    Flicker flicker(record.flicker_rad_s, block_s, random);
    std::vector<WarmupBlock> blocks;
    for (int place = 0; (place + 0.99) * block_s < duration_s; ++place) {
        WarmupBlock block{place * block_s, (place + 1) * block_s, 0.0, block_s};
        block.mean_rad_s = meanBias(block, record.curve) +
                           record.noise_rad_s_sqrthz / std::sqrt(block_s) * random.normal();
        if (record.flicker_rad_s > 0.0) block.mean_rad_s += flicker.next();
        if (record.besides) block.mean_rad_s += record.besides(block.middle_s());
        blocks.push_back(block);
    }
    return blocks;
}

}  // namespace hedr
