#include "core/site/survey/directions.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/geometry/angle.h"
#include "core/site/placement_moves.h"
#include "core/site/survey/segments.h"

namespace hedr {
namespace {

constexpr int kLargestSide_px = 2100;       // of the picture that is looked at
constexpr double kFold = kPi / 2;           // walls at right angles have one direction
constexpr int kBins = 360;                  // of a quarter of a degree
constexpr int kCrowd = 3;                   // bins on either side that count, ever less
constexpr double kAlong = radFromDeg(1.5);  // as near to the direction, a line counts as along it
constexpr double kSharpest = radFromDeg(0.1);
constexpr int kRounds = 12;
constexpr double kLeastConfidence = 0.4;

// The finest level that is not larger than need be.
const PlanLevel& levelFor(const PlanImage& plan) {
    const auto fits = [](const PlanLevel& level) {
        return std::max(level.width_px, level.height_px) <= kLargestSide_px;
    };
    const auto found = std::ranges::find_if(plan.levels, fits);
    return found == plan.levels.end() ? plan.levels.back() : *found;
}

double folded(double angle_rad) { return angle_rad - kFold * std::floor(angle_rad / kFold); }

// Long lines are walls more often than short ones, and known better.
double weightOf(const Segment& segment) { return segment.length_px * segment.length_px; }

// The middle of the most crowded degree.
double crowdedAngle(const std::vector<Segment>& segments) {
    std::array<double, kBins> weights{};
    for (const Segment& segment : segments) {
        const int bin = static_cast<int>(folded(segment.angle_rad) / kFold * kBins) % kBins;
        weights[static_cast<std::size_t>(bin)] += weightOf(segment);
    }
    const auto crowd = [&](int bin) {
        double sum = 0.0;
        for (int off = -kCrowd; off <= kCrowd; ++off) {
            const auto near = static_cast<std::size_t>((bin + off + kBins) % kBins);
            sum += (kCrowd + 1 - std::abs(off)) * weights[near];
        }
        return sum;
    };
    int best = 0;
    for (int bin = 1; bin < kBins; ++bin) {
        if (crowd(bin) > crowd(best)) best = bin;
    }
    return (best + 0.5) / kBins * kFold;
}

struct Fit {
    double angle_rad = 0.0;
    double sigma_rad = kAlong;
    double reach_rad = kAlong;  // lines as far off count half
};

// One step of iterated least squares with Cauchy's weights, whose reach is the lines' own scatter.
Fit refitted(const std::vector<Segment>& lines, const Fit& fit) {
    double sum = 0.0;
    double moment = 0.0;
    double square = 0.0;
    double sum_of_squares = 0.0;
    for (const Segment& line : lines) {
        const double off = deviationFromGrid(line.angle_rad - fit.angle_rad, kFold);
        if (std::abs(off) > 2.0 * kAlong) continue;
        const double weight = weightOf(line) / (1.0 + std::pow(off / fit.reach_rad, 2));
        sum += weight;
        moment += weight * off;
        square += weight * off * off;
        sum_of_squares += weight * weight;
    }
    if (sum <= 0.0) return fit;
    const double step = moment / sum;
    const double scatter = std::sqrt(std::max(0.0, square / sum - step * step));
    return {fit.angle_rad + step, scatter * std::sqrt(sum_of_squares) / sum,
            std::clamp(scatter, kSharpest, kAlong)};
}

Fit fitted(const std::vector<Segment>& lines, double angle_rad) {
    Fit fit{.angle_rad = angle_rad};
    for (int round = 0; round < kRounds; ++round) fit = refitted(lines, fit);
    return fit;
}

// How probable it is that the angle is right, from the share of the lines' length that lies along
// it and from that length, in sides of the picture. README.md says where the numbers come from.
double confidenceOf(double share, double sides) {
    constexpr double kTiny = 0.005;
    const double odds = std::max(share, kTiny) / std::max(1.0 - share, kTiny);
    const double z = -0.93 + 0.73 * std::log(odds) + 2.18 * std::log(std::max(sides, kTiny));
    return 1.0 / (1.0 + std::exp(-z));
}

PlanDirections directionsOf(const std::vector<Segment>& segments, double side_px) {
    if (segments.empty()) return {};
    const double roughly = fitted(segments, crowdedAngle(segments)).angle_rad;
    const Fit fit = fitted(linesAlong(segments, roughly), roughly);
    double length_px = 0.0;
    double along_px = 0.0;
    for (const Segment& segment : segments) {
        const double off = deviationFromGrid(segment.angle_rad - fit.angle_rad, kFold);
        length_px += segment.length_px;
        if (std::abs(off) < kAlong) along_px += segment.length_px;
    }
    const double share = along_px / length_px;
    const double confidence = confidenceOf(share, along_px / side_px);
    if (confidence < kLeastConfidence) return {{}, confidence, 0.0, share};
    return {folded(fit.angle_rad), confidence, fit.sigma_rad, share};
}

}  // namespace

Result<PlanDirections> findDirections(const PlanImage& plan, const PlanProgress& progress) {
    if (plan.levels.empty() || !levelFor(plan).pixels) {
        return fail(ErrorCode::kNoData, plan.image_file.string(), "the plan has no pixels");
    }
    const auto canceled = [&](double share) { return progress && !progress(share); };
    if (canceled(0.0)) return fail(ErrorCode::kCanceled, plan.image_file.string());
    const PlanLevel& level = levelFor(plan);
    const std::vector<Segment> segments = segmentsIn(level);
    if (canceled(0.8)) return fail(ErrorCode::kCanceled, plan.image_file.string());
    const double side_px = std::max(level.width_px, level.height_px);
    const PlanDirections directions = directionsOf(withoutHatching(segments, side_px), side_px);
    if (canceled(1.0)) return fail(ErrorCode::kCanceled, plan.image_file.string());
    return directions;
}

std::array<PlanPlacement, 4> placementsAlong(const PlanPlacement& placement, int width_px,
                                             int height_px, const PlanDirections& directions,
                                             double world_direction_rad) {
    const Point<World> middle =
        worldFromPlan(placement, height_px) * Point<Plan>{0.5 * width_px, 0.5 * height_px};
    double nearest = 0.0;
    if (directions.direction_rad) {
        const double now = *directions.direction_rad + placement.origin.heading_rad;
        nearest = deviationFromGrid(world_direction_rad - now, kFold);
    }
    const double back = std::copysign(kFold, -nearest);
    const std::array turns{nearest, nearest + back, nearest - back, nearest + 2.0 * back};
    std::array<PlanPlacement, 4> placements;
    std::ranges::transform(turns, placements.begin(), [&](double turn_rad) {
        return turnedAbout(placement, middle, turn_rad);
    });
    return placements;
}

}  // namespace hedr
