#include "core/robot/vehicle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/robot/vehicle_keys.h"
#include "core/robot/vehicle_text.h"
#include "core/text/nearest_name.h"
#include "core/text/number.h"
#include "core/text/plain_toml.h"
#include "core/text/toml.h"
#include "core/text/toml_length.h"

namespace hedr {
namespace {

constexpr std::array<std::string_view, 4> kOtherKeys = {"name", "heading_source",
                                                        "encoder_counter_bits", "text"};

constexpr int kFewestCounterBits = 8;
constexpr int kMostCounterBits = 63;

// Reads one table into one Vehicle, key by key.
class VehicleReader {
  public:
    VehicleReader(const toml::table& table, const std::string& path) : table_(table), path_(path) {}

    Result<Vehicle> read() {
        return refuseUnknownKeys()
            .and_then([this] { return readName(); })
            .and_then([this] { return readNumbers(vehicleKeys()); })
            .and_then([this] { return readGroups(); })
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
        for (const VehicleKey& key : vehicleKeys()) known.push_back(key.name);
        for (const VehicleKeyGroup& group : vehicleKeyGroups())
            for (const VehicleKey& key : group.keys) known.push_back(key.name);
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

    Result<double> number(const VehicleKey& key, const toml::node& node) const {
        // A TOML whole number is a number too; a TOML boolean is not.
        const auto value = node.is_number() ? node.value<double>() : std::nullopt;
        if (!value) return failAt(node.source(), std::string(key.name) + " must be a number");
        const std::string complaint = complaintAbout(key, *value);
        if (!complaint.empty()) return failAt(node.source(), complaint);
        return *value;
    }

    Result<void> readNumbers(std::span<const VehicleKey> keys) {
        for (const VehicleKey& key : keys) {
            const toml::node* node = table_.get(key.name);
            if (!node && key.need == VehicleKey::Need::kOptional) continue;
            if (!node) return fail(ErrorCode::kMissingKey, path_, std::string(key.name));
            const auto value = number(key, *node);
            if (!value) return tl::make_unexpected(value.error());
            key.field(vehicle_) = *value;
        }
        return {};
    }

    Result<void> readGroups() {
        for (const VehicleKeyGroup& group : vehicleKeyGroups()) {
            const bool given =
                std::any_of(group.keys.begin(), group.keys.end(),
                            [this](const VehicleKey& key) { return table_.get(key.name); });
            if (!given) continue;
            group.create(vehicle_);
            auto read = readNumbers(group.keys);
            if (!read) return read;
        }
        return {};
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
    for (const VehicleKey& key : vehicleKeys()) appendKey(text, key.name, key.field(fields));
    for (const VehicleKeyGroup& group : vehicleKeyGroups()) {
        if (!group.given(vehicle)) continue;
        for (const VehicleKey& key : group.keys) appendKey(text, key.name, key.field(fields));
    }
    if (vehicle.text) text += formatTextSection(*vehicle.text);  // a section comes last
    return text;
}

}  // namespace hedr
