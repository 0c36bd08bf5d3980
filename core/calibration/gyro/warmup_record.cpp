#include "core/calibration/gyro/warmup_record.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/calibration/median.h"
#include "core/calibration/short_number.h"
#include "core/geometry/angle.h"
#include "core/robot/wheel_motion.h"

namespace hedr {

namespace {

constexpr double kMoment_s = 0.25;
constexpr double kLoneSteps = 8.0;      // of the median one
constexpr double kSilentPeriods = 3.0;  // a reading does not speak for what is longer
constexpr std::array<std::size_t, 5> kNudgeMoments{1, 2, 4, 8, 16};
constexpr std::size_t kSideMoments = 20;
constexpr std::size_t kFewestSideMoments = 10;
constexpr std::size_t kNoiseMoments = 480;  // two minutes
constexpr double kNudgeSigmas = 5.7;        // one false alarm in some hundred hours
constexpr double kNudge_rad_s = radFromDeg(0.01);
constexpr double kBeforeNudge_s = 0.5;
constexpr double kBeforeFirstCount_s = 1.0;  // coarse encoders count late
constexpr double kFineCounts_m = 5e-4;       // fine ones go to and fro by one
constexpr double kFineCounts_rad = radFromDeg(0.05);

constexpr double kMostWarmupBlocks = 100.0;
constexpr double kShortestWarmupBlock_s = 2.0;
constexpr double kFewestBlockPeriods = 4.0;
constexpr double kHeardShare = 0.8;

struct Moment {
    double end_s = 0.0;  // since the record began
    double heard_s = 0.0;
    double turn_rad = 0.0;
};

double medianSize(std::vector<double> values) {
    for (double& value : values) value = std::abs(value);
    return medianOf(std::move(values));
}

// A reading far from both that it stands between, which are near to one another, takes their mean.
std::vector<double> withoutLoneReadings(std::vector<double> rates) {
    std::vector<double> steps;
    steps.reserve(rates.size());
    for (std::size_t i = 1; i < rates.size(); ++i) steps.push_back(rates[i] - rates[i - 1]);
    const double limit = kLoneSteps * medianSize(steps);
    if (limit <= 0.0) return rates;
    for (std::size_t i = 1; i + 1 < rates.size(); ++i) {
        const double middle = 0.5 * (rates[i - 1] + rates[i + 1]);
        const bool calm = std::abs(rates[i + 1] - rates[i - 1]) < limit;
        if (calm && std::abs(rates[i] - middle) > limit) rates[i] = middle;
    }
    return rates;
}

std::vector<Moment> momentsOf(const GyroSamples& gyro, double scale) {
    std::vector<Moment> moments;
    const double begin_s = gyro.samples.front().t_s - gyro.samples.front().dt_s;
    const std::vector<double> rates = withoutLoneReadings(gyro.rates_rad_s());
    Moment open;
    for (std::size_t i = 0; i < rates.size(); ++i) {
        const GyroSample& sample = gyro.samples[i];
        const bool gap = sample.dt_s > kSilentPeriods * gyro.period_s;
        const double heard_s = gap ? gyro.period_s : sample.dt_s;
        open.end_s = sample.t_s - begin_s;
        open.heard_s += heard_s;
        open.turn_rad += scale * rates[i] * heard_s;
        if (open.heard_s < 0.99 * kMoment_s) continue;
        moments.push_back(open);
        open = {};
    }
    return moments;
}

// Sums up to each moment.
class MomentSums {
  public:
    explicit MomentSums(std::span<const Moment> moments) : sums_(moments.size() + 1) {
        for (std::size_t i = 0; i < moments.size(); ++i) {
            sums_[i + 1].heard_s = sums_[i].heard_s + moments[i].heard_s;
            sums_[i + 1].turn_rad = sums_[i].turn_rad + moments[i].turn_rad;
        }
    }

    double mean(std::size_t first, std::size_t last) const {
        return (sums_[last].turn_rad - sums_[first].turn_rad) /
               (sums_[last].heard_s - sums_[first].heard_s);
    }

    // How far a mean is from those before and after it: a drift cancels.
    double contrast(std::size_t first, std::size_t last) const {
        const std::size_t before = first - std::min(first, kSideMoments);
        const std::size_t after = std::min(last + kSideMoments, sums_.size() - 1);
        return mean(first, last) - 0.5 * (mean(before, first) + mean(last, after));
    }

  private:
    std::vector<Moment> sums_;
};

// Deviation of a moment's mean from those around it, while the robot still stands.
double momentNoise(std::span<const Moment> moments, const MomentSums& sums) {
    constexpr double kDeviationPerMedian = 1.4826;
    std::vector<double> contrasts;
    contrasts.reserve(kNoiseMoments);
    const std::size_t last = std::min(kNoiseMoments, moments.size() - kSideMoments);
    for (std::size_t i = kSideMoments; i < last; ++i) contrasts.push_back(sums.contrast(i, i + 1));
    return kDeviationPerMedian * medianSize(contrasts);
}

// The first one of so many moments.
std::optional<WarmupMotion> firstNudge(std::span<const Moment> moments, const MomentSums& sums,
                                       std::size_t length) {
    if (moments.size() < length + 2 * kSideMoments) return std::nullopt;
    // The sides are as unsure as ever, however long what is between them.
    constexpr double kOfSides = 0.5 / static_cast<double>(kSideMoments);
    const double surer = (1.0 / static_cast<double>(length) + kOfSides) / (1.0 + kOfSides);
    const double limit =
        kNudge_rad_s + kNudgeSigmas * std::sqrt(surer) * momentNoise(moments, sums);
    std::vector<double> contrasts;
    contrasts.reserve(moments.size());
    const std::size_t last = moments.size() - length - kFewestSideMoments;
    for (std::size_t i = kFewestSideMoments; i <= last; ++i)
        contrasts.push_back(sums.contrast(i, i + length));
    const auto found = std::find_if(contrasts.begin(), contrasts.end(),
                                    [limit](double each) { return std::abs(each) > limit; });
    if (found == contrasts.end()) return std::nullopt;
    const auto first = kFewestSideMoments + static_cast<std::size_t>(found - contrasts.begin());
    const double until_s = moments[first + length - 1].end_s;
    const double span_s = kMoment_s * static_cast<double>(length);
    return WarmupMotion{until_s - span_s, span_s, *found * span_s};
}

std::optional<WarmupMotion> firstCount(std::span<const SensorReport> reports, double begin_s,
                                       const Vehicle& vehicle) {
    const SensorReport* first = nullptr;
    for (const SensorReport& report : reports) {
        const bool none = std::holds_alternative<std::monostate>(report.odometry);
        if (none || !std::isfinite(report.robot_time_s)) continue;
        if (!first) first = &report;
        const WheelMotion moved = wheelMotionBetween(first->odometry, report.odometry, vehicle);
        if (std::abs(moved.distance_m) <= kFineCounts_m &&
            std::abs(moved.turn_rad.value_or(0.0)) <= kFineCounts_rad) {
            continue;
        }
        return WarmupMotion{report.robot_time_s - begin_s};
    }
    return std::nullopt;
}

void keepEarlier(std::optional<WarmupMotion>& kept, const std::optional<WarmupMotion>& other) {
    if (other && (!kept || other->since_s < kept->since_s)) kept = other;
}

std::vector<WarmupBlock> warmupBlocksOf(std::span<const Moment> moments, double block_s,
                                        double on_before_s) {
    std::vector<WarmupBlock> blocks;
    double turn_rad = 0.0;
    int open_place = 0;
    WarmupBlock open{};
    const auto close = [&] {
        if (open.heard_s < kHeardShare * block_s) return;
        open.begin_s = on_before_s + open_place * block_s;
        open.end_s = open.begin_s + block_s;
        open.mean_rad_s = turn_rad / open.heard_s;
        blocks.push_back(open);
    };
    for (const Moment& moment : moments) {
        const int place = static_cast<int>((moment.end_s - 0.5 * moment.heard_s) / block_s);
        if (place != open_place) {
            close();
            open_place = place;
            open = {};
            turn_rad = 0.0;
        }
        open.heard_s += moment.heard_s;
        turn_rad += moment.turn_rad;
    }
    close();
    return blocks;
}

}  // namespace

std::string sentenceOf(const WarmupMotion& motion) {
    if (!motion.turn_rad) return "The wheels moved.";
    return "The robot turned by about " + shortNumber(degFromRad(std::abs(*motion.turn_rad)), 1) +
           "° within " + shortNumber(motion.span_s) + " s.";
}

WarmupRecord warmupRecordOf(const GyroSamples& gyro, std::span<const SensorReport> reports,
                            const Vehicle& vehicle, double on_before_s) {
    WarmupRecord record;
    std::vector<Moment> moments = momentsOf(gyro, vehicle.gyro_scale);
    const double begin_s = gyro.samples.front().t_s - gyro.samples.front().dt_s;
    record.motion = firstCount(reports, begin_s, vehicle);
    const MomentSums sums(moments);
    for (const std::size_t length : kNudgeMoments)
        keepEarlier(record.motion, firstNudge(moments, sums, length));
    if (record.motion) {
        const double margin_s = record.motion->turn_rad ? kBeforeNudge_s : kBeforeFirstCount_s;
        const double until_s = record.motion->since_s - margin_s;
        std::erase_if(moments, [until_s](const Moment& each) { return each.end_s > until_s; });
    }
    if (moments.empty()) return record;
    record.stood_s = moments.back().end_s;
    const double block_s = std::max({kShortestWarmupBlock_s, record.stood_s / kMostWarmupBlocks,
                                     kFewestBlockPeriods * gyro.period_s});
    record.blocks = warmupBlocksOf(moments, block_s, on_before_s);
    return record;
}

}  // namespace hedr
