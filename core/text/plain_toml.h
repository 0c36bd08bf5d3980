#pragma once

#include <string>
#include <string_view>

#include "core/result.h"

namespace hedr {

// A TOML text of any length, made safe for the TOML library: the same lines and values in ASCII,
// without comments. The library calls itself once for each level of a key ("a.a.a = 1") and
// overruns the stack where there are some ten thousand; allowed is one dot per line in keys
// ("[[floor.plan]]"). And it does not know what to do with a letter beyond ASCII where it does not
// expect one. Strings stand on one line. Errors with path:line: kBadFormat.
Result<std::string> plainToml(std::string_view toml, const std::string& path);

// A string as TOML writes it, in quotes on one line, whatever it holds.
std::string quotedToml(std::string_view text);

}  // namespace hedr
