#include "core/calibration/compass/magnetic_turns.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/calibration/median.h"
#include "core/geometry/angle.h"

namespace hedr {

namespace {

using MagneticSamples = std::vector<MagneticSample>;

constexpr double kSlowestTurn_rad_s = radFromDeg(4.0);
constexpr double kLeastStretch_rad = radFromDeg(90.0);
constexpr double kAroundSample_s = 0.5;   // within which it has to turn
constexpr double kLongestPause_s = 3.0;   // within a stretch
constexpr double kLeastAxleShare = 0.25;  // of the wheelbase: how far the turn's centre may be off
constexpr double kSmallAxle_m = 0.1;
constexpr std::size_t kMostSamples = 4000;
constexpr double kRoughStep_rad = 0.5;  // of the field's angle from one reading to the next
constexpr double kTurnsForWholeParts = 8.0;

// The angle of the field takes the place of a judge's heading.
bool turnByField(MagneticSamples& samples, int sense) {
    std::vector<Eigen::Vector2d> field;
    field.reserve(samples.size());
    for (const MagneticSample& sample : samples) field.emplace_back(sample.field.head<2>());
    if (field.empty()) return false;
    const auto ellipse = directEllipse(field);
    if (!ellipse) return false;
    std::vector<double> steps_rad;
    steps_rad.reserve(samples.size());
    double turned_rad = 0.0;
    double last_rad = ellipse->angleOf(field.front());
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double angle_rad = ellipse->angleOf(field[i]);
        const double step_rad = wrapAngle(angle_rad - last_rad);
        last_rad = angle_rad;
        turned_rad -= sense * step_rad;  // a heading to the left turns the field to the right
        samples[i].turned_rad = turned_rad;
        steps_rad.push_back(std::abs(step_rad));
    }
    return medianOf(std::move(steps_rad)) < kRoughStep_rad;
}

// 1, -1: it turns on the spot around that reading; 0: it does not.
std::vector<int> waysOf(const MagneticSamples& samples, double wheelbase_m) {
    const double farthest_m = std::max(kSmallAxle_m, kLeastAxleShare * wheelbase_m);
    std::vector<int> ways(samples.size(), 0);
    std::size_t from = 0;
    std::size_t to = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        while (samples[from].t_s < samples[i].t_s - kAroundSample_s) ++from;
        while (to + 1 < samples.size() && samples[to + 1].t_s <= samples[i].t_s + kAroundSample_s)
            ++to;
        const double span_s = samples[to].t_s - samples[from].t_s;
        const double turned_rad = samples[to].turned_rad - samples[from].turned_rad;
        const double travelled_m = std::abs(samples[to].travelled_m - samples[from].travelled_m);
        if (!(std::abs(turned_rad) > kSlowestTurn_rad_s * span_s) || span_s <= 0.0) continue;
        if (travelled_m <= farthest_m * std::abs(turned_rad)) ways[i] = turned_rad > 0.0 ? 1 : -1;
    }
    return ways;
}

// Adds what is long enough of one log.
class StretchCollector {
  public:
    StretchCollector(MagneticTurns& turns, std::size_t log) : turns_(turns), log_(log) {}

    void add(const MagneticSample& sample, int way) {
        if (way == 0) return;
        const bool goes_on =
            way == way_ && !open_.empty() && sample.t_s - open_.back().t_s <= kLongestPause_s;
        if (!goes_on) close();
        way_ = way;
        open_.push_back(sample);
    }
    void close() {
        const double turned_rad =
            open_.empty() ? 0.0 : open_.back().turned_rad - open_.front().turned_rad;
        if (std::abs(turned_rad) >= kLeastStretch_rad) {
            const std::size_t first = turns_.samples.size();
            turns_.samples.insert(turns_.samples.end(), open_.begin(), open_.end());
            turns_.stretches.push_back({log_, first, turns_.samples.size(), turned_rad});
        }
        open_.clear();
    }

  private:
    MagneticTurns& turns_;
    std::size_t log_;
    int way_ = 0;
    MagneticSamples open_{};
};

MagneticSample meanOf(std::span<const MagneticSample> samples) {
    MagneticSample mean{0.0, Eigen::Vector3d::Zero()};
    const double share = 1.0 / static_cast<double>(samples.size());
    for (const MagneticSample& sample : samples) {
        mean.t_s += share * sample.t_s;
        mean.field += share * sample.field;
        mean.turned_rad += share * sample.turned_rad;
        mean.travelled_m += share * sample.travelled_m;
    }
    return mean;
}

MagneticTurns thinned(MagneticTurns turns) {
    const std::size_t together = (turns.samples.size() + kMostSamples - 1) / kMostSamples;
    if (together <= 1) return turns;
    MagneticTurns thin{.judge = turns.judge};
    for (MagneticStretch stretch : turns.stretches) {
        const std::span all =
            std::span(turns.samples).subspan(stretch.first, stretch.last - stretch.first);
        stretch.first = thin.samples.size();
        for (std::size_t i = 0; i + together <= all.size(); i += together) {
            thin.samples.push_back(meanOf(all.subspan(i, together)));
        }
        stretch.last = thin.samples.size();
        thin.stretches.push_back(stretch);
    }
    return thin;
}

bool allHaveJudge(std::span<const MagneticLog> logs) {
    return std::all_of(logs.begin(), logs.end(), [](const MagneticLog& log) {
        return log.samples.empty() || log.judge != HeadingJudge::kNone;
    });
}

void cutStretch(const MagneticTurns& turns, std::size_t index, double part_rad,
                std::vector<MagneticPart>& parts) {
    const MagneticStretch& stretch = turns.stretches[index];
    const double count = std::max(1.0, std::round(std::abs(stretch.turned_rad) / part_rad));
    const double begin_rad = turns.samples[stretch.first].turned_rad;
    std::size_t first = stretch.first;
    for (double piece = 1.0; piece <= count; piece += 1.0) {
        const double share = piece / count;
        std::size_t last = first;
        while (last < stretch.last &&
               (piece == count ||
                (turns.samples[last].turned_rad - begin_rad) / stretch.turned_rad < share)) {
            ++last;
        }
        if (last > first) parts.push_back({index, first, last});
        first = last;
    }
}

}  // namespace

double MagneticTurns::turned_rad() const { return turned_rad(1) + turned_rad(-1); }

double MagneticTurns::turned_rad(int way) const {
    double sum = 0.0;
    for (const MagneticStretch& stretch : stretches) sum += std::max(0.0, way * stretch.turned_rad);
    return sum;
}

FieldReadings MagneticTurns::readings() const {
    FieldReadings result;
    result.field.reserve(samples.size());
    for (const MagneticSample& sample : samples) result.field.emplace_back(sample.field.head<2>());
    for (const MagneticStretch& stretch : stretches) result.begins.push_back(stretch.first);
    return result;
}

MagneticTurns magneticTurnsIn(std::span<const MagneticLog> logs,
                              const MagneticTurnOptions& options) {
    MagneticTurns turns;
    const bool judged_all = allHaveJudge(logs);
    for (std::size_t i = 0; i < logs.size(); ++i) {
        MagneticSamples samples = logs[i].samples;
        if (!judged_all && !turnByField(samples, options.sense)) continue;
        if (judged_all && logs[i].judge != HeadingJudge::kNone) turns.judge = logs[i].judge;
        const std::vector<int> ways = waysOf(samples, options.wheelbase_m);
        StretchCollector collector(turns, i);
        for (std::size_t j = 0; j < samples.size(); ++j) collector.add(samples[j], ways[j]);
        collector.close();
    }
    return thinned(std::move(turns));
}

MagneticTurns withoutOutliers(const MagneticTurns& turns, const Eigen::VectorXd& weight) {
    MagneticTurns counted{.judge = turns.judge};
    for (MagneticStretch stretch : turns.stretches) {
        const std::size_t first = counted.samples.size();
        for (std::size_t i = stretch.first; i < stretch.last; ++i) {
            if (weight(static_cast<Eigen::Index>(i)) <= 0.0) continue;
            counted.samples.push_back(turns.samples[i]);
        }
        stretch.first = first;
        stretch.last = counted.samples.size();
        if (stretch.last > first) counted.stretches.push_back(stretch);
    }
    return counted;
}

std::vector<MagneticPart> partsOf(const MagneticTurns& turns, double part_rad) {
    std::vector<MagneticPart> parts;
    for (std::size_t i = 0; i < turns.stretches.size(); ++i) cutStretch(turns, i, part_rad, parts);
    return parts;
}

std::vector<MagneticPart> heldOutPartsOf(const MagneticTurns& turns) {
    constexpr double kTurn_rad = 2.0 * kPi;
    const bool whole = turns.turned_rad() >= kTurnsForWholeParts * kTurn_rad - kPi;
    return partsOf(turns, whole ? kTurn_rad : kPi);
}

}  // namespace hedr
