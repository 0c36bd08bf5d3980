#include "core/track/evaluation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/geometry/angle.h"

namespace hedr {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// Without a heading, the first part of the path stands for it: so long that what a satellite fix is
// off turns it little, for a metre or two of noise would turn a shorter one by many degrees. The
// way from the start counts too, because noise alone makes a path while the robot stands.
constexpr double kStartShare = 0.2;
constexpr double kLeastStartPath_m = 2.0;
constexpr double kLeastStartDistance_m = 0.5;

struct Match {
    const TrackPoint* estimate;
    const TrackPoint* truth;
};

// The track itself where its times ascend, as they nearly always do, else a sorted copy.
class Ordered {
  public:
    explicit Ordered(const std::vector<TrackPoint>& track) : track_(&track) {
        const auto earlier = [](const TrackPoint& a, const TrackPoint& b) { return a.t_s < b.t_s; };
        if (std::is_sorted(track.begin(), track.end(), earlier)) return;
        sorted_ = track;
        std::stable_sort(sorted_.begin(), sorted_.end(), earlier);
        track_ = &sorted_;
    }
    Ordered(const Ordered&) = delete;
    Ordered& operator=(const Ordered&) = delete;
    const std::vector<TrackPoint>& get() const { return *track_; }

  private:
    const std::vector<TrackPoint>* track_;
    std::vector<TrackPoint> sorted_;
};

double medianPeriod(const std::vector<TrackPoint>& track) {
    if (track.size() < 2) return 0.0;
    std::vector<double> periods(track.size() - 1);
    for (std::size_t i = 0; i < periods.size(); ++i) periods[i] = track[i + 1].t_s - track[i].t_s;
    const auto middle = periods.begin() + static_cast<std::ptrdiff_t>(periods.size() / 2);
    std::nth_element(periods.begin(), middle, periods.end());
    return *middle;
}

double timeApart(const Match& match) { return std::abs(match.estimate->t_s - match.truth->t_s); }

std::vector<Match> matchByTime(const std::vector<TrackPoint>& estimate,
                               const std::vector<TrackPoint>& truth) {
    std::vector<Match> matches;
    if (estimate.empty()) return matches;
    matches.reserve(truth.size());
    // A little more than half, so that a sample exactly in the middle counts despite rounding.
    const double tolerance_s =
        0.5 * std::max(medianPeriod(estimate), medianPeriod(truth)) * (1.0 + 1e-6) + 1e-9;
    std::size_t i = 0;
    for (const TrackPoint& pose : truth) {
        while (i + 1 < estimate.size() &&
               (estimate[i + 1].t_s == estimate[i].t_s ||
                std::abs(estimate[i + 1].t_s - pose.t_s) < std::abs(estimate[i].t_s - pose.t_s)))
            ++i;
        const Match match{&estimate[i], &pose};
        if (timeApart(match) > tolerance_s) continue;
        if (matches.empty() || matches.back().estimate != match.estimate) {
            matches.push_back(match);
        } else if (timeApart(match) < timeApart(matches.back())) {
            matches.back() = match;
        }
    }
    return matches;
}

Vector<World> offsetFrom(const TrackPoint* from, const TrackPoint* to) {
    return to->pose.position - from->pose.position;
}

double pathLength(const TrackPoint* first, const TrackPoint* last) {
    double length = 0.0;
    for (; first != last; ++first) length += offsetFrom(first, first + 1).length();
    return length;
}

// Sums over pairs of vectors; the angle that turns the first ones best onto the second ones.
struct RotationFit {
    double dot = 0.0;
    double cross = 0.0;

    void add(Vector<World> from, Vector<World> to) {
        dot += from.x * to.x + from.y * to.y;
        cross += from.x * to.y - from.y * to.x;
    }
    double angle_rad() const { return std::atan2(cross, dot); }
};

// How far the estimate must be turned so that it starts as the truth does.
double startRotation(const std::vector<Match>& matches) {
    const Match& first = matches.front();
    const double turn = first.truth->pose.heading_rad - first.estimate->pose.heading_rad;
    if (!std::isnan(turn)) return turn;
    const double whole_m = pathLength(first.estimate, matches.back().estimate);
    const double enough_m = std::max(kStartShare * whole_m, kLeastStartPath_m);
    RotationFit fit;
    double path_m = 0.0;
    double farthest_m = 0.0;
    const TrackPoint* before = first.estimate;
    for (const auto& [estimate, truth] : matches) {
        path_m += pathLength(before, estimate);
        before = estimate;
        if (path_m > enough_m && farthest_m > kLeastStartDistance_m) break;
        const Vector<World> driven = offsetFrom(first.truth, truth);
        farthest_m = std::max(farthest_m, driven.length());
        fit.add(offsetFrom(first.estimate, estimate), driven);
    }
    return fit.angle_rad();
}

Transform<World, World> turnAbout(Point<World> from, double angle_rad, Point<World> to) {
    const auto turn = rigidTransform<World, World>({{}, angle_rad});
    const Point<World> turned = turn * from;
    return {turn.linear(), {to.x - turned.x, to.y - turned.y}};
}

struct Alignment2d {
    Transform<World, World> transform{};
    double rotation_rad = 0.0;
};

Alignment2d alignStart(const std::vector<Match>& matches) {
    const double angle = startRotation(matches);
    return {turnAbout(matches.front().estimate->pose.position, angle,
                      matches.front().truth->pose.position),
            angle};
}

Alignment2d alignRigid(const std::vector<Match>& matches) {
    Vector<World> estimate_sum;
    Vector<World> truth_sum;
    for (const Match& match : matches) {
        estimate_sum = estimate_sum + (match.estimate->pose.position - Point<World>{});
        truth_sum = truth_sum + (match.truth->pose.position - Point<World>{});
    }
    const double share = 1.0 / static_cast<double>(matches.size());
    const Point<World> estimate_mean = Point<World>{} + share * estimate_sum;
    const Point<World> truth_mean = Point<World>{} + share * truth_sum;
    RotationFit fit;
    for (const Match& match : matches)
        fit.add(match.estimate->pose.position - estimate_mean,
                match.truth->pose.position - truth_mean);
    const double angle = fit.angle_rad();
    return {turnAbout(estimate_mean, angle, truth_mean), angle};
}

Alignment2d align(const std::vector<Match>& matches, Alignment alignment) {
    switch (alignment) {
        case Alignment::kNone:
            return {};
        case Alignment::kStart:
            return alignStart(matches);
        case Alignment::kRigid:
            return alignRigid(matches);
    }
    return {};
}

void evaluatePositions(const std::vector<Match>& matches, const Transform<World, World>& truth_from,
                       Evaluation& result) {
    std::vector<double> errors;
    errors.reserve(matches.size());
    double sum = 0.0;
    double square_sum = 0.0;
    for (const auto& [estimate, truth] : matches) {
        const double error = (truth_from * estimate->pose.position - truth->pose.position).length();
        errors.push_back(error);
        sum += error;
        square_sum += error * error;
    }
    const auto n = static_cast<double>(errors.size());
    result.end_position_error_m = errors.back();
    result.ape_mean_m = sum / n;
    result.ape_rmse_m = std::sqrt(square_sum / n);
    const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
    std::nth_element(errors.begin(), middle, errors.end());
    result.ape_median_m = *middle;
    if (errors.size() % 2 == 0)
        result.ape_median_m = 0.5 * (*middle + *std::max_element(errors.begin(), middle));
    result.ape_max_m = *std::max_element(middle, errors.end());
}

void evaluateHeadings(const std::vector<Match>& matches, double rotation_rad, Evaluation& result) {
    double error = 0.0;
    double square_sum = 0.0;
    double largest = 0.0;
    std::size_t count = 0;
    for (const auto& [estimate, truth] : matches) {
        const double raw = estimate->pose.heading_rad + rotation_rad - truth->pose.heading_rad;
        if (std::isnan(raw)) continue;
        // The error changes slowly, however fast the robot turns: it can be followed over turns.
        error += wrapAngle(raw - error);
        square_sum += error * error;
        largest = std::max(largest, std::abs(error));
        ++count;
    }
    const bool none = count == 0;
    result.end_heading_error_deg = none ? kNan : degFromRad(error);
    result.heading_rmse_deg =
        none ? kNan : degFromRad(std::sqrt(square_sum / static_cast<double>(count)));
    result.heading_max_deg = none ? kNan : degFromRad(largest);
}

}  // namespace

Result<Evaluation> evaluate(const std::vector<TrackPoint>& estimate,
                            const std::vector<TrackPoint>& truth, Alignment alignment) {
    const Ordered ordered_estimate(estimate);
    const Ordered ordered_truth(truth);
    const auto matches = matchByTime(ordered_estimate.get(), ordered_truth.get());
    if (matches.empty())
        return fail(ErrorCode::kNoData, "evaluate",
                    "no pose of the track matches the truth in time");

    Evaluation result;
    result.samples = matches.size();
    result.duration_s = matches.back().truth->t_s - matches.front().truth->t_s;
    result.distance_m = pathLength(matches.front().truth, matches.back().truth);
    const auto& run = ordered_estimate.get();
    result.return_position_error_m = offsetFrom(&run.front(), &run.back()).length();
    result.return_position_error_percent =
        result.distance_m > 0.0 ? 100.0 * result.return_position_error_m / result.distance_m : kNan;
    const Alignment2d aligned = align(matches, alignment);
    evaluatePositions(matches, aligned.transform, result);
    evaluateHeadings(matches, aligned.rotation_rad, result);
    return result;
}

}  // namespace hedr
