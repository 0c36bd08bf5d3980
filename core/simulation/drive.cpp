#include "core/simulation/drive.h"

#include <cmath>
#include <cstddef>

#include "core/simulation/tele_operator.h"

namespace hedr {

namespace {

constexpr double kLongestStep_s = 0.01;

}  // namespace

std::vector<Pose<Floor>> driveThrough(const Building& building, const DriveStyle& style,
                                      Random& random) {
    const int steps_per_sample =
        static_cast<int>(std::ceil(1.0 / (style.rate_hz * kLongestStep_s)));
    const double step_s = 1.0 / (style.rate_hz * steps_per_sample);
    const auto samples =
        static_cast<std::size_t>(std::lround(style.duration_s * style.rate_hz)) + 1;
    TeleOperator tele_operator(building, style, step_s, random);
    std::vector<Pose<Floor>> poses{tele_operator.pose()};
    poses.reserve(samples);
    while (poses.size() < samples) {
        for (int step = 0; step < steps_per_sample; ++step) tele_operator.step();
        poses.push_back(tele_operator.pose());
    }
    return poses;
}

}  // namespace hedr
