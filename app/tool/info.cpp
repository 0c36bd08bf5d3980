#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/tool/command.h"
#include "app/tool/json_line.h"
#include "core/mission/mission_reader.h"

namespace hedr::tool {

namespace {

struct Options {
    std::string mission;
    bool json = false;
};

// What one mission says of itself.
struct Content {
    MissionInfo info{};
    std::optional<Vehicle> vehicle{};
    std::optional<Site> site{};
    std::optional<SalvageReport> salvaged{};
};

nlohmann::ordered_json floorsToJson(const std::optional<Site>& site) {
    auto floors = nlohmann::ordered_json::array();
    if (!site) return floors;
    for (const SiteFloor& floor : site->floors) {
        auto plans = nlohmann::ordered_json::array();
        for (const SitePlan& plan : floor.plans) plans.push_back(plan.image_file.string());
        floors.push_back({{"name", floor.name}, {"plans", plans}});
    }
    return floors;
}

nlohmann::ordered_json toJson(const Content& content) {
    const auto& [info, vehicle, site, salvaged] = content;
    nlohmann::ordered_json object{
        {"start_utc", info.start_utc}, {"duration_s", info.duration_s},
        {"bytes", info.bytes},         {"stream_rows", info.stream_rows},
        {"events", info.events},       {"program_version", info.program_version},
        {"schema", info.schema}};
    object["vehicle"] = vehicle ? nlohmann::ordered_json(vehicle->name) : nullptr;
    object["tracks"] = nlohmann::ordered_json::object();
    for (const auto& [name, points] : info.tracks) object["tracks"][name] = points;
    object["floors"] = floorsToJson(site);
    object["damage"] = salvaged ? nlohmann::ordered_json(describe(*salvaged)) : nullptr;
    return object;
}

void print(const SiteFloor& floor) {
    std::cout << "floor     " << floor.name;
    for (std::size_t i = 0; i < floor.plans.size(); ++i) {
        std::cout << (i == 0 ? ": " : ", ") << floor.plans[i].image_file.filename().string();
    }
    std::cout << '\n';
}

void print(const Content& content) {
    const auto& [info, vehicle, site, salvaged] = content;
    std::cout << "start     " << info.start_utc << "\nduration  " << info.duration_s
              << " s\nsize      " << info.bytes << " bytes in " << info.stream_rows
              << " pieces\nvehicle   " << (vehicle ? vehicle->name : "not known")
              << "\nrecorded by " << info.program_version << '\n';
    for (const auto& [name, points] : info.tracks) {
        std::cout << "track     " << name << ", " << points << " points kept\n";
    }
    if (!site) return;
    for (const SiteFloor& floor : site->floors) print(floor);
}

Result<void> runInfo(const Options& options) {
    const auto reader = MissionReader::open(options.mission);
    if (!reader) return tl::make_unexpected(reader.error());
    const auto info = reader->info();
    if (!info) return tl::make_unexpected(info.error());
    const auto vehicle = reader->vehicle();
    if (!vehicle) return tl::make_unexpected(vehicle.error());
    const auto site = reader->site();
    if (!site) return tl::make_unexpected(site.error());
    const Content content{*info, *vehicle, *site, reader->salvaged()};
    tellDamage(options.mission, reader->salvaged());
    if (options.json) {
        std::cout << jsonLine(toJson(content));
    } else {
        print(content);
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
