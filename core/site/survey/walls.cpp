#include "core/site/survey/walls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "core/site/survey/ink.h"

namespace hedr {
namespace {

constexpr int kMostCells = 4'000'000;

// The finest level that has no more pixels than there may be cells.
const PlanLevel& levelFor(const PlanImage& plan) {
    const auto fits = [](const PlanLevel& level) {
        return static_cast<double>(level.width_px) * level.height_px <= kMostCells;
    };
    const auto found = std::ranges::find_if(plan.levels, fits);
    return found == plan.levels.end() ? plan.levels.back() : *found;
}

std::array<double, 256> sharesOf(const PlanLevel& level) {
    std::array<double, 256> shares{};
    for (const std::uint8_t value : *level.pixels) shares[value] += 1.0;
    for (double& share : shares) share /= static_cast<double>(level.pixels->size());
    return shares;
}

// Greys of a robot's map: up to `wall` is a wall, from `free` on free space.
struct MapGreys {
    int wall = 0;
    int free = 0;
};

// Map makers write what is unknown as one grey all over (205 or 128, or another), and map_server
// writes free space as 254, where a drawing has white.
std::optional<MapGreys> mapGreysOf(const PlanLevel& full_size) {
    if (full_size.channels != 1) return {};
    const std::array<double, 256> shares = sharesOf(full_size);
    const auto sum = [&](int from, int to) {
        double share = 0.0;
        for (int value = from; value <= to; ++value) share += shares[static_cast<size_t>(value)];
        return share;
    };
    const auto* const most = std::max_element(shares.begin() + 90, shares.begin() + 231);
    const int unknown = static_cast<int>(most - shares.begin());
    const bool flat = *most > 0.1 && *most > 4.0 * (sum(unknown - 3, unknown + 3) - *most);
    if (flat && sum(unknown + 20, 255) > 0.02) {
        return MapGreys{std::min(89, unknown - 20), unknown + 1};
    }
    if (shares[254] > 0.02 && shares[254] > 5.0 * shares[255]) return MapGreys{89, 206};
    return {};
}

FreeSpace emptySpace(const PlanImage& plan, const PlanLevel& level) {
    const double px_per_cell = static_cast<double>(plan.levels.front().width_px) / level.width_px;
    const auto count =
        static_cast<std::size_t>(level.width_px) * static_cast<std::size_t>(level.height_px);
    return {level.width_px, level.height_px, px_per_cell, std::vector<Cell>(count, Cell::kUnknown)};
}

void mark(FreeSpace& space, const cv::Mat& mask, Cell as) {
    for (int row = 0; row < space.height; ++row) {
        const auto* const marked = mask.ptr<std::uint8_t>(row);
        Cell* const cells = space.cells.data() + static_cast<std::ptrdiff_t>(row) * space.width;
        for (int column = 0; column < space.width; ++column) {
            if (marked[column] != 0) cells[column] = as;
        }
    }
}

class Steps {
  public:
    Steps(const PlanImage& plan, const PlanProgress& progress) : plan_(plan), progress_(progress) {}
    bool canceled(double share) const { return progress_ && !progress_(share); }
    tl::unexpected<Error> cancel() const {
        return fail(ErrorCode::kCanceled, plan_.image_file.string());
    }

  private:
    const PlanImage& plan_;
    const PlanProgress& progress_;
};

}  // namespace

Result<FreeSpace> freeSpaceOf(const PlanImage& plan, const PlanProgress& progress) {
    if (plan.levels.empty() || !levelFor(plan).pixels) {
        return fail(ErrorCode::kNoData, plan.image_file.string(), "the plan has no pixels");
    }
    const Steps steps(plan, progress);
    if (steps.canceled(0.0)) return steps.cancel();
    const PlanLevel& level = levelFor(plan);
    const cv::Mat grey = greyOf(level);
    FreeSpace space = emptySpace(plan, level);
    if (const auto greys = mapGreysOf(plan.levels.front().pixels ? plan.levels.front() : level)) {
        mark(space, grey >= greys->free, Cell::kFree);
        mark(space, grey <= greys->wall, Cell::kWall);
        return space;
    }
    const cv::Mat drawing = levelled(grey);
    if (drawing.empty()) return space;
    if (steps.canceled(0.3)) return steps.cancel();
    const cv::Mat walls = wallsIn(inkOf(drawing));
    if (steps.canceled(0.6)) return steps.cancel();
    mark(space, ~outsideOf(linesOf(drawing), walls), Cell::kFree);
    mark(space, walls, Cell::kWall);
    if (steps.canceled(1.0)) return steps.cancel();
    return space;
}

namespace {

// Cells whose middle is no farther than `radius` cells from the line between a and b.
void paint(FreeSpace& space, Point<Plan> a, Point<Plan> b, double radius, Cell as) {
    const auto clamped = [](double value, int size) {
        return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(size)));
    };
    const int left = clamped(std::floor(std::min(a.x, b.x) - radius), space.width);
    const int right = clamped(std::ceil(std::max(a.x, b.x) + radius), space.width);
    const int top = clamped(std::floor(std::min(a.y, b.y) - radius), space.height);
    const int bottom = clamped(std::ceil(std::max(a.y, b.y) + radius), space.height);
    const Vector<Plan> along = b - a;
    const double squared = along.x * along.x + along.y * along.y;
    for (int row = top; row < bottom; ++row) {
        for (int column = left; column < right; ++column) {
            const Vector<Plan> d = Point<Plan>{column + 0.5, row + 0.5} - a;
            const double t = squared > 0.0
                                 ? std::clamp((d.x * along.x + d.y * along.y) / squared, 0.0, 1.0)
                                 : 0.0;
            if ((d - t * along).length() > radius) continue;
            space.cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(space.width) +
                        static_cast<std::size_t>(column)] = as;
        }
    }
}

}  // namespace

FreeSpace withStrokes(FreeSpace space, const PlanPlacement& placement, int height_px,
                      std::span<const WallStroke> strokes) {
    const Transform<Plan, World> plan_from_world = worldFromPlan(placement, height_px).inverse();
    const double cells_per_m = 1.0 / (placement.resolution_m * space.plan_px_per_cell);
    const auto cell_of = [&](Point<World> p) {
        const Point<Plan> at = plan_from_world * p;
        return Point<Plan>{at.x / space.plan_px_per_cell, at.y / space.plan_px_per_cell};
    };
    for (const WallStroke& stroke : strokes) {
        const Cell as = stroke.pen == WallPen::kWall ? Cell::kWall : Cell::kFree;
        // A line as thin as a cell has no gaps.
        const double radius = std::max(0.5 * stroke.width_m * cells_per_m, 0.71);
        for (std::size_t i = 0; i < stroke.points.size(); ++i) {
            const Point<World> from = stroke.points[i == 0 ? 0 : i - 1];
            paint(space, cell_of(from), cell_of(stroke.points[i]), radius, as);
        }
    }
    return space;
}

}  // namespace hedr
