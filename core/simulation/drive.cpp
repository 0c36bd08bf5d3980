#include "core/simulation/drive.h"

#include <cmath>
#include <cstddef>

#include "core/simulation/tele_operator.h"

namespace hedr {

namespace {

constexpr double kLongestStep_s = 0.01;

}  // namespace

Drive driveThrough(const Building& building, const DriveStyle& style, Random& random) {
    const int steps_per_sample =
        static_cast<int>(std::ceil(1.0 / (style.rate_hz * kLongestStep_s)));
    const double step_s = 1.0 / (style.rate_hz * steps_per_sample);
    const auto samples =
        static_cast<std::size_t>(std::lround(style.duration_s * style.rate_hz)) + 1;
    TeleOperator tele_operator(building, style, step_s, random);
    Drive drive;
    drive.poses.reserve(samples);
    drive.poses.push_back(tele_operator.pose());
    while (drive.poses.size() < samples) {
        for (int step = 0; step < steps_per_sample; ++step) tele_operator.step();
        const double time_s = static_cast<double>(drive.poses.size()) / style.rate_hz;
        drive.poses.push_back(tele_operator.pose());
        if (!tele_operator.atTask()) continue;
        if (drive.task_begin_s == 0.0) drive.task_begin_s = time_s;
        drive.task_end_s = time_s;
    }
    return drive;
}

}  // namespace hedr
