#include "core/fusion/belief.h"

#include <algorithm>
#include <cmath>

namespace hedr {

namespace {

using StateVector = HeadingHypothesis::StateVector;

constexpr double kAgree_rad = radFromDeg(8.0);
constexpr double kAgree_m = 2.5;
constexpr double kSwitching = 1.0;  // log weight by which another one must be better
constexpr double kStandsOut = 0.5;
constexpr double kWorthShowing = -6.9;  // log of 0.001

bool agree(const Pose<World>& a, const Pose<World>& b) {
    return std::abs(a.heading_rad - b.heading_rad) < kAgree_rad &&
           (a.position - b.position).length() < kAgree_m;
}

double shareNear(std::span<const WeightedHypothesis> hypotheses, const Pose<World>& pose) {
    double share = 0.0;
    for (const WeightedHypothesis& each : hypotheses)
        if (agree(each.hypothesis.pose(), pose)) share += each.weight();
    return share;
}

// The likeliest one; what is shown now has an advantage, so that the map does not flicker. Where
// none stands out, dead reckoning that trusts no building is the better guess.
const WeightedHypothesis& chosen(std::span<const WeightedHypothesis> hypotheses,
                                 const Pose<World>& shown) {
    const auto rank = [&shown](const WeightedHypothesis& each) {
        return each.log_weight + (agree(each.hypothesis.pose(), shown) ? kSwitching : 0.0);
    };
    const WeightedHypothesis& best =
        *std::max_element(hypotheses.begin(), hypotheses.end(),
                          [&rank](const auto& a, const auto& b) { return rank(a) < rank(b); });
    if (shareNear(hypotheses, best.hypothesis.pose()) > kStandsOut) return best;
    const auto open_ground =
        std::find_if(hypotheses.begin(), hypotheses.end(), [](const WeightedHypothesis& each) {
            return !each.building && each.log_weight > kWorthShowing;
        });
    return open_ground == hypotheses.end() ? best : *open_ground;
}

// A sum of differences, so that hypotheses that are one and the same change nothing.
StateVector meanAround(const WeightedHypothesis& best,
                       std::span<const WeightedHypothesis> hypotheses) {
    StateVector shift = StateVector::Zero();
    double share = 0.0;
    for (const WeightedHypothesis& each : hypotheses) {
        const double apart_rad = each.hypothesis.heading_rad() - best.hypothesis.heading_rad();
        if (std::abs(apart_rad) > 0.5 * kQuarterTurn_rad) continue;
        if (each.log_weight < best.log_weight + kWorthShowing) continue;
        shift += each.weight() * (each.hypothesis.mean() - best.hypothesis.mean());
        share += each.weight();
    }
    return best.hypothesis.mean() + shift / share;
}

void spread(std::span<const WeightedHypothesis> hypotheses, const StateVector& mean,
            Belief& belief) {
    double from_grid_variance = 0.0;
    belief.building_share = 0.0;
    for (const WeightedHypothesis& each : hypotheses) {
        const Eigen::Vector3d apart = each.hypothesis.mean().head<3>() - mean.head<3>();
        belief.covariance += each.weight() * (each.hypothesis.covariance().topLeftCorner<3, 3>() +
                                              apart * apart.transpose());
        if (!each.building) continue;
        belief.building_share += each.weight();
        from_grid_variance +=
            each.weight() * (each.hypothesis.fromGridVariance() + apart.z() * apart.z());
    }
    belief.sigma_rad =
        belief.building_share > 0.0 ? std::sqrt(from_grid_variance / belief.building_share) : kPi;
}

}  // namespace

Belief beliefOf(std::span<const WeightedHypothesis> hypotheses, const Pose<World>& shown) {
    const WeightedHypothesis& best = chosen(hypotheses, shown);
    const StateVector mean = meanAround(best, hypotheses);
    Belief belief;
    belief.pose = {{mean[HeadingHypothesis::kX], mean[HeadingHypothesis::kY]},
                   mean[HeadingHypothesis::kHeading]};
    belief.bias_rad_s = mean[HeadingHypothesis::kBias];
    belief.scale = mean[HeadingHypothesis::kScale];
    belief.curvature_rad_m = mean[HeadingHypothesis::kCurvature];
    belief.share = shareNear(hypotheses, best.hypothesis.pose());
    belief.leg = best.leg;
    belief.building = best.building;
    spread(hypotheses, mean, belief);
    return belief;
}

}  // namespace hedr
