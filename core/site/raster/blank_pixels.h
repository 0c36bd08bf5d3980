#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/result.h"

namespace hedr {

// White pixels to read or paint into, where they and the smaller levels fit into the memory.
// Error: kImageTooLarge, before anything is allocated.
Result<std::shared_ptr<std::vector<std::uint8_t>>> blankPixels(double width_px, double height_px,
                                                               int channels,
                                                               const std::string& path);

}  // namespace hedr
