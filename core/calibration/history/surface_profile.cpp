#include "core/calibration/history/surface_profile.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "core/robot/vehicle_edit.h"
#include "core/text/text_file.h"
#include "core/text/trimmed.h"

namespace hedr {

namespace {

// What depends on the floor; a gyro does not.
constexpr std::array<std::string_view, 3> kWheelKeys{"wheelbase_m", "left_wheel_diameter_m",
                                                     "right_wheel_diameter_m"};

bool holds(const CalibrationRecord& record) {
    return record.verdict == Verdict::kAccepted || record.verdict == Verdict::kUnchanged;
}

// Of a number that stays, the old value is the one that holds.
std::optional<double> valueThatHolds(const RecordedParameter& found, Verdict verdict) {
    const bool is_new = verdict == Verdict::kAccepted && !found.stays;
    return is_new ? std::optional(found.now.value) : found.was;
}

void put(SurfaceProfile& profile, SurfaceNumber number) {
    const auto before = std::ranges::find(profile.numbers, number.key, &SurfaceNumber::key);
    if (before == profile.numbers.end()) return profile.numbers.push_back(std::move(number));
    *before = std::move(number);
}

void add(SurfaceProfile& profile, const CalibrationRecord& record, const std::string& entry) {
    for (const RecordedParameter& found : record.found) {
        const auto value = valueThatHolds(found, record.verdict);
        if (!value || std::ranges::find(kWheelKeys, found.key) == kWheelKeys.end()) continue;
        put(profile, {found.key, *value, found.now.margin(), entry});
    }
    if (!record.track_widths.empty()) profile.track_widths = record.track_widths;
}

// The vehicle with the numbers of that floor.
Result<Vehicle> onSurface(Vehicle vehicle, const SurfaceProfile& profile) {
    for (const SurfaceNumber& number : profile.numbers) {
        const auto set = setVehicleNumber(vehicle, number.key, number.value);
        if (!set) return tl::make_unexpected(set.error());
    }
    return vehicle;
}

}  // namespace

std::vector<SurfaceProfile> surfaceProfiles(const std::vector<HistoryEntry>& entries) {
    std::vector<SurfaceProfile> profiles;
    for (const HistoryEntry& entry : entries) {
        if (!entry.record || !holds(*entry.record)) continue;
        const std::string surface(trimmed(entry.record->surface));
        if (surface.empty()) continue;
        SurfaceProfile profile{surface};
        const auto before = std::ranges::find(profiles, surface, &SurfaceProfile::surface);
        if (before != profiles.end()) {
            profile = std::move(*before);
            profiles.erase(before);
        }
        add(profile, *entry.record, entry.name);
        profiles.push_back(std::move(profile));
    }
    std::erase_if(profiles, [](const SurfaceProfile& profile) { return profile.numbers.empty(); });
    return profiles;
}

Result<void> useSurface(const std::filesystem::path& vehicle_file, const SurfaceProfile& profile,
                        const std::string& time_utc, const std::string& who) {
    const auto now = readTextFile(vehicle_file);
    if (!now) return tl::make_unexpected(now.error());
    const auto text =
        parseVehicle(*now, vehicle_file.string())
            .and_then([&](const Vehicle& vehicle) { return onSurface(vehicle, profile); })
            .and_then([&](const Vehicle& vehicle) {
                return withNumbersOf(vehicle, *now, vehicle_file.string());
            });
    if (!text) return tl::make_unexpected(text.error());
    return replaceVehicle(vehicle_file, *text,
                          {.time_utc = time_utc,
                           .who = who,
                           .surface = profile.surface,
                           .reason = "The wheels as they were found on this floor."});
}

void showSurfaces(Calibration& calibration, const std::vector<SurfaceProfile>& profiles,
                  const std::string& surface) {
    const auto plot = std::ranges::find(calibration.plots, kTrackWidthPlot, &EvidencePlot::title);
    if (plot == calibration.plots.end()) return;
    for (const SurfaceProfile& profile : profiles) {
        if (profile.surface == trimmed(surface) || profile.track_widths.empty()) continue;
        EvidenceSeries series{"On " + profile.surface, EvidenceSeries::Shape::kDashes};
        for (const TrackWidth& width : profile.track_widths) {
            series.x.push_back(width.rate_rad_s);
            series.y.push_back(width.wheelbase_m.value);
        }
        plot->series.push_back(std::move(series));
    }
}

}  // namespace hedr
