#include "core/fusion/hypothesis_set.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hedr {

namespace {

constexpr double kCell_rad = kPi / 2.0;  // the building looks the same after a quarter turn
constexpr std::size_t kMost = 32;
constexpr double kLeastLogWeight = -16.0;  // below the best one
constexpr double kMergeCost = 0.02;        // Runnalls' bound, weighted

constexpr double kAgree_rad = radFromDeg(8.0);
constexpr double kAgree_m = 2.5;
constexpr double kSwitching = 1.0;  // log weight by which another one must be better
constexpr double kStandsOut = 0.5;
constexpr double kWorthShowing = -6.9;  // log of 0.001

// A robot is set down along a corridor, by eye, or it is not, or there are no corridors.
constexpr double kStartAlong = 0.70;
constexpr double kStartAnyhow = 0.27;
constexpr double kOpenGround = 0.03;
constexpr double kStartAlongSigma_rad = radFromDeg(0.5);
constexpr double kAnyGridSigma_rad = radFromDeg(26.0);  // of a uniform quarter turn

// Mean length of a leg: nobody drives far along no corridor.
constexpr double kCorridorLeg_m = 40.0;
constexpr double kOwnLeg_m = 10.0;

bool agree(const Pose<World>& a, const Pose<World>& b) {
    return std::abs(a.heading_rad - b.heading_rad) < kAgree_rad &&
           (a.position - b.position).length() < kAgree_m;
}

struct Shares {
    double corridor;
    double diagonal;
    double own;
};

// What kind of leg follows which.
Shares sharesAfter(LegKind last) {
    switch (last) {
        case LegKind::kNone:
        case LegKind::kCorridor:
            return {0.90, 0.01, 0.09};
        case LegKind::kDiagonal:
            return {0.50, 0.40, 0.10};
        case LegKind::kOwn:
            return {0.55, 0.02, 0.43};
    }
    return {};
}

constexpr std::array kCompared{HeadingHypothesis::kHeading, HeadingHypothesis::kBias,
                               HeadingHypothesis::kGrid};
using Compared = Eigen::Matrix3d;

Compared comparedCovariance(const HeadingHypothesis& h) {
    // What is known exactly, as the bias of encoders, must not make the determinant vanish.
    const Eigen::Vector3d least(1e-8, 1e-12, 1e-8);
    return h.covariance()(kCompared, kCompared) + least.asDiagonal().toDenseMatrix();
}

// Runnalls 2007: how much the merging of two Gaussians may cost, as a Kullback-Leibler bound.
double mergeCost(const HeadingHypothesis& a, double weight_a, const HeadingHypothesis& b,
                 double weight_b) {
    const Eigen::Vector3d apart = a.mean()(kCompared) - b.mean()(kCompared);
    const double share = weight_a / (weight_a + weight_b);
    const Compared pa = comparedCovariance(a);
    const Compared pb = comparedCovariance(b);
    const Compared both =
        share * pa + (1.0 - share) * pb + share * (1.0 - share) * apart * apart.transpose();
    return 0.5 * ((weight_a + weight_b) * std::log(both.determinant()) -
                  weight_a * std::log(pa.determinant()) - weight_b * std::log(pb.determinant()));
}

}  // namespace

HypothesisSet::HypothesisSet(const Pose<World>& start, double bias_rad_s, const DrivingModel& model)
    : model_(model) {
    const auto add = [&](double share, double grid_sigma_rad, bool building) {
        hypotheses_.push_back({HeadingHypothesis(start, grid_sigma_rad, bias_rad_s, model),
                               std::log(share), LegKind::kNone, LegKind::kCorridor, building});
    };
    add(kStartAlong, kStartAlongSigma_rad, true);
    add(kStartAnyhow, kAnyGridSigma_rad, true);
    add(kOpenGround, kAnyGridSigma_rad, false);
    summarise(start);
}

void HypothesisSet::move(const MotionSegment& segment) {
    for (Weighted& each : hypotheses_) each.hypothesis.move(segment, model_);
}

void HypothesisSet::loosen(double sigma_rad) {
    for (Weighted& each : hypotheses_) each.hypothesis.loosen(sigma_rad);
}

void HypothesisSet::standStill(const MotionSegment& segment) {
    for (Weighted& each : hypotheses_)
        each.log_weight += each.hypothesis.standStill(segment, model_);
    normalise();
}

void HypothesisSet::addChildren(const Weighted& parent, std::vector<Weighted>& children) const {
    const Shares shares = sharesAfter(parent.last);
    const double from_grid = parent.hypothesis.fromGrid_rad();
    const double sigma = std::sqrt(parent.hypothesis.fromGridVariance()) + model_.zigzag_rad;
    const double reach = std::max(3.0 * sigma, 0.5 * kCell_rad);
    const auto along = [&](LegKind kind, double share, double offset) {
        // A belief that is wide may lie near several corridors' directions.
        const double nearest = std::round((from_grid - offset) / kCell_rad);
        for (double k = nearest - 2.0; k <= nearest + 2.0; ++k) {
            const double direction = k * kCell_rad + offset;
            if (std::abs(from_grid - direction) > reach) continue;
            Weighted child = parent;
            child.log_weight += std::log(share) + child.hypothesis.beginLegAlong(direction, model_);
            child.hypothesis.turnGrid(k * kCell_rad);
            child.leg = kind;
            children.push_back(child);
        }
    };
    if (parent.building) {
        along(LegKind::kCorridor, shares.corridor, 0.0);
        along(LegKind::kDiagonal, shares.diagonal, 0.5 * kCell_rad);
    }
    Weighted own = parent;
    own.hypothesis.beginFreeLeg(model_);
    own.log_weight += std::log((parent.building ? shares.own : 1.0) / kCell_rad);
    own.leg = LegKind::kOwn;
    children.push_back(own);
}

void HypothesisSet::beginLeg() {
    std::vector<Weighted> children;
    children.reserve(4 * hypotheses_.size());
    for (const Weighted& parent : hypotheses_) addChildren(parent, children);
    hypotheses_ = std::move(children);
    normalise();
}

void HypothesisSet::driveLeg(const MotionSegment& segment) {
    for (Weighted& each : hypotheses_) {
        const bool off_corridor = each.leg == LegKind::kOwn && each.building;
        each.log_weight += each.hypothesis.driveLeg(segment, model_, each.building) -
                           segment.path_m / (off_corridor ? kOwnLeg_m : kCorridorLeg_m);
    }
    normalise();
}

void HypothesisSet::endLeg() {
    for (Weighted& each : hypotheses_) {
        each.last = each.leg;
        each.leg = LegKind::kNone;
    }
    merge();
}

void HypothesisSet::normalise() {
    double best = -std::numeric_limits<double>::infinity();
    for (const Weighted& each : hypotheses_) best = std::max(best, each.log_weight);
    std::erase_if(hypotheses_, [best](const Weighted& each) {
        return !(each.log_weight > best + kLeastLogWeight);
    });
    if (hypotheses_.size() > kMost) {
        std::nth_element(
            hypotheses_.begin(), hypotheses_.begin() + kMost, hypotheses_.end(),
            [](const Weighted& a, const Weighted& b) { return a.log_weight > b.log_weight; });
        hypotheses_.resize(kMost, hypotheses_.front());
    }
    double sum = 0.0;
    for (const Weighted& each : hypotheses_) sum += std::exp(each.log_weight - best);
    for (Weighted& each : hypotheses_) each.log_weight -= best + std::log(sum);
}

// The cheapest pair first, until none is cheap.
void HypothesisSet::merge() {
    for (;;) {
        const auto [first, second] = cheapestPair();
        if (first == second) return;
        Weighted& kept = hypotheses_[first];
        const Weighted& gone = hypotheses_[second];
        const double kept_weight = std::exp(kept.log_weight);
        const double gone_weight = std::exp(gone.log_weight);
        if (gone_weight > kept_weight) kept.last = gone.last;
        kept.hypothesis.absorb(gone.hypothesis, kept_weight / (kept_weight + gone_weight));
        kept.log_weight = std::log(kept_weight + gone_weight);
        hypotheses_.erase(hypotheses_.begin() + static_cast<std::ptrdiff_t>(second));
    }
}

// The same index twice where no merge is cheap.
std::pair<std::size_t, std::size_t> HypothesisSet::cheapestPair() const {
    double cheapest = kMergeCost;
    std::pair<std::size_t, std::size_t> pair{0, 0};
    for (std::size_t i = 0; i < hypotheses_.size(); ++i) {
        for (std::size_t j = i + 1; j < hypotheses_.size(); ++j) {
            const Weighted& a = hypotheses_[i];
            const Weighted& b = hypotheses_[j];
            const double apart = a.hypothesis.fromGrid_rad() - b.hypothesis.fromGrid_rad();
            if (a.building != b.building || std::abs(apart) > 0.25 * kCell_rad) continue;
            const double cost = mergeCost(a.hypothesis, std::exp(a.log_weight), b.hypothesis,
                                          std::exp(b.log_weight));
            if (cost >= cheapest) continue;
            cheapest = cost;
            pair = {i, j};
        }
    }
    return pair;
}

double HypothesisSet::shareNear(const Pose<World>& pose) const {
    double share = 0.0;
    for (const Weighted& each : hypotheses_)
        if (agree(each.hypothesis.pose(), pose)) share += std::exp(each.log_weight);
    return share;
}

// The likeliest one; what is shown now has an advantage, so that the map does not flicker. Where
// none stands out, dead reckoning that trusts no building is the better guess.
const HypothesisSet::Weighted& HypothesisSet::chosen(const Pose<World>& shown) const {
    const auto rank = [&shown](const Weighted& each) {
        return each.log_weight + (agree(each.hypothesis.pose(), shown) ? kSwitching : 0.0);
    };
    const Weighted& best = *std::max_element(
        hypotheses_.begin(), hypotheses_.end(),
        [&rank](const Weighted& a, const Weighted& b) { return rank(a) < rank(b); });
    if (shareNear(best.hypothesis.pose()) > kStandsOut) return best;
    const auto open_ground = std::find_if(
        hypotheses_.begin(), hypotheses_.end(),
        [](const Weighted& each) { return !each.building && each.log_weight > kWorthShowing; });
    return open_ground == hypotheses_.end() ? best : *open_ground;
}

void HypothesisSet::summarise(const Pose<World>& shown) {
    const Weighted& best = chosen(shown);
    const Pose<World> best_pose = best.hypothesis.pose();
    // A sum of differences, so that hypotheses that are one and the same change nothing.
    HeadingHypothesis::StateVector shift = HeadingHypothesis::StateVector::Zero();
    double share = 0.0;
    for (const Weighted& each : hypotheses_) {
        if (!agree(each.hypothesis.pose(), best_pose)) continue;
        if (each.log_weight < best.log_weight + kWorthShowing) continue;
        const double weight = std::exp(each.log_weight);
        shift += weight * (each.hypothesis.mean() - best.hypothesis.mean());
        share += weight;
    }
    const HeadingHypothesis::StateVector mean = best.hypothesis.mean() + shift / share;
    belief_.share = shareNear(best_pose);
    belief_.pose = {{mean[HeadingHypothesis::kX], mean[HeadingHypothesis::kY]},
                    mean[HeadingHypothesis::kHeading]};
    belief_.bias_rad_s = mean[HeadingHypothesis::kBias];
    belief_.scale = mean[HeadingHypothesis::kScale];
    belief_.curvature_rad_m = mean[HeadingHypothesis::kCurvature];
    belief_.leg = best.leg;
    belief_.building = best.building;
    spreadAround(mean);
}

// The mixture's covariance, about what is shown.
void HypothesisSet::spreadAround(const HeadingHypothesis::StateVector& mean) {
    belief_.covariance.setZero();
    double from_grid_variance = 0.0;
    for (const Weighted& each : hypotheses_) {
        const double weight = std::exp(each.log_weight);
        const Eigen::Vector3d apart = each.hypothesis.mean().head<3>() - mean.head<3>();
        belief_.covariance += weight * (each.hypothesis.covariance().topLeftCorner<3, 3>() +
                                        apart * apart.transpose());
        from_grid_variance += weight * (each.hypothesis.fromGridVariance() + apart.z() * apart.z());
    }
    belief_.sigma_rad = std::sqrt(from_grid_variance);
}

}  // namespace hedr
