#include "core/fusion/estimators.h"

#include <array>
#include <charconv>
#include <cmath>

#include "core/text/number.h"

namespace hedr {

namespace {

constexpr EstimatorInputs kNeedsGyro{.gyro = true};
constexpr EstimatorInputs kNeedsWheels{.both_wheels = true};
constexpr EstimatorInputs kNeedsHeading{.heading = true};

constexpr std::array kEstimators{
    EstimatorEntry{"odometry", "Odometry", kNeedsWheels,
                   [](const Pose<World>& start, const FusionConfig& config) -> AnyEstimator {
                       return OdometryEstimator(start, config.wheels);
                   }},
    EstimatorEntry{"gyro", "Gyro", kNeedsGyro,
                   [](const Pose<World>& start, const FusionConfig& config) -> AnyEstimator {
                       return GyroEstimator(start, config.wheels, config.gyro);
                   }},
    EstimatorEntry{"gyrodometry", "Gyrodometry", EstimatorInputs{.gyro = true, .both_wheels = true},
                   [](const Pose<World>& start, const FusionConfig& config) -> AnyEstimator {
                       return Gyrodometry(start, config.gyrodometry);
                   }},
    EstimatorEntry{"gyro_kalman", "Gyro with drift model",
                   EstimatorInputs{.gyro = true, .gyro_drift = true},
                   [](const Pose<World>& start, const FusionConfig& config) -> AnyEstimator {
                       return GyroKalman(start, config.gyro_kalman);
                   }},
    EstimatorEntry{"gh_gyro", "GH filter, gyro", kNeedsGyro,
                   [](const Pose<World>& start, const FusionConfig& config) -> AnyEstimator {
                       return GhFilter(start, GhHeading::kGyro, config.gh);
                   }},
    EstimatorEntry{
        "gh_magnetometer", "GH filter, magnetometer",
        EstimatorInputs{.both_wheels = true, .magnetometer = true, .magnetometer_range = true},
        [](const Pose<World>& start, const FusionConfig& config) -> AnyEstimator {
            return GhFilter(start, GhHeading::kMagnetometer, config.gh);
        }},
    EstimatorEntry{"gh_combined", "GH filter, gyro and magnetometer",
                   EstimatorInputs{.gyro = true, .magnetometer = true, .magnetometer_range = true},
                   [](const Pose<World>& start, const FusionConfig& config) -> AnyEstimator {
                       return GhFilter(start, GhHeading::kCombined, config.gh);
                   }},
    EstimatorEntry{"hedr", "HEDR", kNeedsHeading,
                   [](const Pose<World>& start, const FusionConfig& config) -> AnyEstimator {
                       return Hedr(start, config.hedr);
                   }},
    EstimatorEntry{"hedr_bayes", "Bayesian HEDR", kNeedsHeading,
                   [](const Pose<World>& start, const FusionConfig& config) -> AnyEstimator {
                       return HedrBayes(start, config.hedr_bayes);
                   }},
};

struct NumberKnob {
    FusionKnob knob{};
    double min = 0.0;
    double max = 0.0;
    double& (*value)(FusionConfig&) = nullptr;
    double si_per_unit = 1.0;
};

constexpr double kDeg = radFromDeg(1.0);

constexpr std::array kNumberKnobs{
    NumberKnob{{"gain_deg_s2", "hedr", "gain k of the integrator, degrees per second squared"},
               0.0,
               10.0,
               [](FusionConfig& c) -> double& { return c.hedr.gain_rad_s2; },
               kDeg},
    NumberKnob{{"leak_s", "hedr", "the learnt correction fades with this time constant"},
               0.1,
               1e6,
               [](FusionConfig& c) -> double& { return c.hedr.leak_s; },
               1.0},
    NumberKnob{{"hold_s", "hedr", "without evidence the correction is dropped after this time"},
               0.0,
               1e6,
               [](FusionConfig& c) -> double& { return c.hedr.hold_s; },
               1.0},
    NumberKnob{{"turn_rate_deg_s", "hedr", "faster than this is a turn"},
               0.1,
               1000.0,
               [](FusionConfig& c) -> double& { return c.hedr.turn_rate_rad_s; },
               kDeg},
    NumberKnob{{"damping_deg_s", "hedr", "rate of the part that acts on the heading itself"},
               0.0,
               10.0,
               [](FusionConfig& c) -> double& { return c.hedr.damping_rad_s; },
               kDeg},
    NumberKnob{
        {"compliant_deg", "hedr", "farther off every dominant direction is a way of its own"},
        0.1,
        180.0,
        [](FusionConfig& c) -> double& { return c.hedr.compliant_rad; },
        kDeg},
    NumberKnob{{"drift_window_s", "hedr", "window of the running mean that is shown as drift"},
               0.1,
               1e6,
               [](FusionConfig& c) -> double& { return c.hedr.drift_window_s; },
               1.0},
    NumberKnob{
        {"settled_m", "hedr", "straight driving after which the corridors' direction is kept"},
        0.0,
        1e6,
        [](FusionConfig& c) -> double& { return c.hedr.direction_settled_m; },
        1.0},
    NumberKnob{{"threshold_deg_s", "gyrodometry", "a larger difference means that a wheel slips"},
               0.0,
               1000.0,
               [](FusionConfig& c) -> double& { return c.gyrodometry.threshold_rad_s; },
               kDeg},
    NumberKnob{{"gh_alpha", "gh_*", "share of the sensed heading in 10 ms"},
               0.0,
               1.0,
               [](FusionConfig& c) -> double& { return c.gh.alpha; },
               1.0},
    NumberKnob{{"gh_beta", "gh_*", "share of the newest turn rate of the wheels in 10 ms"},
               0.0,
               1.0,
               [](FusionConfig& c) -> double& { return c.gh.beta; },
               1.0},
    NumberKnob{{"gh_gamma", "gh_combined", "share of the gyro against the magnetometer"},
               0.0,
               1.0,
               [](FusionConfig& c) -> double& { return c.gh.gamma; },
               1.0},
};

struct InputEntry {
    bool EstimatorInputs::*input = nullptr;
    MissingInput missing{};
};

constexpr std::array kInputs{
    InputEntry{&EstimatorInputs::gyro, {"no gyro (gyro_z_rad_s)", false}},
    InputEntry{&EstimatorInputs::both_wheels,
               {"no left and right wheel (left_ticks, right_ticks or left_m, right_m)", false}},
    InputEntry{&EstimatorInputs::heading,
               {"no heading (a gyro, gyro_z_rad_s; both wheels, left_ticks, right_ticks or left_m, "
                "right_m; or odo_heading_rad)",
                false}},
    InputEntry{&EstimatorInputs::magnetometer, {"no magnetometer (mag_x, mag_y, mag_z)", false}},
    InputEntry{&EstimatorInputs::gyro_drift,
               {"gyro_drift_c1_rad_s, gyro_drift_c2_rad_s and gyro_drift_time_s (fitted to a log "
                "of the robot at rest, from switch-on)",
                true}},
    InputEntry{
        &EstimatorInputs::magnetometer_range,
        {"mag_centre_x, mag_centre_y, mag_range_x and mag_range_y (from a full rotation)", true}},
};

constexpr FusionKnob kInterval{"interval_deg", "hedr", "90 or 45, between dominant directions"};
constexpr FusionKnob kDirection{"direction_deg", "hedr*",
                                "heading of one corridor, or auto to learn it"};
constexpr FusionKnob kSource{"heading_source", "hedr", "gyro or encoders (takes its preset)"};

Result<double> parseNumber(std::string_view key, std::string_view text, double min, double max) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !(value >= min) ||
        !(value <= max)) {
        std::string detail = "is \"" + std::string(text) + "\", must be a number from ";
        appendNumber(detail, min);
        appendNumber(detail += " to ", max);
        return fail(ErrorCode::kBadValue, std::string(key), detail);
    }
    return value;
}

Result<void> setInterval(FusionConfig& config, std::string_view value) {
    if (value != "90" && value != "45") {
        return fail(ErrorCode::kBadValue, std::string(kInterval.key),
                    "is \"" + std::string(value) + "\", must be 90 or 45");
    }
    config.hedr.interval_rad = radFromDeg(value == "90" ? 90.0 : 45.0);
    return {};
}

Result<void> setDirection(FusionConfig& config, std::string_view value) {
    if (value == "auto") {
        config.hedr.direction_rad.reset();
        config.hedr_bayes.direction_rad.reset();
        return {};
    }
    return parseNumber(kDirection.key, value, -360.0, 360.0).map([&](double deg) {
        config.hedr.direction_rad = radFromDeg(deg);
        config.hedr_bayes.direction_rad = radFromDeg(deg);
    });
}

Result<void> setSource(FusionConfig& config, std::string_view value) {
    if (value != "gyro" && value != "encoders") {
        return fail(ErrorCode::kBadValue, std::string(kSource.key),
                    "is \"" + std::string(value) + "\", must be gyro or encoders");
    }
    const std::optional<double> direction_rad = config.hedr.direction_rad;
    config.hedr = hedrPreset(value == "gyro" ? HeadingSource::kGyro : HeadingSource::kEncoders);
    config.hedr.direction_rad = direction_rad;
    return {};
}

std::string knobNumber(double value) {
    char digits[32];
    const auto end =
        std::to_chars(digits, digits + sizeof digits, value, std::chars_format::general, 6).ptr;
    return {digits, end};
}

std::string knownKeys() {
    std::string keys;
    for (const FusionKnob& knob : fusionKnobs()) {
        keys += (keys.empty() ? "" : ", ") + std::string(knob.key);
    }
    return keys;
}

}  // namespace

FusionConfig fusionPreset(const Vehicle& vehicle) {
    const WheelNoise wheels = wheelNoiseOf(vehicle);
    const GyroNoise gyro = gyroNoiseOf(vehicle);
    return {.wheels = wheels,
            .gyro = gyro,
            .gyrodometry = {.wheels = wheels, .gyro = gyro},
            .gyro_kalman = gyroKalmanPreset(vehicle),
            .gh = {.magnetometer = vehicle.magnetometer.value_or(MagnetometerRange{}),
                   .wheels = wheels,
                   .gyro = gyro},
            .hedr = hedrPreset(vehicle.heading_source),
            .hedr_bayes = hedrBayesPreset(vehicle)};
}

Result<void> setFusionValue(FusionConfig& config, std::string_view key, std::string_view value) {
    if (key == kInterval.key) return setInterval(config, value);
    if (key == kDirection.key) return setDirection(config, value);
    if (key == kSource.key) return setSource(config, value);
    for (const NumberKnob& knob : kNumberKnobs) {
        if (knob.knob.key != key) continue;
        return parseNumber(key, value, knob.min, knob.max).map([&](double number) {
            knob.value(config) = number * knob.si_per_unit;
        });
    }
    return fail(ErrorCode::kUnknownName, std::string(key), "known are " + knownKeys());
}

std::string fusionValue(FusionConfig config, std::string_view key) {
    const HedrConfig& hedr = config.hedr;
    if (key == kInterval.key) return knobNumber(degFromRad(hedr.interval_rad));
    if (key == kDirection.key)
        return hedr.direction_rad ? knobNumber(degFromRad(*hedr.direction_rad)) : "auto";
    if (key == kSource.key)
        return hedr.heading_source == HeadingSource::kGyro ? "gyro" : "encoders";
    for (const NumberKnob& knob : kNumberKnobs) {
        if (knob.knob.key == key) return knobNumber(knob.value(config) / knob.si_per_unit);
    }
    return {};
}

std::vector<FusionKnob> fusionKnobs() {
    std::vector<FusionKnob> knobs{kSource, kInterval, kDirection};
    for (const NumberKnob& knob : kNumberKnobs) knobs.push_back(knob.knob);
    return knobs;
}

bool actsOn(const FusionKnob& knob, std::string_view estimator) {
    if (!knob.estimators.ends_with('*')) return knob.estimators == estimator;
    return estimator.starts_with(knob.estimators.substr(0, knob.estimators.size() - 1));
}

EstimatorInputs inputsOf(const Vehicle& vehicle) {
    return {.gyro_drift = vehicle.gyro_drift.has_value(),
            .magnetometer_range = vehicle.magnetometer.has_value()};
}

std::optional<MissingInput> missingInput(const EstimatorInputs& needed,
                                         const EstimatorInputs& given) {
    EstimatorInputs there = given;
    there.heading = given.heading || given.gyro || given.both_wheels;
    for (const InputEntry& entry : kInputs) {
        if (needed.*entry.input && !(there.*entry.input)) return entry.missing;
    }
    return std::nullopt;
}

std::span<const EstimatorEntry> estimatorTable() { return kEstimators; }

const EstimatorEntry* findEstimator(std::string_view name) {
    for (const EstimatorEntry& entry : kEstimators) {
        if (entry.name == name) return &entry;
    }
    return nullptr;
}

}  // namespace hedr
