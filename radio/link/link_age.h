#pragma once

namespace hedr {

// From when on what was heard last is not true of this moment, and from when on the link is lost.
inline constexpr double kStaleAfter_s = 1.0;
inline constexpr double kLostAfter_s = 3.0;

}  // namespace hedr
