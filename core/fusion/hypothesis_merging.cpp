#include "core/fusion/hypothesis_merging.h"

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace hedr {

namespace {

constexpr double kMostCost = 0.02;  // Runnalls' bound, weighted

constexpr std::array kCompared{HeadingHypothesis::kHeading, HeadingHypothesis::kBias,
                               HeadingHypothesis::kGrid};
using Compared = Eigen::Matrix3d;

Compared comparedCovariance(const HeadingHypothesis& h) {
    // What is known exactly, as the bias of encoders, must not make the determinant vanish.
    const Eigen::Vector3d least(1e-8, 1e-12, 1e-8);
    return h.covariance()(kCompared, kCompared) + least.asDiagonal().toDenseMatrix();
}

bool comparable(const WeightedHypothesis& a, const WeightedHypothesis& b) {
    const double apart_rad = a.hypothesis.fromGrid_rad() - b.hypothesis.fromGrid_rad();
    return a.building == b.building &&
           a.hypothesis.biasWalk_rad_s_sqrts() == b.hypothesis.biasWalk_rad_s_sqrts() &&
           std::abs(apart_rad) < 0.25 * kQuarterTurn_rad;
}

// How much the merging may cost, as a Kullback-Leibler bound.
double cost(const WeightedHypothesis& a, const WeightedHypothesis& b) {
    const Eigen::Vector3d apart = a.hypothesis.mean()(kCompared) - b.hypothesis.mean()(kCompared);
    const double both_weights = a.weight() + b.weight();
    const double share = a.weight() / both_weights;
    const Compared pa = comparedCovariance(a.hypothesis);
    const Compared pb = comparedCovariance(b.hypothesis);
    const Compared both =
        share * pa + (1.0 - share) * pb + share * (1.0 - share) * apart * apart.transpose();
    return 0.5 *
           (both_weights * std::log(both.determinant()) - a.weight() * std::log(pa.determinant()) -
            b.weight() * std::log(pb.determinant()));
}

using Pair = std::pair<std::size_t, std::size_t>;

std::optional<Pair> cheapestPair(const std::vector<WeightedHypothesis>& hypotheses) {
    double cheapest = kMostCost;
    std::optional<Pair> pair;
    for (std::size_t i = 0; i < hypotheses.size(); ++i) {
        for (std::size_t j = i + 1; j < hypotheses.size(); ++j) {
            if (!comparable(hypotheses[i], hypotheses[j])) continue;
            const double pair_cost = cost(hypotheses[i], hypotheses[j]);
            if (pair_cost >= cheapest) continue;
            cheapest = pair_cost;
            pair = {i, j};
        }
    }
    return pair;
}

}  // namespace

void mergeClose(std::vector<WeightedHypothesis>& hypotheses) {
    while (const auto pair = cheapestPair(hypotheses)) {
        WeightedHypothesis& kept = hypotheses[pair->first];
        const WeightedHypothesis& gone = hypotheses[pair->second];
        const double both_weights = kept.weight() + gone.weight();
        if (gone.log_weight > kept.log_weight) kept.last = gone.last;
        kept.hypothesis.absorb(gone.hypothesis, kept.weight() / both_weights);
        kept.log_weight = std::log(both_weights);
        hypotheses.erase(hypotheses.begin() + static_cast<std::ptrdiff_t>(pair->second));
    }
}

}  // namespace hedr
