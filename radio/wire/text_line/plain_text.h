#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace hedr {

// A robot's words as they may be shown: at most `longest` bytes, cut between letters, without
// control characters and those that hide or turn what follows. None where it is no UTF-8.
std::optional<std::string> plainText(std::string_view text, std::size_t longest);

}  // namespace hedr
