#pragma once

#include <cstdint>
#include <vector>

namespace hedr {

std::uint8_t onWhite(unsigned value, unsigned opacity);

// How the channels of a file lie side by side.
enum class Packing { kNone, kRgb, kRgba, kCmyk };

// What is packed at the front of `pixels` becomes BGRA on white in the same place, so that the
// image is in memory once.
void unpack(std::vector<std::uint8_t>& pixels, Packing packing);

}  // namespace hedr
