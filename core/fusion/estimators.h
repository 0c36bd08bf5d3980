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

#include "core/fusion/gh_filter.h"
#include "core/fusion/gyro.h"
#include "core/fusion/gyro_kalman.h"
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

// One that takes the heading of a corridor; none: it learns it.
template <class E>
concept EstimatorWithDirection = requires(E& estimator, std::optional<double> direction_rad) {
    { estimator.setDirection(direction_rad) } -> std::same_as<void>;
};

static_assert(Estimator<OdometryEstimator> && Estimator<GyroEstimator> && Estimator<Gyrodometry> &&
              Estimator<GyroKalman> && Estimator<GhFilter> && Estimator<Hedr> &&
              Estimator<HedrBayes>);

using AnyEstimator = std::variant<OdometryEstimator, GyroEstimator, Gyrodometry, GyroKalman,
                                  GhFilter, Hedr, HedrBayes>;

// The knobs of all estimators: a preset for the vehicle, changed by name.
struct FusionConfig {
    WheelNoise wheels{};
    GyroNoise gyro{};
    GyrodometryConfig gyrodometry{};
    GyroKalmanConfig gyro_kalman{};
    GhConfig gh{};
    HedrConfig hedr{};
    HedrBayesConfig hedr_bayes{};
};

FusionConfig fusionPreset(const Vehicle& vehicle);

// Sets a knob, as in "gain_deg_s2" = "0.01". Errors: kUnknownName (lists the known ones),
// kBadValue.
Result<void> setFusionValue(FusionConfig& config, std::string_view key, std::string_view value);

// The value of a knob as setFusionValue takes it, to six digits. `key` is one of fusionKnobs().
std::string fusionValue(FusionConfig config, std::string_view key);

struct FusionKnob {
    std::string_view key;
    std::string_view estimators;  // that it acts on; "gh_*" are all that begin so
    std::string_view meaning;
};
std::vector<FusionKnob> fusionKnobs();
bool actsOn(const FusionKnob& knob, std::string_view estimator);

// What an estimator can need: values in the reports, and keys in the vehicle file.
struct EstimatorInputs {
    bool gyro = false;
    bool both_wheels = false;
    bool heading = false;  // of any kind; a gyro or both wheels give it
    bool magnetometer = false;
    bool gyro_drift = false;
    bool magnetometer_range = false;
};

// Of the vehicle file; the rest is left to the reports.
EstimatorInputs inputsOf(const Vehicle& vehicle);

struct MissingInput {
    std::string_view what;  // "no gyro (...)" with its columns, or keys of a vehicle file
    bool in_vehicle = false;
};
// The first of `needed` that is not `given`; none where all is there.
std::optional<MissingInput> missingInput(const EstimatorInputs& needed,
                                         const EstimatorInputs& given);

struct EstimatorEntry {
    std::string_view name;
    std::string_view title;
    EstimatorInputs needs;
    AnyEstimator (*make)(const Pose<World>& start, const FusionConfig& config);
};

// The one table of estimators.
std::span<const EstimatorEntry> estimatorTable();

// nullptr where there is none of that name.
const EstimatorEntry* findEstimator(std::string_view name);

}  // namespace hedr
