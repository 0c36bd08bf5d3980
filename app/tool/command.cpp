#include "app/tool/command.h"

#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <string_view>

#include "core/geometry/angle.h"

namespace hedr::tool {

Result<KeyValue> parseKeyValue(const std::string& text) {
    const auto equals = text.find('=');
    if (equals == std::string::npos || equals == 0) {
        return fail(ErrorCode::kBadValue, "--set", "is \"" + text + "\", must be KEY=VALUE");
    }
    return KeyValue{text.substr(0, equals), text.substr(equals + 1)};
}

Result<Pose<World>> parsePose(const std::string& text) {
    std::array<double, 3> numbers{};
    const char* at = text.data();
    const char* const end = text.data() + text.size();
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const auto parsed = std::from_chars(at, end, numbers[i]);
        const bool last = i + 1 == numbers.size();
        const bool ended_well = last ? parsed.ptr == end : parsed.ptr != end && *parsed.ptr == ',';
        if (parsed.ec != std::errc{} || !ended_well || !std::isfinite(numbers[i])) {
            return fail(ErrorCode::kBadValue, "--initial",
                        "is \"" + text + "\", must be X,Y,HEADING_DEG, for example 1.5,2,90");
        }
        at = parsed.ptr + 1;
    }
    return Pose<World>{{numbers[0], numbers[1]}, radFromDeg(numbers[2])};
}

bool looksLikeMission(const std::string& file) {
    constexpr std::string_view kMagic{"SQLite format 3"};
    std::array<char, kMagic.size()> head{};
    std::ifstream stream(file, std::ios::binary);
    stream.read(head.data(), head.size());
    return stream && std::string_view(head.data(), head.size()) == kMagic;
}

void needVehicleForLog(const std::string& input, const std::string& vehicle) {
    if (vehicle.empty() && !looksLikeMission(input)) throw CLI::RequiredError("--vehicle");
}

Result<FusionConfig> fusionConfig(const Vehicle& vehicle,
                                  const std::vector<std::string>& settings) {
    FusionConfig config = fusionPreset(vehicle);
    for (const std::string& setting : settings) {
        const auto pair = parseKeyValue(setting);
        if (!pair) return tl::make_unexpected(pair.error());
        const auto set = setFusionValue(config, pair->key, pair->value);
        if (!set) return tl::make_unexpected(set.error());
    }
    return config;
}

}  // namespace hedr::tool
