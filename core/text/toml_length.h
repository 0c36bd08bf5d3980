#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/result.h"

namespace hedr {

// The TOML library calls itself once for each level of a key ("a.a.a = 1"): some ten thousand
// levels overrun the stack. A text this short has fewer; files of ours have a twentieth of it.
inline constexpr std::size_t kLongestToml = 16384;  // bytes

// To be asked before parsing. Error: kBadFormat.
inline Result<void> checkTomlLength(std::string_view toml, const std::string& path) {
    if (toml.size() <= kLongestToml) return {};
    return fail(ErrorCode::kBadFormat, path,
                "it has " + std::to_string(toml.size()) + " bytes, such a file has " +
                    std::to_string(kLongestToml) + " at most");
}

}  // namespace hedr
