#pragma once

#include <span>
#include <string>
#include <string_view>

namespace hedr {

// The one of `known` that `name` was most likely meant to be, for a hint in a message; empty where
// none is near.
std::string_view nearestName(std::string_view name, std::span<const std::string_view> known);

}  // namespace hedr
