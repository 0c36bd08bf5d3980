#include "core/robot/vehicle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/robot/vehicle_text.h"
#include "core/text/nearest_name.h"
#include "core/text/number.h"
#include "core/text/plain_toml.h"
#include "core/text/toml.h"
#include "core/text/toml_length.h"

namespace hedr {
namespace {

enum class Range { kAny, kNotNegative, kPositive, kNotZero };
enum class Need { kRequired, kOptional };

// No robot has such a number; squares of them must stay finite.
constexpr double kLargest = 1e9;
constexpr double kSmallest = 1e-12;
// The worst gyros have a thousandth of it, as white noise and as walk of the bias.
constexpr double kNoisiestGyro = 10.0;

struct NumberKey {
    std::string_view name;
    Range range;
    Need need;
    double& (*field)(Vehicle&);
    double largest = kLargest;
};

constexpr std::array kNumberKeys = {
    NumberKey{"left_wheel_diameter_m", Range::kPositive, Need::kRequired,
              [](Vehicle& v) -> double& { return v.geometry.left_wheel_diameter_m; }},
    NumberKey{"right_wheel_diameter_m", Range::kPositive, Need::kRequired,
              [](Vehicle& v) -> double& { return v.geometry.right_wheel_diameter_m; }},
    NumberKey{"wheelbase_m", Range::kPositive, Need::kRequired,
              [](Vehicle& v) -> double& { return v.geometry.wheelbase_m; }},
    NumberKey{"ticks_per_revolution", Range::kPositive, Need::kRequired,
              [](Vehicle& v) -> double& { return v.geometry.ticks_per_revolution; }},
    NumberKey{"gyro_scale", Range::kPositive, Need::kOptional,
              [](Vehicle& v) -> double& { return v.gyro_scale; }},
    NumberKey{"gyro_noise_rad_s_sqrthz", Range::kNotNegative, Need::kOptional,
              [](Vehicle& v) -> double& { return v.gyro_noise_rad_s_sqrthz; }, kNoisiestGyro},
    NumberKey{"gyro_bias_walk_rad_s_sqrts", Range::kNotNegative, Need::kOptional,
              [](Vehicle& v) -> double& { return v.gyro_bias_walk_rad_s_sqrts; }, kNoisiestGyro},
    NumberKey{"max_speed_m_s", Range::kPositive, Need::kOptional,
              [](Vehicle& v) -> double& { return v.max_speed_m_s; }},
};
// Keys that make sense together only.
constexpr std::array kGyroDriftKeys = {
    NumberKey{"gyro_drift_c1_rad_s", Range::kAny, Need::kRequired,
              [](Vehicle& v) -> double& { return v.gyro_drift->c1_rad_s; }},
    NumberKey{"gyro_drift_c2_rad_s", Range::kAny, Need::kRequired,
              [](Vehicle& v) -> double& { return v.gyro_drift->c2_rad_s; }},
    NumberKey{"gyro_drift_time_s", Range::kPositive, Need::kRequired,
              [](Vehicle& v) -> double& { return v.gyro_drift->time_s; }},
};
constexpr std::array kMagnetometerKeys = {
    NumberKey{"mag_centre_x", Range::kAny, Need::kRequired,
              [](Vehicle& v) -> double& { return v.magnetometer->centre_x; }},
    NumberKey{"mag_centre_y", Range::kAny, Need::kRequired,
              [](Vehicle& v) -> double& { return v.magnetometer->centre_y; }},
    NumberKey{"mag_range_x", Range::kNotZero, Need::kRequired,
              [](Vehicle& v) -> double& { return v.magnetometer->range_x; }},
    NumberKey{"mag_range_y", Range::kNotZero, Need::kRequired,
              [](Vehicle& v) -> double& { return v.magnetometer->range_y; }},
};
struct KeyGroup {
    std::span<const NumberKey> keys;
    bool (*given)(const Vehicle&);
    void (*create)(Vehicle&);
};
constexpr std::array kKeyGroups = {
    KeyGroup{kGyroDriftKeys, [](const Vehicle& v) { return v.gyro_drift.has_value(); },
             [](Vehicle& v) { v.gyro_drift.emplace(); }},
    KeyGroup{kMagnetometerKeys, [](const Vehicle& v) { return v.magnetometer.has_value(); },
             [](Vehicle& v) { v.magnetometer.emplace(); }},
};
constexpr std::array<std::string_view, 5> kOtherKeys = {
    "name", "heading_source", "encoder_counter_bits", "gyro_bias_rad_s", "text"};

constexpr int kFewestCounterBits = 8;
constexpr int kMostCounterBits = 63;

std::string beyond(double largest) {
    if (largest == kLargest) return ", nothing is so large in SI units";
    std::string reason = ", no gyro has more than ";
    appendNumber(reason, largest);
    return reason;
}

// Reads one table into one Vehicle, key by key.
class VehicleReader {
  public:
    VehicleReader(const toml::table& table, const std::string& path) : table_(table), path_(path) {}

    Result<Vehicle> read() {
        return refuseUnknownKeys()
            .and_then([this] { return readName(); })
            .and_then([this] { return readNumbers(kNumberKeys); })
            .and_then([this] { return readGroups(); })
            .and_then([this] { return readBias(); })
            .and_then([this] { return readHeadingSource(); })
            .and_then([this] { return readCounterBits(); })
            .and_then([this] { return readText(); })
            .map([this] { return vehicle_; });
    }

  private:
    tl::unexpected<Error> failAt(const toml::source_region& source, std::string detail) const {
        return fail(ErrorCode::kBadValue, path_ + ':' + std::to_string(source.begin.line),
                    std::move(detail));
    }

    Result<void> refuseUnknownKeys() const {
        std::vector<std::string_view> known(kOtherKeys.begin(), kOtherKeys.end());
        for (const NumberKey& key : kNumberKeys) known.push_back(key.name);
        for (const KeyGroup& group : kKeyGroups)
            for (const NumberKey& key : group.keys) known.push_back(key.name);
        for (const auto& [key, node] : table_) {
            if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
            std::string detail = "unknown key " + std::string(key.str());
            const std::string_view hint = nearestName(key.str(), known);
            if (!hint.empty()) detail += ", did you mean " + std::string(hint) + "?";
            return failAt(key.source(), detail);
        }
        return {};
    }

    Result<void> readName() {
        const toml::node* node = table_.get("name");
        if (!node) return fail(ErrorCode::kMissingKey, path_, "name");
        if (!node->is_string()) return failAt(node->source(), "name must be a text");
        vehicle_.name = **node->as_string();
        return {};
    }

    Result<double> number(std::string_view name, const toml::node& node, Range range,
                          double largest = kLargest) const {
        // A TOML whole number is a number too; a TOML boolean is not.
        const auto value = node.is_number() ? node.value<double>() : std::nullopt;
        if (!value) return failAt(node.source(), std::string(name) + " must be a number");
        const bool in_range = range == Range::kAny || *value > 0.0 ||
                              (range == Range::kNotNegative && *value == 0.0) ||
                              (range == Range::kNotZero && *value < 0.0);
        const double size = std::abs(*value);
        const bool may_be_zero = range == Range::kAny || range == Range::kNotNegative;
        const bool sane = size <= largest && (size >= kSmallest || may_be_zero);
        if (std::isfinite(*value) && in_range && sane) return *value;
        std::string detail = std::string(name) + " is ";
        appendNumber(detail, *value);
        detail += !std::isfinite(*value)         ? ", must be a finite number"
                  : in_range && size > largest   ? beyond(largest)
                  : in_range                     ? ", nothing is so small in SI units"
                  : range == Range::kNotNegative ? ", must not be negative"
                  : range == Range::kNotZero     ? ", must not be zero"
                                                 : ", must be positive";
        return failAt(node.source(), detail);
    }

    Result<void> readNumbers(std::span<const NumberKey> keys) {
        for (const NumberKey& key : keys) {
            const toml::node* node = table_.get(key.name);
            if (!node && key.need == Need::kOptional) continue;
            if (!node) return fail(ErrorCode::kMissingKey, path_, std::string(key.name));
            const auto value = number(key.name, *node, key.range, key.largest);
            if (!value) return tl::make_unexpected(value.error());
            key.field(vehicle_) = *value;
        }
        return {};
    }

    Result<void> readGroups() {
        for (const KeyGroup& group : kKeyGroups) {
            const bool given =
                std::any_of(group.keys.begin(), group.keys.end(),
                            [this](const NumberKey& key) { return table_.get(key.name); });
            if (!given) continue;
            group.create(vehicle_);
            auto read = readNumbers(group.keys);
            if (!read) return read;
        }
        return {};
    }

    Result<void> readBias() {
        const toml::node* node = table_.get("gyro_bias_rad_s");
        if (!node) return {};
        return number("gyro_bias_rad_s", *node, Range::kAny).map([this](double bias) {
            vehicle_.gyro_bias_rad_s = bias;
        });
    }

    Result<void> readHeadingSource() {
        const toml::node* node = table_.get("heading_source");
        if (!node) return {};
        const auto text = node->value_exact<std::string_view>();
        if (text == "gyro") {
            vehicle_.heading_source = HeadingSource::kGyro;
        } else if (text == "encoders") {
            vehicle_.heading_source = HeadingSource::kEncoders;
        } else {
            return failAt(node->source(), "heading_source must be \"gyro\" or \"encoders\"");
        }
        return {};
    }

    Result<void> readCounterBits() {
        const toml::node* node = table_.get("encoder_counter_bits");
        if (!node) return {};
        const auto bits = node->value_exact<std::int64_t>();
        if (!bits || *bits < kFewestCounterBits || *bits > kMostCounterBits)
            return failAt(node->source(), "encoder_counter_bits must be a whole number from " +
                                              std::to_string(kFewestCounterBits) + " to " +
                                              std::to_string(kMostCounterBits));
        vehicle_.encoder_counter_bits = static_cast<int>(*bits);
        return {};
    }

    Result<void> readText() {
        const toml::node* node = table_.get("text");
        if (!node) return {};
        return readTextSection(*node, path_).map([this](TextLineFormat&& format) {
            vehicle_.text = std::move(format);
        });
    }

    const toml::table& table_;
    const std::string& path_;
    Vehicle vehicle_;
};

void appendKey(std::string& text, std::string_view key, double value) {
    text.append(key).append(" = ");
    const std::size_t begin = text.size();
    appendNumber(text, value);
    // Digits alone would be a TOML integer, which ends at 2^63.
    if (text.find_first_of(".en", begin) == std::string::npos) text += ".0";
    text += '\n';
}

}  // namespace

Result<Vehicle> parseVehicle(std::string_view toml, const std::string& name_for_errors) {
    const auto short_enough = checkTomlLength(toml, name_for_errors);
    if (!short_enough) return tl::make_unexpected(short_enough.error());
    return parseToml(toml, name_for_errors).and_then([&](const ::toml::table& table) {
        return VehicleReader(table, name_for_errors).read();
    });
}

std::string formatVehicle(const Vehicle& vehicle) {
    std::string text = "name = " + quotedToml(vehicle.name) + '\n';
    text += "heading_source = ";
    text += vehicle.heading_source == HeadingSource::kGyro ? "\"gyro\"\n" : "\"encoders\"\n";
    text += "encoder_counter_bits = " + std::to_string(vehicle.encoder_counter_bits) + '\n';
    Vehicle fields = vehicle;
    for (const NumberKey& key : kNumberKeys) appendKey(text, key.name, key.field(fields));
    for (const KeyGroup& group : kKeyGroups) {
        if (!group.given(vehicle)) continue;
        for (const NumberKey& key : group.keys) appendKey(text, key.name, key.field(fields));
    }
    if (vehicle.gyro_bias_rad_s) appendKey(text, "gyro_bias_rad_s", *vehicle.gyro_bias_rad_s);
    if (vehicle.text) text += formatTextSection(*vehicle.text);  // a section comes last
    return text;
}

}  // namespace hedr
