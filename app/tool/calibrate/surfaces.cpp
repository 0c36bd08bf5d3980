#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/tool/calibrate/verbs.h"
#include "app/tool/json_line.h"
#include "core/calibration/history/surface_profile.h"
#include "core/geometry/angle.h"
#include "core/text/clean_text.h"
#include "core/text/nearest_name.h"

namespace hedr::tool {

namespace {

struct SurfaceOptions {
    std::string vehicle;
    std::string surface;
    std::string who;
    bool json = false;
};

// Says of what it cannot be known.
void tellDamaged(const std::vector<HistoryEntry>& history) {
    for (const HistoryEntry& entry : history) {
        if (!entry.record)
            std::cerr << "hedr: " << entry.name << ' ' << complaintAbout(entry) << '\n';
    }
}

nlohmann::ordered_json jsonOf(const SurfaceProfile& profile) {
    auto numbers = nlohmann::ordered_json::array();
    for (const SurfaceNumber& number : profile.numbers) {
        numbers.push_back(
            {{"key", number.key},
             {"value", number.value},
             {"margin_95", number.margin ? nlohmann::ordered_json(*number.margin) : nullptr},
             {"entry", number.entry}});
    }
    auto widths = nlohmann::ordered_json::array();
    for (const TrackWidth& width : profile.track_widths) {
        const Interval interval = width.wheelbase_m.interval();
        widths.push_back({{"rate_rad_s", width.rate_rad_s},
                          {"wheelbase_m", width.wheelbase_m.value},
                          {"interval_95", {interval.low, interval.high}},
                          {"turns", width.turns}});
    }
    return {{"surface", profile.surface}, {"numbers", numbers}, {"track_widths", widths}};
}

void print(const SurfaceProfile& profile) {
    std::cout << cleanText(profile.surface) << '\n';
    for (const SurfaceNumber& number : profile.numbers) {
        std::cout << "    " << number.key << ' ' << number.value;
        if (number.margin) std::cout << " +- " << *number.margin << " (95 %)";
        std::cout << (number.margin ? "  " : "  held  ") << number.entry << '\n';
    }
    for (const TrackWidth& width : profile.track_widths) {
        std::cout << "    turning by " << degFromRad(width.rate_rad_s) << " deg/s: wheelbase "
                  << width.wheelbase_m.value << " +- " << width.wheelbase_m.margin()
                  << " m (95 %), " << width.turns << " turns\n";
    }
}

Result<void> runSurfaces(const SurfaceOptions& options) {
    const auto history = historyBeside(options.vehicle);
    if (!history) return tl::make_unexpected(history.error());
    tellDamaged(*history);
    const std::vector<SurfaceProfile> profiles = surfaceProfiles(*history);
    if (options.json) {
        auto list = nlohmann::ordered_json::array();
        for (const SurfaceProfile& profile : profiles) list.push_back(jsonOf(profile));
        std::cout << jsonLine({{"surfaces", list}});
        return {};
    }
    if (profiles.empty()) {
        std::cout
            << options.vehicle
            << " has no calibrated floor yet: calibrate its wheels with --surface and --write\n";
    }
    for (const SurfaceProfile& profile : profiles) print(profile);
    return {};
}

Error unknownSurface(const std::string& name, const std::vector<SurfaceProfile>& profiles) {
    std::vector<std::string_view> known;
    std::string list;
    for (const SurfaceProfile& profile : profiles) {
        known.emplace_back(profile.surface);
        list += (list.empty() ? "known are " : ", ") + cleanText(profile.surface);
    }
    const std::string_view meant = nearestName(name, known);
    if (!meant.empty()) list = "it may be " + std::string(meant);
    return {ErrorCode::kUnknownName, name, list.empty() ? "no floor was calibrated yet" : list};
}

// A record that cannot be read may have had newer numbers of that floor.
const HistoryEntry* damagedSince(const SurfaceProfile& profile,
                                 const std::vector<HistoryEntry>& history) {
    const auto newest = std::ranges::max(profile.numbers, {}, &SurfaceNumber::entry).entry;
    const auto found = std::ranges::find_if(
        history, [&](const HistoryEntry& entry) { return !entry.record && entry.name > newest; });
    return found == history.end() ? nullptr : &*found;
}

Result<void> runUseSurface(const SurfaceOptions& options) {
    const auto history = historyBeside(options.vehicle);
    if (!history) return tl::make_unexpected(history.error());
    const std::vector<SurfaceProfile> profiles = surfaceProfiles(*history);
    const auto profile = std::ranges::find_if(profiles, [&](const SurfaceProfile& known) {
        return isSameSurface(known.surface, options.surface);
    });
    if (profile == profiles.end())
        return tl::make_unexpected(unknownSurface(options.surface, profiles));
    if (const HistoryEntry* damaged = damagedSince(*profile, *history))
        return tl::make_unexpected(damaged->record.error());
    auto used = useSurface(options.vehicle, *profile, nowUtc(), whoIsIt(options.who));
    if (!used) return used;
    std::cout << options.vehicle << " has the wheels as they are on " << cleanText(profile->surface)
              << '\n';
    return {};
}

}  // namespace

Job addCalibrateSurfaces(CLI::App& app) {
    const auto options = std::make_shared<SurfaceOptions>();
    addVehicleFile(app, options->vehicle);
    app.add_flag("--json", options->json, "One JSON object instead of text");
    return [options] { return runSurfaces(*options); };
}

Job addCalibrateUseSurface(CLI::App& app) {
    const auto options = std::make_shared<SurfaceOptions>();
    app.add_option("SURFACE", options->surface, "A floor that was calibrated")
        ->required()
        ->check(aName());
    addVehicleFile(app, options->vehicle);
    app.add_option("--operator", options->who, "Who does it, for the history")->check(aName());
    return [options] { return runUseSurface(*options); };
}

}  // namespace hedr::tool
