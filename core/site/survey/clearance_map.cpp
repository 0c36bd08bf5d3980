#include "core/site/survey/clearance_map.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>

namespace hedr {
namespace {

constexpr double kCell_m = 0.05;
constexpr double kMostCells = 4e6;

// What wins where several cells of a plan become one.
constexpr std::uint8_t rankOf(Cell cell) {
    return cell == Cell::kWall ? 2 : cell == Cell::kFree ? 1 : 0;
}

cv::Mat ranksOf(const FreeSpace& space, cv::Size size, double ratio) {
    cv::Mat ranks(size, CV_8U, cv::Scalar(0));
    auto cell = space.cells.begin();
    for (int y = 0; y < space.height; ++y) {
        const int row = std::min(static_cast<int>(y * ratio), size.height - 1);
        auto* ranks_of_row = ranks.ptr<std::uint8_t>(row);
        for (int x = 0; x < space.width; ++x, ++cell) {
            auto& rank = ranks_of_row[std::min(static_cast<int>(x * ratio), size.width - 1)];
            rank = std::max(rank, rankOf(*cell));
        }
    }
    return ranks;
}

// From the middle of each cell that is `open` to the edge of the next that is not.
std::vector<float> distances(const cv::Mat& open, double cell_m, float beside_m) {
    cv::Mat distance;
    cv::distanceTransform(open, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    std::vector<float> result(distance.begin<float>(), distance.end<float>());
    for (float& d : result) {
        d = std::clamp((d - 0.5F) * static_cast<float>(cell_m), 0.0F, ClearanceMap::kFar_m);
    }
    result.push_back(beside_m);
    return result;
}

}  // namespace

ClearanceMap::ClearanceMap(const FreeSpace& space, double resolution_m) {
    const double given_m = space.plan_px_per_cell * resolution_m;
    const double area_m2 = given_m * given_m * space.width * space.height;
    cell_m_ = std::max({kCell_m, given_m, std::sqrt(area_m2 / kMostCells)});
    const double ratio = given_m / cell_m_;
    width_ = std::max(1, static_cast<int>(std::ceil(space.width * ratio - 1e-6)));
    height_ = std::max(1, static_cast<int>(std::ceil(space.height * ratio - 1e-6)));
    const cv::Mat ranks = ranksOf(space, {width_, height_}, ratio);
    to_wall_m_ = distances(ranks != rankOf(Cell::kWall), cell_m_, kFar_m);
    to_unfree_m_ = distances(ranks == rankOf(Cell::kFree), cell_m_, 0.0F);
}

std::size_t ClearanceMap::indexOf(Point<PlanGround> p) const {
    const double column = p.x / cell_m_;
    const double row = -p.y / cell_m_;
    const bool beside = !(column >= 0.0 && row >= 0.0 && column < width_ && row < height_);
    if (beside) return to_wall_m_.size() - 1;
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(column);
}

// No wall is nearer than the next one, so that steps may be as long as the way to it.
double ClearanceMap::clearance_m(Point<PlanGround> p, Vector<PlanGround> direction,
                                 double longest_m) const {
    double way_m = 0.0;
    while (way_m < longest_m) {
        const double free_m = toWall_m(p + way_m * direction);
        if (free_m <= 0.0) return way_m;
        way_m += std::max(free_m, 0.5 * cell_m_);
    }
    return longest_m;
}

}  // namespace hedr
