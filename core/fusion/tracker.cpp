#include "core/fusion/tracker.h"

#include <cmath>

namespace hedr {

namespace {

template <class E>
PoseVariance varianceOf(const E& estimator) {
    if constexpr (EstimatorWithCovariance<E>) {
        // A float ends at 1e38: what is so uncertain is as uncertain as can be said.
        const Eigen::Matrix3d p = estimator.covariance().cwiseMin(1e30).cwiseMax(-1e30);
        return {static_cast<float>(p(0, 0)), static_cast<float>(p(0, 1)),
                static_cast<float>(p(1, 1)), static_cast<float>(p(2, 2))};
    } else {
        return {};
    }
}

}  // namespace

Tracker::Tracker(const Setup& setup) : motions_(setup.vehicle, setup.clock_period_s) {
    for (const EstimatorEntry* entry : setup.estimators) {
        runs_.push_back({entry, entry->make(setup.start, setup.config)});
    }
}

bool Tracker::add(const SensorReport& report) {
    const std::optional<Motion> motion = motions_.add(report);
    if (!motion) {
        // The start itself is the first point of every track.
        if (begun_ || !motions_.started()) return false;
        begun_ = true;
        motion_.t_s = motions_.time_s();
        return true;
    }
    motion_ = *motion;
    driven_m_ += std::abs(motion_.distance_m);
    for (Run& run : runs_) {
        std::visit([&](auto& estimator) { estimator.update(motion_); }, run.estimator);
    }
    return true;
}

void Tracker::setDirection(std::optional<double> direction_rad) {
    for (Run& run : runs_) {
        std::visit(
            [&]<class E>(E& estimator) {
                if constexpr (EstimatorWithDirection<E>) estimator.setDirection(direction_rad);
            },
            run.estimator);
    }
}

TrackPoint Tracker::point(std::size_t index) const {
    return std::visit(
        [&](const auto& estimator) {
            return TrackPoint{motion_.t_s, estimator.pose(), estimator.gyro_bias_rad_s(),
                              varianceOf(estimator)};
        },
        runs_[index].estimator);
}

const HedrStatus* Tracker::hedrStatus() const {
    for (const Run& run : runs_) {
        if (const auto* hedr = std::get_if<Hedr>(&run.estimator)) return &hedr->status();
    }
    return nullptr;
}

std::optional<BayesStatus> Tracker::bayesStatus() const {
    for (const Run& run : runs_) {
        if (const auto* bayes = std::get_if<HedrBayes>(&run.estimator)) return bayes->status();
    }
    return std::nullopt;
}

std::vector<const EstimatorEntry*> estimatorsFor(const EstimatorInputs& given) {
    std::vector<const EstimatorEntry*> able;
    for (const EstimatorEntry& entry : estimatorTable()) {
        if (!missingInput(entry.needs, given)) able.push_back(&entry);
    }
    return able;
}

}  // namespace hedr
