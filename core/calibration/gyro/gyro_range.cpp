#include "core/calibration/gyro/gyro_range.h"

#include <algorithm>
#include <cmath>

namespace hedr {

namespace {

constexpr double kEqual = 2e-4;  // of the rate: one from angles has rounded angles and times
constexpr double kShortestClip_s = 0.1;
constexpr std::size_t kFewestEqual = 5;
constexpr std::size_t kTimesAsLong = 3;  // as while standing

// The most readings in a row within `width` of the first of them.
std::size_t longestRun(std::span<const GyroSample> samples, double width_rad_s) {
    std::size_t longest = 0;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double step_rad_s = std::abs(samples[i].rate_rad_s - samples[begin].rate_rad_s);
        if (step_rad_s > width_rad_s) begin = i;
        longest = std::max(longest, i + 1 - begin);
    }
    return longest;
}

std::size_t longestRunStanding(std::span<const GyroSample> samples, const GyroStands& standing,
                               double width_rad_s) {
    const auto earlier = [](const GyroSample& sample, double t_s) { return sample.t_s < t_s; };
    std::size_t longest = 0;
    for (const GyroStand& stand : standing.stands) {
        const auto begin = std::lower_bound(samples.begin(), samples.end(), stand.begin_s, earlier);
        const auto end = std::lower_bound(begin, samples.end(), stand.end_s, earlier);
        longest = std::max(longest, longestRun({begin, end}, width_rad_s));
    }
    return longest;
}

// The most readings in a row that are as good as the extreme, and their time.
struct ExtremeRun {
    std::size_t readings = 0;
    double span_s = 0.0;
};

ExtremeRun longestRunAt(std::span<const GyroSample> samples, double extreme_rad_s,
                        double width_rad_s) {
    ExtremeRun longest;
    ExtremeRun run;
    for (const GyroSample& sample : samples) {
        if (std::abs(sample.rate_rad_s - extreme_rad_s) > width_rad_s) run = {};
        if (std::abs(sample.rate_rad_s - extreme_rad_s) <= width_rad_s) {
            ++run.readings;
            run.span_s += sample.dt_s;
        }
        if (run.readings > longest.readings) longest = run;
    }
    return longest;
}

}  // namespace

bool isBeyondRange(std::span<const GyroSample> samples, const GyroStands& standing) {
    const auto [low, high] = std::minmax_element(
        samples.begin(), samples.end(),
        [](const auto& a, const auto& b) { return a.rate_rad_s < b.rate_rad_s; });
    if (low == samples.end()) return false;
    for (const double extreme_rad_s : {low->rate_rad_s, high->rate_rad_s}) {
        const double width_rad_s = kEqual * std::abs(extreme_rad_s);
        const ExtremeRun run = longestRunAt(samples, extreme_rad_s, width_rad_s);
        const std::size_t usual = longestRunStanding(samples, standing, width_rad_s);
        if (run.readings >= kFewestEqual && run.span_s >= kShortestClip_s &&
            run.readings > kTimesAsLong * usual) {
            return true;
        }
    }
    return false;
}

}  // namespace hedr
