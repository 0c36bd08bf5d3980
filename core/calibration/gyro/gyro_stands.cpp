#include "core/calibration/gyro/gyro_stands.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/calibration/gyro/gyro_stretch.h"
#include "core/geometry/angle.h"
#include "core/robot/wheel_motion.h"

namespace hedr {

namespace {

constexpr double kLoneTimes = 10.0;  // as far from both neighbours as these are apart
constexpr double kLone_rad_s = radFromDeg(30.0);

constexpr double kStandBlock_s = 0.2;      // hands need longer to turn a robot
constexpr double kLongestBlock_s = 1.0;    // longer, nobody watched
constexpr std::size_t kFewestBlocks = 10;  // of a stand
constexpr std::size_t kBlocksPerMean = 4;  // for the noise: some of the bias's flicker shows in it
constexpr double kSteady_rad_s = radFromDeg(1.5);
constexpr double kStanding_rad_s = radFromDeg(0.5);
constexpr double kStandingSigmas = 6.0;
constexpr double kLargestStandingRate_rad_s = radFromDeg(20.0);  // as cheap gyros' biases
constexpr double kWheelsStill_m = 5e-4;  // fine encoders may go to and fro by a count
constexpr double kWheelsStill_rad = radFromDeg(0.05);

struct StandBlock {
    double begin_s = 0.0;
    double end_s = 0.0;
    double span_s = 0.0;
    double turn_rad = 0.0;
    bool counted = false;  // by the wheels

    double rate_rad_s() const { return turn_rad / span_s; }
};

using StandBlocks = std::span<const StandBlock>;

std::vector<StandBlock> blocksOf(std::span<const GyroSample> samples) {
    std::vector<StandBlock> blocks;
    StandBlock open;
    for (const GyroSample& sample : samples) {
        if (open.span_s == 0.0) open.begin_s = sample.t_s - sample.dt_s;
        open.end_s = sample.t_s;
        open.span_s += sample.dt_s;
        open.turn_rad += sample.rate_rad_s * sample.dt_s;
        if (open.span_s < 0.99 * kStandBlock_s) continue;
        blocks.push_back(open);
        open = {};
    }
    return blocks;
}

bool saysWheels(const SensorReport& report, const Vehicle& vehicle) {
    const WheelMotion none = wheelMotionBetween(report.odometry, report.odometry, vehicle);
    return !std::holds_alternative<std::monostate>(report.odometry) &&
           std::isfinite(report.robot_time_s + none.distance_m + none.turn_rad.value_or(0.0));
}

// When the wheels had moved by more than they do on a robot that stands.
std::vector<double> timesCounted(std::span<const SensorReport> reports, const Vehicle& vehicle) {
    std::vector<double> times_s;
    std::optional<Odometry> since;
    for (const SensorReport& report : reports) {
        if (!saysWheels(report, vehicle)) continue;
        if (!since) since = report.odometry;
        const WheelMotion moved = wheelMotionBetween(*since, report.odometry, vehicle);
        const bool still = std::abs(moved.distance_m) <= kWheelsStill_m &&
                           std::abs(moved.turn_rad.value_or(0.0)) <= kWheelsStill_rad;
        if (still && since->index() == report.odometry.index()) continue;
        since = report.odometry;
        times_s.push_back(report.robot_time_s);
    }
    return times_s;
}

void markCounted(std::vector<StandBlock>& blocks, std::span<const double> times_s) {
    auto time = times_s.begin();
    for (StandBlock& block : blocks) {
        while (time != times_s.end() && *time <= block.begin_s) ++time;
        block.counted = time != times_s.end() && *time <= block.end_s;
    }
}

double meanRate(StandBlocks blocks) {
    double turn_rad = 0.0;
    double span_s = 0.0;
    for (const StandBlock& block : blocks) {
        turn_rad += block.turn_rad;
        span_s += block.span_s;
    }
    return turn_rad / span_s;
}

double deviationOf(StandBlocks blocks) {
    const double mean = meanRate(blocks);
    double squares = 0.0;
    for (const StandBlock& block : blocks) {
        squares += (block.rate_rad_s() - mean) * (block.rate_rad_s() - mean);
    }
    return std::sqrt(squares / static_cast<double>(blocks.size() - 1));
}

bool isUsable(const StandBlock& block) { return !block.counted && block.span_s <= kLongestBlock_s; }

bool isSteady(StandBlocks blocks, double scale) {
    if (!std::all_of(blocks.begin(), blocks.end(), isUsable)) return false;
    const auto [low, high] = std::minmax_element(
        blocks.begin(), blocks.end(),
        [](const auto& a, const auto& b) { return a.rate_rad_s() < b.rate_rad_s(); });
    return scale * (high->rate_rad_s() - low->rate_rad_s()) < kSteady_rad_s &&
           scale * std::abs(meanRate(blocks)) < kLargestStandingRate_rad_s;
}

// The first blocks that are steady.
StandBlocks firstSteady(StandBlocks blocks, double scale) {
    for (std::size_t i = 0; i + kFewestBlocks <= blocks.size(); ++i) {
        const StandBlocks window = blocks.subspan(i, kFewestBlocks);
        if (isSteady(window, scale)) return window;
    }
    return {};
}

// Runs of blocks near the level, which follows them.
std::vector<StandBlocks> standingRuns(StandBlocks blocks, double level_rad_s, double limit_rad_s) {
    std::vector<StandBlocks> runs;
    std::size_t begin = 0;
    for (std::size_t i = 0; i <= blocks.size(); ++i) {
        const bool stands = i < blocks.size() && isUsable(blocks[i]) &&
                            std::abs(blocks[i].rate_rad_s() - level_rad_s) < limit_rad_s;
        if (stands) continue;
        if (i - begin >= kFewestBlocks) {
            runs.push_back(blocks.subspan(begin + 1, i - begin - 2));
            level_rad_s = meanRate(runs.back());
        }
        begin = i + 1;
    }
    return runs;
}

GyroStand standOf(StandBlocks run) {
    GyroStand stand{run.front().begin_s, run.back().end_s, meanRate(run)};
    for (const StandBlock& block : run) stand.span_s += block.span_s;
    return stand;
}

// From differences of successive means, so that no drift counts.
void learnNoise(GyroStands& found, const std::vector<StandBlocks>& runs) {
    double squares = 0.0;
    double count = 0.0;
    for (const StandBlocks run : runs) {
        for (std::size_t i = 0; i + 2 * kBlocksPerMean <= run.size(); i += kBlocksPerMean) {
            const double difference = meanRate(run.subspan(i + kBlocksPerMean, kBlocksPerMean)) -
                                      meanRate(run.subspan(i, kBlocksPerMean));
            squares += 0.5 * difference * difference;
            count += 1.0;
        }
    }
    // Each mean has a share in two differences.
    constexpr double kDegreesPerDifference = 2.0 / 3.0;
    if (count == 0.0) return;
    const double mean_s = static_cast<double>(kBlocksPerMean) * kStandBlock_s;
    found.noise_rad_s_sqrthz = std::sqrt(squares / count * mean_s);
    found.degrees_of_freedom = std::max(1.0, kDegreesPerDifference * count);
}

double roundingIn(std::span<const GyroSample> samples, const GyroStand& stand) {
    GyroStretch stretch;
    for (const GyroSample& sample : samples) {
        if (sample.t_s > stand.begin_s && sample.t_s <= stand.end_s) stretch.add(sample);
    }
    return stretch.blocks() > 0 ? stretch.coarseStep_rad_s() / std::sqrt(12.0) : 0.0;
}

}  // namespace

std::vector<GyroSample> withoutLoneReadings(std::vector<GyroSample> samples) {
    for (std::size_t i = 1; i + 1 < samples.size(); ++i) {
        const double before = samples[i - 1].rate_rad_s;
        const double after = samples[i + 1].rate_rad_s;
        const double away = std::min(std::abs(samples[i].rate_rad_s - before),
                                     std::abs(samples[i].rate_rad_s - after));
        if (away > kLone_rad_s + kLoneTimes * std::abs(after - before)) {
            samples[i].rate_rad_s = 0.5 * (before + after);
        }
    }
    return samples;
}

GyroStands standsIn(std::span<const GyroSample> samples, std::span<const SensorReport> reports,
                    const Vehicle& vehicle) {
    GyroStands found;
    std::vector<StandBlock> blocks = blocksOf(samples);
    markCounted(blocks, timesCounted(reports, vehicle));
    const StandBlocks steady = firstSteady(blocks, vehicle.gyro_scale);
    if (steady.empty()) return found;
    const double limit_rad_s =
        std::max(kStanding_rad_s / vehicle.gyro_scale, kStandingSigmas * deviationOf(steady));
    const auto runs = standingRuns(blocks, meanRate(steady), limit_rad_s);
    for (const StandBlocks run : runs) found.stands.push_back(standOf(run));
    learnNoise(found, runs);
    if (!found.stands.empty()) found.rounding_rad_s = roundingIn(samples, found.stands.front());
    return found;
}

}  // namespace hedr
