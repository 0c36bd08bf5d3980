#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/tool/command.h"
#include "core/mission/mission_reader.h"

namespace hedr::tool {

namespace {

struct Options {
    std::string mission;
    bool json = false;
};

nlohmann::ordered_json toJson(const MissionInfo& info, const std::optional<Vehicle>& vehicle) {
    nlohmann::ordered_json object{
        {"start_utc", info.start_utc}, {"duration_s", info.duration_s},
        {"bytes", info.bytes},         {"stream_rows", info.stream_rows},
        {"events", info.events},       {"program_version", info.program_version},
        {"schema", info.schema}};
    object["vehicle"] = vehicle ? nlohmann::ordered_json(vehicle->name) : nullptr;
    object["tracks"] = nlohmann::ordered_json::object();
    for (const auto& [name, points] : info.tracks) object["tracks"][name] = points;
    return object;
}

void print(const MissionInfo& info, const std::optional<Vehicle>& vehicle) {
    std::cout << "start     " << info.start_utc << "\nduration  " << info.duration_s
              << " s\nsize      " << info.bytes << " bytes in " << info.stream_rows
              << " pieces\nvehicle   " << (vehicle ? vehicle->name : "not known")
              << "\nrecorded by " << info.program_version << '\n';
    for (const auto& [name, points] : info.tracks) {
        std::cout << "track     " << name << ", " << points << " points\n";
    }
}

Result<void> runInfo(const Options& options) {
    const auto reader = MissionReader::open(options.mission);
    if (!reader) return tl::make_unexpected(reader.error());
    const auto info = reader->info();
    if (!info) return tl::make_unexpected(info.error());
    const auto vehicle = reader->vehicle();
    if (!vehicle) return tl::make_unexpected(vehicle.error());
    if (options.json) {
        std::cout << toJson(*info, *vehicle).dump() << '\n';
    } else {
        print(*info, *vehicle);
    }
    return {};
}

}  // namespace

Job addInfo(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    app.add_option("MISSION", options->mission, "A mission file")->required();
    app.add_flag("--json", options->json, "One JSON object on standard output");
    return [options] { return runInfo(*options); };
}

}  // namespace hedr::tool
