#pragma once

// The one way to the TOML library. Its own assertions are wrong: they stop the program at a text
// such as "[+a]", for which it has an error a few lines on.
#define TOML_ASSERT(expression) static_cast<void>(0)
#include <toml++/toml.h>

#include <string>
#include <string_view>

#include "core/result.h"

namespace hedr {

// Any text: what the library cannot bear is refused (plain_toml.h). Error with path:line:
// kBadFormat.
Result<toml::table> parseToml(std::string_view text, const std::string& path);

}  // namespace hedr
