#include "core/calibration/history/surface_profile.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "core/calibration/history/vehicle_update.h"
#include "core/robot/vehicle_edit.h"
#include "core/text/trimmed.h"

namespace hedr {

namespace {

// What depends on the floor; a gyro does not.
constexpr std::array<std::string_view, 3> kWheelKeys{"wheelbase_m", "left_wheel_diameter_m",
                                                     "right_wheel_diameter_m"};

// Of a number that stays, the old value is the one that holds.
std::optional<SurfaceNumber> numberThatHolds(const RecordedParameter& found, Verdict verdict) {
    if (std::ranges::find(kWheelKeys, found.key) == kWheelKeys.end()) return std::nullopt;
    if (verdict == Verdict::kAccepted && !found.stays)
        return SurfaceNumber{found.key, found.now.value, found.now.margin()};
    if (!found.was) return std::nullopt;
    return SurfaceNumber{found.key, *found.was};
}

bool tellsWheels(const CalibrationRecord& record) {
    const bool holds =
        record.verdict == Verdict::kAccepted || record.verdict == Verdict::kUnchanged;
    return holds && std::ranges::any_of(record.found, [&](const RecordedParameter& found) {
               return numberThatHolds(found, record.verdict).has_value();
           });
}

// Its words in small letters, one blank between them.
std::string plainName(std::string_view surface) {
    std::string name;
    bool gap = false;
    for (const char c : surface) {
        if (c == ' ' || c == '\t' || c == '\r' || c == '\n') {
            gap = !name.empty();
            continue;
        }
        if (gap) name += ' ';
        gap = false;
        name += 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return name;
}

void put(SurfaceProfile& profile, SurfaceNumber number) {
    const auto before = std::ranges::find(profile.numbers, number.key, &SurfaceNumber::key);
    if (before == profile.numbers.end()) return profile.numbers.push_back(std::move(number));
    *before = std::move(number);
}

// What went with other numbers by so much goes with them on this floor too, from what was found
// here; where nothing was, the number of that time is the best there is, with no margin.
void putFollowing(SurfaceProfile& profile, const RecordedParameter& followed,
                  SurfaceNumber number) {
    const auto before = std::ranges::find(profile.numbers, number.key, &SurfaceNumber::key);
    number.margin.reset();
    if (before == profile.numbers.end() || !followed.was || *followed.was == 0.0)
        return put(profile, std::move(number));
    const double ratio = number.value / *followed.was;
    before->value *= ratio;
    if (before->margin) *before->margin *= ratio;
}

void add(SurfaceProfile& profile, const CalibrationRecord& record, const std::string& entry) {
    for (const RecordedParameter& found : record.found) {
        auto number = numberThatHolds(found, record.verdict);
        if (!number) continue;
        number->entry = entry;
        if (found.follows) {
            putFollowing(profile, found, *std::move(number));
        } else {
            put(profile, *std::move(number));
        }
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

bool isSameSurface(std::string_view a, std::string_view b) { return plainName(a) == plainName(b); }

std::vector<SurfaceProfile> surfaceProfiles(const std::vector<HistoryEntry>& entries) {
    std::vector<SurfaceProfile> profiles;
    for (const HistoryEntry& entry : entries) {
        if (!entry.record || !tellsWheels(*entry.record)) continue;
        const std::string surface(trimmed(entry.record->surface));
        if (surface.empty()) continue;
        SurfaceProfile profile;
        const auto before = std::ranges::find_if(profiles, [&](const SurfaceProfile& other) {
            return isSameSurface(other.surface, surface);
        });
        if (before != profiles.end()) {
            profile = std::move(*before);
            profiles.erase(before);
        }
        profile.surface = surface;
        add(profile, *entry.record, entry.name);
        profiles.push_back(std::move(profile));
    }
    return profiles;
}

Result<void> useSurface(const std::filesystem::path& vehicle_file, const SurfaceProfile& profile,
                        const std::string& time_utc, const std::string& who) {
    const std::string name = vehicle_file.string();
    const auto with_its_wheels = [&](const Result<std::string>& now) -> Result<std::string> {
        if (!now) return now;
        const auto vehicle = parseVehicle(*now, name).and_then([&](const Vehicle& before) {
            return onSurface(before, profile);
        });
        if (!vehicle) return tl::make_unexpected(vehicle.error());
        return withNumbersOf(*vehicle, *now, name);
    };
    return replaceVehicle(vehicle_file, with_its_wheels,
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
        if (isSameSurface(profile.surface, surface) || profile.track_widths.empty()) continue;
        EvidenceSeries series{"On " + profile.surface, EvidenceSeries::Shape::kDashes};
        for (const TrackWidth& width : profile.track_widths) {
            series.x.push_back(width.rate_rad_s);
            series.y.push_back(width.wheelbase_m.value);
        }
        plot->series.push_back(std::move(series));
    }
}

}  // namespace hedr
