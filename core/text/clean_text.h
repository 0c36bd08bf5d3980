#pragma once

#include <string>
#include <string_view>

namespace hedr {

// Text of a stranger as it may be shown and kept: one line of valid UTF-8, at most `longest_bytes`.
// Control characters become spaces; what is no UTF-8, and what turns the direction of writing,
// becomes U+FFFD.
std::string cleanText(std::string_view text, std::size_t longest_bytes = 200);

bool isUtf8(std::string_view text);

}  // namespace hedr
