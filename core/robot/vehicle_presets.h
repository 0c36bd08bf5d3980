#pragma once

#include <array>
#include <string_view>

namespace hedr {

// The texts of assets/vehicles/*.toml, put here by cmake/VehiclePresets.cmake.
extern const std::array<std::string_view, 3> kVehiclePresetTexts;

}  // namespace hedr
