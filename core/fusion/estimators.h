#pragma once

#include <Eigen/Core>
#include <concepts>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/fusion/gyro.h"
#include "core/fusion/gyrodometry.h"
#include "core/fusion/hedr.h"
#include "core/fusion/hedr_bayes.h"
#include "core/fusion/odometry.h"
#include "core/result.h"

namespace hedr {

// What every estimator can do. A copy continues as the original would.
template <class E>
concept Estimator = std::copyable<E> && requires(E estimator, const Motion& motion) {
    { estimator.update(motion) } -> std::same_as<void>;
    { std::as_const(estimator).pose() } -> std::convertible_to<Pose<World>>;
    { std::as_const(estimator).gyro_bias_rad_s() } -> std::convertible_to<double>;
};

// One that knows how far it may be off: x, y in metres and heading in radians.
template <class E>
concept EstimatorWithCovariance = requires(const E& estimator) {
    { estimator.covariance() } -> std::convertible_to<Eigen::Matrix3d>;
};

static_assert(Estimator<OdometryEstimator> && Estimator<GyroEstimator> && Estimator<Gyrodometry> &&
              Estimator<Hedr> && Estimator<HedrBayes>);

using AnyEstimator = std::variant<OdometryEstimator, GyroEstimator, Gyrodometry, Hedr, HedrBayes>;

// The knobs of all estimators: a preset for the vehicle, changed by name.
struct FusionConfig {
    GyrodometryConfig gyrodometry{};
    HedrConfig hedr{};
    HedrBayesConfig hedr_bayes{};
};

FusionConfig fusionPreset(const Vehicle& vehicle);

// Sets a knob, as in "gain_deg_s2" = "0.01". Errors: kUnknownName (lists the known ones),
// kBadValue.
Result<void> setFusionValue(FusionConfig& config, std::string_view key, std::string_view value);

struct FusionKnob {
    std::string_view key;
    std::string_view meaning;
};
std::vector<FusionKnob> fusionKnobs();

struct EstimatorEntry {
    std::string_view name;
    std::string_view title;
    bool needs_gyro;
    bool needs_both_wheels;
    AnyEstimator (*make)(const Pose<World>& start, const FusionConfig& config);
};

// The one table of estimators.
std::span<const EstimatorEntry> estimatorTable();

// nullptr where there is none of that name.
const EstimatorEntry* findEstimator(std::string_view name);

}  // namespace hedr
