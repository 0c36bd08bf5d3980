#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace hedr {

// Whether those are the first bytes of a BMP with a header of version 4 or 5.
bool isNewBmp(std::string_view bytes);

// The bytes of such a file with a header of version 3, and the same pixels; none: it is no such
// file, or damaged.
std::optional<std::string> asOldBmp(std::string bytes);

}  // namespace hedr
