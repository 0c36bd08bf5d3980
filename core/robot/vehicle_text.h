#pragma once

#include <string>

#include "core/result.h"
#include "core/robot/vehicle.h"
#include "core/text/toml.h"

namespace hedr {

// The section [text] of a vehicle.toml. Errors: kBadValue with the line.
Result<TextLineFormat> readTextSection(const toml::node& section, const std::string& path);

// The same as text, with the section's head.
std::string formatTextSection(const TextLineFormat& format);

}  // namespace hedr
