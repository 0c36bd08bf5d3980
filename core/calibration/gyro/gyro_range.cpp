#include "core/calibration/gyro/gyro_range.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace hedr {

namespace {

constexpr double kEqual = 2e-4;  // of the rate: one from angles has rounded angles and times
constexpr double kShortestClip_s = 0.1;
constexpr std::size_t kFewestEqual = 5;
constexpr std::size_t kTimesAsLong = 3;  // as while standing

constexpr double kClippedShare = 0.01;
constexpr std::size_t kFewestClipped = 5;
constexpr std::size_t kFewestValues = 6;  // fewer: coarse, not clipped
constexpr std::size_t kPileUp = 3;        // times the next value

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

// How often each value occurs, from the smallest to the largest.
std::vector<std::size_t> countsOfValues(std::span<const GyroSample> samples) {
    std::vector<double> rates;
    rates.reserve(samples.size());
    for (const GyroSample& sample : samples) rates.push_back(sample.rate_rad_s);
    std::sort(rates.begin(), rates.end());
    std::vector<std::size_t> counts;
    for (std::size_t i = 0; i < rates.size(); ++i) {
        if (i == 0 || rates[i] != rates[i - 1]) counts.push_back(0);
        ++counts.back();
    }
    return counts;
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

bool isClipped(std::span<const GyroSample> samples) {
    const std::vector<std::size_t> counts = countsOfValues(samples);
    if (counts.size() < kFewestValues) return false;
    const auto piled_up = [all = samples.size()](std::size_t extreme, std::size_t next) {
        return extreme >= kFewestClipped && extreme > kPileUp * next &&
               static_cast<double>(extreme) > kClippedShare * static_cast<double>(all);
    };
    return piled_up(counts.front(), counts[1]) ||
           piled_up(counts.back(), counts[counts.size() - 2]);
}

std::string complaintAboutClipped(std::span<const GyroSample> samples) {
    if (!isClipped(samples)) return {};
    return "The gyro is at the end of its range. Check its range and that nothing shakes it.";
}

double shareOfCommonest(std::span<const GyroSample> samples) {
    const std::vector<std::size_t> counts = countsOfValues(samples);
    const auto most = std::max_element(counts.begin(), counts.end());
    return static_cast<double>(*most) / static_cast<double>(samples.size());
}

}  // namespace hedr
