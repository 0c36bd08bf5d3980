#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/calibration/calibration.h"
#include "core/calibration/history/vehicle_history.h"
#include "core/calibration/track_width.h"
#include "core/result.h"

namespace hedr {

// A number of the vehicle file as it holds on a floor.
struct SurfaceNumber {
    std::string key;
    double value = 0.0;
    std::optional<double> margin{};  // 95 %, where that calibration found it; none: it held
    std::string entry{};             // of the history, which that calibration is
};

// What the calibrations of a robot say of its wheels on one floor: tracks slip otherwise on a
// carpet than on tiles.
struct SurfaceProfile {
    std::string surface{};
    std::vector<SurfaceNumber> numbers{};    // the latest of each key
    std::vector<TrackWidth> track_widths{};  // of the latest drive
};

// Whether people mean the same floor: blanks and the case of a to z make no difference.
bool isSameSurface(std::string_view a, std::string_view b);

// Of each floor that the entries name; the one whose wheels were calibrated last comes last. What
// was refused or not proven says nothing.
std::vector<SurfaceProfile> surfaceProfiles(const std::vector<HistoryEntry>& entries);

// Gives the vehicle file the numbers of a floor, as replaceVehicle does. Errors: those of it.
Result<void> useSurface(const std::filesystem::path& vehicle_file, const SurfaceProfile& profile,
                        const std::string& time_utc, const std::string& who);

// Lays the wheelbases found on other floors than `surface` beside those that are being found.
void showSurfaces(Calibration& calibration, const std::vector<SurfaceProfile>& profiles,
                  const std::string& surface);

}  // namespace hedr
