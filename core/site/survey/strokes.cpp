#include <algorithm>
#include <cstddef>
#include <numeric>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/site/survey/ink.h"

namespace hedr {
namespace {

constexpr std::size_t kWidths = 48;    // half widths that are told apart, in pixels
constexpr double kFew = 0.05;          // of the ink's area: specks, and the rims of strokes
constexpr double kRise = 1.5;          // of the length from one width to the next: walls begin
constexpr double kLeastSolid = 0.5;    // of the ink's area lies in walls where they are solid
constexpr double kLeastHollow = 0.25;  // gaps of one width per length of line where they are hollow
constexpr double kWidestHollow = 0.012;  // half the gap, of the picture's side
constexpr double kLongerThanWide = 5.0;  // a wall, compared with a letter
constexpr double kShortestLine = 0.018;  // of the picture's side, where a wall is a single line

// The parts of the mask as wide as that, and a little of what continues them.
cv::Mat partsAsWide(const cv::Mat& mask, double half_width_px) {
    return grownBy(depthIn(mask) >= half_width_px, 3.0 * half_width_px) & mask;
}

// Lengths of the mask's middle lines, by half width in whole pixels.
std::vector<double> lengthsByHalfWidth(const cv::Mat& mask) {
    const cv::Mat depth = depthIn(mask);
    cv::Mat highest;
    cv::dilate(depth, highest, {});
    std::vector<double> lengths(kWidths, 0.0);
    for (int row = 0; row < depth.rows; ++row) {
        const float* const d = depth.ptr<float>(row);
        const float* const h = highest.ptr<float>(row);
        for (int column = 0; column < depth.cols; ++column) {
            const auto width = static_cast<std::size_t>(d[column] + 0.25F);
            if (width > 0 && width < kWidths && d[column] == h[column]) lengths[width] += 1.0;
        }
    }
    return lengths;
}

double sumOf(const std::vector<double>& lengths) {
    return std::accumulate(lengths.begin(), lengths.end(), 0.0);
}

// Half the width of the thinnest stroke that makes a good part of the ink's area.
std::size_t penOf(const std::vector<double>& lengths) {
    std::vector<double> areas(lengths.size());
    for (std::size_t i = 0; i < lengths.size(); ++i) {
        areas[i] = lengths[i] * (2.0 * static_cast<double>(i) - 1.0);
    }
    const double few = kFew * sumOf(areas);
    double sum = 0.0;
    for (std::size_t i = 1; i < areas.size(); ++i) {
        sum += areas[i];
        if (sum > few) return i;
    }
    return 1;
}

// The half width from which strokes are walls, in a drawing with thin lines and thick ones: the
// least common one between them. 0: there is one kind of line.
std::size_t leastWallWidth(const std::vector<double>& lengths, std::size_t pen_px) {
    for (std::size_t i = pen_px; i + 1 < lengths.size(); ++i) {
        if (lengths[i + 1] > kRise * lengths[i]) return std::max(i, pen_px + 1);
    }
    return 0;
}

double areaOf(const cv::Mat& mask) { return std::max(1, cv::countNonZero(mask)); }

cv::Mat solidWalls(const cv::Mat& ink, double least_half_width_px) {
    const cv::Mat thick = partsAsWide(ink, least_half_width_px);
    return withoutSmallParts(thick, kLongerThanWide * 2.0 * least_half_width_px);
}

// Half the width of the gap between the two lines of a hollow wall; 0: walls are not hollow.
std::size_t hollowOf(const cv::Mat& ink, double line_length_px) {
    const std::vector<double> gaps = lengthsByHalfWidth(~ink);
    double best = 0.0;
    std::size_t best_width = 0;
    const auto widest = static_cast<std::size_t>(kWidestHollow * std::max(ink.cols, ink.rows));
    for (std::size_t i = 1; i + 1 < gaps.size() && i <= widest; ++i) {
        const double length = gaps[i - 1] + gaps[i] + gaps[i + 1];
        if (length <= best) continue;
        best = length;
        best_width = i;
    }
    return best >= kLeastHollow * line_length_px ? best_width + 1 : 0;
}

// The ink with gaps of that half width filled, but not what then is wider than a wall: hatching,
// stairs, tiles.
cv::Mat filled(const cv::Mat& ink, double half_gap_px, double pen_px) {
    const double reach_px = half_gap_px + 0.5;
    const cv::Mat closed = (depthIn(grownBy(ink, reach_px)) > reach_px) | ink;
    const double too_wide_px = 2.0 * (half_gap_px + 2.0 * pen_px);
    const cv::Mat too_wide = grownBy(depthIn(closed) >= too_wide_px, too_wide_px);
    return closed & (~too_wide | ink);
}

}  // namespace

cv::Mat wallsIn(const cv::Mat& ink) {
    const double least_px = kLeastSolid * areaOf(ink);
    const std::vector<double> lengths = lengthsByHalfWidth(ink);
    const std::size_t pen_px = penOf(lengths);
    if (const std::size_t thick_px = leastWallWidth(lengths, pen_px); thick_px > 0) {
        const cv::Mat walls = solidWalls(ink, static_cast<double>(thick_px));
        if (areaOf(walls) >= least_px) return walls;
    }
    if (const std::size_t half_gap_px = hollowOf(ink, sumOf(lengths)); half_gap_px > 0) {
        const auto gap_px = static_cast<double>(half_gap_px);
        const cv::Mat solid = filled(ink, gap_px, static_cast<double>(pen_px));
        const cv::Mat walls = solidWalls(solid, static_cast<double>(pen_px + 1));
        if (areaOf(walls) >= least_px) return walls;
    }
    const double side_px = std::max(ink.cols, ink.rows);
    return withoutSmallParts(ink,
                             std::max(16.0 * static_cast<double>(pen_px), kShortestLine * side_px));
}

}  // namespace hedr
