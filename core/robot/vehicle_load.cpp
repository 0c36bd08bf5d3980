#include <cassert>

#include "core/robot/vehicle.h"
#include "core/robot/vehicle_presets.h"
#include "core/text/text_file.h"

namespace hedr {

Result<Vehicle> loadVehicle(const std::filesystem::path& file) {
    return readTextFile(file).and_then(
        [&file](const std::string& text) { return parseVehicle(text, file.string()); });
}

Result<Vehicle> loadVehicleOrPreset(const std::string& file_or_preset) {
    std::error_code ignored;
    if (std::filesystem::exists(file_or_preset, ignored)) return loadVehicle(file_or_preset);
    std::string names;
    for (const Vehicle& preset : vehiclePresets()) {
        if (preset.name == file_or_preset) return preset;
        names += (names.empty() ? "" : ", ") + preset.name;
    }
    return fail(ErrorCode::kFileMissing, file_or_preset,
                "nor a preset of that name; presets are " + names);
}

std::vector<Vehicle> vehiclePresets() {
    std::vector<Vehicle> presets;
    for (const std::string_view text : kVehiclePresetTexts) {
        const auto vehicle = parseVehicle(text, "preset");
        assert(vehicle);
        presets.push_back(*vehicle);
    }
    return presets;
}

}  // namespace hedr
