#include "core/fusion/estimators.h"

#include <array>
#include <charconv>
#include <cmath>

namespace hedr {

namespace {

constexpr std::array kEstimators{
    EstimatorEntry{"odometry", "Odometry", false, true,
                   [](const Pose<World>& start, const FusionConfig&) -> AnyEstimator {
                       return OdometryEstimator(start);
                   }},
    EstimatorEntry{"gyro", "Gyro", true, false,
                   [](const Pose<World>& start, const FusionConfig&) -> AnyEstimator {
                       return GyroEstimator(start);
                   }},
    EstimatorEntry{"gyrodometry", "Gyrodometry", true, true,
                   [](const Pose<World>& start, const FusionConfig& config) -> AnyEstimator {
                       return Gyrodometry(start, config.gyrodometry);
                   }},
    EstimatorEntry{"hedr", "HEDR", false, false,
                   [](const Pose<World>& start, const FusionConfig& config) -> AnyEstimator {
                       return Hedr(start, config.hedr);
                   }},
    EstimatorEntry{"hedr_bayes", "Bayesian HEDR", false, false,
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
    NumberKnob{{"gain_deg_s2", "hedr: gain k of the integrator, degrees per second squared"},
               0.0,
               10.0,
               [](FusionConfig& c) -> double& { return c.hedr.gain_rad_s2; },
               kDeg},
    NumberKnob{{"leak_s", "hedr: the learnt correction fades with this time constant"},
               0.1,
               1e6,
               [](FusionConfig& c) -> double& { return c.hedr.leak_s; },
               1.0},
    NumberKnob{{"hold_s", "hedr: without evidence the correction is dropped after this time"},
               0.0,
               1e6,
               [](FusionConfig& c) -> double& { return c.hedr.hold_s; },
               1.0},
    NumberKnob{{"turn_rate_deg_s", "hedr: faster than this is a turn"},
               0.1,
               1000.0,
               [](FusionConfig& c) -> double& { return c.hedr.turn_rate_rad_s; },
               kDeg},
    NumberKnob{{"damping_deg_s", "hedr: rate of the part that acts on the heading itself"},
               0.0,
               10.0,
               [](FusionConfig& c) -> double& { return c.hedr.damping_rad_s; },
               kDeg},
    NumberKnob{{"drift_window_s", "hedr: window of the running mean that is shown as drift"},
               0.1,
               1e6,
               [](FusionConfig& c) -> double& { return c.hedr.drift_window_s; },
               1.0},
    NumberKnob{{"settled_m", "hedr: straight driving after which the corridors' direction is kept"},
               0.0,
               1e6,
               [](FusionConfig& c) -> double& { return c.hedr.direction_settled_m; },
               1.0},
    NumberKnob{{"threshold_deg_s", "gyrodometry: a larger difference means that a wheel slips"},
               0.0,
               1000.0,
               [](FusionConfig& c) -> double& { return c.gyrodometry.threshold_rad_s; },
               kDeg},
};

constexpr FusionKnob kInterval{"interval_deg", "hedr: 90 or 45, between dominant directions"};
constexpr FusionKnob kDirection{"direction_deg",
                                "hedr: heading of one corridor, or auto to learn it"};
constexpr FusionKnob kSource{"heading_source", "hedr: gyro or encoders (takes its preset)"};

Result<double> parseNumber(std::string_view key, std::string_view text, double min, double max) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !(value >= min) ||
        !(value <= max)) {
        return fail(ErrorCode::kBadValue, std::string(key),
                    "is \"" + std::string(text) + "\", must be a number from " +
                        std::to_string(min) + " to " + std::to_string(max));
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
        return {};
    }
    return parseNumber(kDirection.key, value, -360.0, 360.0).map([&](double deg) {
        config.hedr.direction_rad = radFromDeg(deg);
    });
}

Result<void> setSource(FusionConfig& config, std::string_view value) {
    if (value != "gyro" && value != "encoders") {
        return fail(ErrorCode::kBadValue, std::string(kSource.key),
                    "is \"" + std::string(value) + "\", must be gyro or encoders");
    }
    config.hedr = hedrPreset(value == "gyro" ? HeadingSource::kGyro : HeadingSource::kEncoders);
    return {};
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
    return {.gyrodometry = {},
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

std::vector<FusionKnob> fusionKnobs() {
    std::vector<FusionKnob> knobs{kSource, kInterval, kDirection};
    for (const NumberKnob& knob : kNumberKnobs) knobs.push_back(knob.knob);
    return knobs;
}

std::span<const EstimatorEntry> estimatorTable() { return kEstimators; }

const EstimatorEntry* findEstimator(std::string_view name) {
    for (const EstimatorEntry& entry : kEstimators) {
        if (entry.name == name) return &entry;
    }
    return nullptr;
}

}  // namespace hedr
