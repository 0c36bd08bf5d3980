#include "core/fusion/hypothesis_set.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/fusion/hypothesis_merging.h"

namespace hedr {

namespace {

constexpr std::size_t kMost = 32;
constexpr double kLeastLogWeight = -16.0;  // below the best one

// A robot is set down along a corridor, by eye, or it is not, or there are no corridors. Who was
// not set down along a corridor need not begin by driving along one.
struct SetDown {
    double share;
    double grid_sigma_rad;
    LegKind last;
    bool building;
};
constexpr double kAnyGridSigma_rad = radFromDeg(26.0);  // of a uniform quarter turn
constexpr std::array kSetDown{SetDown{0.77, radFromDeg(0.5), LegKind::kCorridor, true},
                              SetDown{0.15, kAnyGridSigma_rad, LegKind::kNone, true},
                              SetDown{0.08, kAnyGridSigma_rad, LegKind::kNone, false}};

// Of the alignment more than of its lines.
constexpr double kDirectionOfAPlan_rad = radFromDeg(0.5);

struct Guess {
    double share;
    double value;
};

// The walk of a bias of which nothing is known, usual or several times worse.
std::vector<Guess> biasWalks_rad_s_sqrts(const DrivingModel& model) {
    const double usual = model.bias_walk_rad_s_sqrts;
    if (model.worse_walk == 1.0) return {{1.0, usual}};
    return {{0.8, usual}, {0.2, model.worse_walk * usual}};
}

// A gyro may be as it left its maker, or somebody has calibrated it.
std::vector<Guess> biases_rad_s(const DrivingModel& model) {
    if (model.calibrated_bias_rad_s == 0.0) return {{1.0, model.bias_rad_s}};
    return {{0.5, model.bias_rad_s}, {0.5, model.calibrated_bias_rad_s}};
}

// Mean length of a leg: nobody drives far along no corridor.
constexpr double kCorridorLeg_m = 40.0;
constexpr double kOwnLeg_m = 10.0;

struct Shares {
    double corridor;
    double diagonal;
    double own;
};

// What kind of leg follows which. Who has left the corridors has something to do there.
Shares sharesAfter(LegKind last) {
    switch (last) {
        case LegKind::kNone:
            return {0.50, 0.01, 0.49};
        case LegKind::kCorridor:
            return {0.90, 0.01, 0.09};
        case LegKind::kDiagonal:
            return {0.50, 0.40, 0.10};
        case LegKind::kOwn:
        case LegKind::kOwnBent:
            return {0.40, 0.02, 0.58};
    }
    return {};
}

bool offTheCorridors(const WeightedHypothesis& each) {
    return each.building && (each.leg == LegKind::kOwn || each.leg == LegKind::kOwnBent);
}

double meanLeg_m(const WeightedHypothesis& each) {
    return offTheCorridors(each) ? kOwnLeg_m : kCorridorLeg_m;
}

// The legs that are parallel to a direction of the building, `offset_rad` off its corridors.
void addLegsAlong(const WeightedHypothesis& parent, LegKind kind, double share, double offset_rad,
                  const DrivingModel& model, std::vector<WeightedHypothesis>& children) {
    const double from_grid = parent.hypothesis.fromGrid_rad();
    const double sigma = std::sqrt(parent.hypothesis.fromGridVariance()) + model.zigzag_rad;
    const double reach = std::max(3.0 * sigma, 0.5 * kQuarterTurn_rad);
    // A belief that is wide may lie near several corridors' directions.
    const double nearest = std::round((from_grid - offset_rad) / kQuarterTurn_rad);
    for (double k = nearest - 2.0; k <= nearest + 2.0; ++k) {
        const double direction = k * kQuarterTurn_rad + offset_rad;
        if (std::abs(from_grid - direction) > reach) continue;
        WeightedHypothesis child = parent;
        child.log_weight += std::log(share) + child.hypothesis.beginLegAlong(direction, model);
        child.hypothesis.turnGrid(k * kQuarterTurn_rad);
        child.leg = kind;
        children.push_back(child);
    }
}

void addFreeLegs(const WeightedHypothesis& parent, double share, const DrivingModel& model,
                 std::vector<WeightedHypothesis>& children) {
    WeightedHypothesis child = parent;
    child.hypothesis.beginFreeLeg(model);
    const auto add = [&](LegKind kind, double share_of_kind) {
        if (share_of_kind <= 0.0) return;
        child.log_weight = parent.log_weight + std::log(share * share_of_kind / kQuarterTurn_rad);
        child.leg = kind;
        children.push_back(child);
    };
    // How a robot drives where there is no building tells nothing: all its ways are one kind.
    const double bent = parent.building ? model.bent_share : 0.0;
    add(LegKind::kOwn, 1.0 - bent);
    add(LegKind::kOwnBent, bent);
}

void addChildren(const WeightedHypothesis& parent, const DrivingModel& model,
                 std::vector<WeightedHypothesis>& children) {
    const Shares shares = sharesAfter(parent.last);
    if (parent.building) {
        addLegsAlong(parent, LegKind::kCorridor, shares.corridor, 0.0, model, children);
        addLegsAlong(parent, LegKind::kDiagonal, shares.diagonal, 0.5 * kQuarterTurn_rad, model,
                     children);
    }
    addFreeLegs(parent, parent.building ? shares.own : 1.0, model, children);
}

double driveLegOf(WeightedHypothesis& each, const MotionSegment& segment,
                  const DrivingModel& model) {
    if (!offTheCorridors(each)) return each.hypothesis.driveLegAlong(segment, model);
    const bool bent = each.leg == LegKind::kOwnBent;
    return each.hypothesis.driveFreeLeg(
        segment, bent ? model.bend_rad_sqrtm : model.wander_rad_sqrtm, model);
}

}  // namespace

HypothesisSet::HypothesisSet(const Pose<World>& start, double bias_rad_s,
                             const DrivingModel& model) {
    DrivingModel guessed = model;
    for (const Guess& walk : biasWalks_rad_s_sqrts(model)) {
        guessed.bias_walk_rad_s_sqrts = walk.value;
        for (const Guess& bias : biases_rad_s(model)) {
            guessed.bias_rad_s = bias.value;
            for (const SetDown& how : kSetDown) {
                const HeadingHypothesis hypothesis(start, how.grid_sigma_rad, bias_rad_s, guessed);
                hypotheses_.push_back({hypothesis, std::log(walk.share * bias.share * how.share),
                                       LegKind::kNone, how.last, how.building});
            }
        }
    }
}

void HypothesisSet::move(const MotionSegment& segment, const DrivingModel& model) {
    for (WeightedHypothesis& each : hypotheses_) each.hypothesis.move(segment, model);
}

void HypothesisSet::hearWitness(const MotionSegment& segment, double noise_rad2_s,
                                const DrivingModel& model) {
    for (WeightedHypothesis& each : hypotheses_)
        each.log_weight += each.hypothesis.hearWitness(segment, noise_rad2_s, model);
    normalise();
}

void HypothesisSet::loosen(double sigma_rad) {
    for (WeightedHypothesis& each : hypotheses_) each.hypothesis.loosen(sigma_rad);
}

void HypothesisSet::hearDirection(double direction_rad, bool anew) {
    if (anew) forgetDirection();
    for (WeightedHypothesis& each : hypotheses_) {
        const double likelihood =
            each.hypothesis.hearDirection(direction_rad, kDirectionOfAPlan_rad);
        // Where nothing runs in few directions a plan may show any.
        each.log_weight += each.building ? likelihood : -std::log(kQuarterTurn_rad);
    }
    normalise();
}

void HypothesisSet::forgetDirection() {
    for (WeightedHypothesis& each : hypotheses_) each.hypothesis.loosenGrid(kAnyGridSigma_rad);
}

void HypothesisSet::standStill(const MotionSegment& segment, const DrivingModel& model) {
    for (WeightedHypothesis& each : hypotheses_)
        each.log_weight += each.hypothesis.standStill(segment, model);
    normalise();
}

void HypothesisSet::beginLeg(const DrivingModel& model) {
    std::vector<WeightedHypothesis> children;
    children.reserve(4 * hypotheses_.size());
    for (const WeightedHypothesis& parent : hypotheses_) addChildren(parent, model, children);
    hypotheses_ = std::move(children);
    normalise();
}

// That a leg goes on, and later that it ends, tells its kind: lengths are exponential. Where there
// is no building nobody need drive straight, so this tells nothing for or against one; the
// directions of the legs do.
void HypothesisSet::driveLeg(const MotionSegment& segment, const DrivingModel& model) {
    double before = 0.0;
    double after = 0.0;
    for (WeightedHypothesis& each : hypotheses_) {
        if (!each.building) continue;
        before += each.weight();
        each.log_weight += driveLegOf(each, segment, model);
        each.log_weight -= segment.path_m / meanLeg_m(each);
        after += each.weight();
    }
    for (WeightedHypothesis& each : hypotheses_)
        if (!each.building && before > 0.0) each.log_weight += std::log(after / before);
    normalise();
}

void HypothesisSet::endLeg() {
    for (WeightedHypothesis& each : hypotheses_) {
        if (offTheCorridors(each)) each.log_weight += std::log(kCorridorLeg_m / kOwnLeg_m);
        each.last = each.leg;
        each.leg = LegKind::kNone;
    }
    normalise();
    merge();
}

void HypothesisSet::merge() { mergeClose(hypotheses_); }

void HypothesisSet::normalise() {
    double best = -std::numeric_limits<double>::infinity();
    for (const WeightedHypothesis& each : hypotheses_) best = std::max(best, each.log_weight);
    if (!std::isfinite(best)) {  // numbers beyond reason make none likelier
        for (WeightedHypothesis& each : hypotheses_) each.log_weight = best = 0.0;
    }
    std::erase_if(hypotheses_, [best](const WeightedHypothesis& each) {
        return !(each.log_weight > best + kLeastLogWeight);
    });
    if (hypotheses_.size() > kMost) {
        std::nth_element(hypotheses_.begin(), hypotheses_.begin() + kMost, hypotheses_.end(),
                         [](const auto& a, const auto& b) { return a.log_weight > b.log_weight; });
        hypotheses_.resize(kMost, hypotheses_.front());
    }
    double sum = 0.0;
    for (const WeightedHypothesis& each : hypotheses_) sum += std::exp(each.log_weight - best);
    for (WeightedHypothesis& each : hypotheses_) each.log_weight -= best + std::log(sum);
}

}  // namespace hedr
