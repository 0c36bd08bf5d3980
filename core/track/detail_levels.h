#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/geometry/frames.h"

namespace hedr {

// Which of up to kPoints points a polyline needs at tolerances of 1 mm, 2 mm, 4 mm ... 32.8 m:
// Douglas-Peucker, one bit for each point and level. The first and the last point are in every
// level, and each level is part of the finer ones.
class DetailLevels {
  public:
    static constexpr std::size_t kPoints = 1024;
    static constexpr std::size_t kLevels = 16;
    static constexpr double kFinest_m = 0.001;

    explicit DetailLevels(std::span<const Point<World>> points);

    // The coarsest level within `tolerance_m`; kEveryPoint where even the finest is too coarse.
    static constexpr int kEveryPoint = -1;
    static int levelWithin(double tolerance_m);

    // Calls `visit` with the indices of the points of `level`, in order.
    template <class Visit>
    void forEach(int level, Visit visit) const {
        const auto& words = kept_[static_cast<std::size_t>(level)];
        for (std::size_t w = 0; w < words.size(); ++w)
            for (std::uint64_t bits = words[w]; bits != 0; bits &= bits - 1)
                visit(64 * w + static_cast<std::size_t>(std::countr_zero(bits)));
    }

  private:
    using Bits = std::array<std::uint64_t, kPoints / 64>;
    std::array<Bits, kLevels> kept_{};
};

}  // namespace hedr
