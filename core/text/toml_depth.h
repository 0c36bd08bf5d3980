#pragma once

#include <string>
#include <string_view>

#include "core/result.h"

namespace hedr {

// For a TOML text that may be long (see toml_length.h for the short ones). The TOML library calls
// itself once for each level of a key ("a.a.a = 1") and overruns the stack where there are some ten
// thousand. Allowed is one dot per line in keys ("[[floor.plan]]") and no string of several lines.
// To be asked before parsing. Error: kBadFormat (path:line).
Result<void> checkTomlDepth(std::string_view toml, const std::string& path);

// A string as TOML writes it, in quotes on one line, whatever it holds.
std::string quotedToml(std::string_view text);

}  // namespace hedr
