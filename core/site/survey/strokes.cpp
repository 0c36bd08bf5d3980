#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/site/survey/ink.h"

namespace hedr {
namespace {

constexpr std::size_t kWidths = 48;      // half widths that are told apart, in pixels
constexpr double kRounding_px = 0.25;    // of half widths, which are not whole where strokes slant
constexpr double kFew = 0.01;            // of the ink's area: specks, and the rims of strokes
constexpr double kRise = 1.5;            // of the length from one width to the next: walls begin
constexpr double kNearThick = 0.75;      // of a thick stroke's width
constexpr double kThinner = 0.6;         // than the pen: no wall, where walls are single lines
constexpr double kLeastSolid = 0.5;      // of the ink's area lies in walls where they are solid
constexpr double kLeastHollow = 0.25;    // of the ink's area is the area within hollow walls
constexpr double kWidestHollow = 0.012;  // half the gap, of the picture's side
constexpr double kLongerThanWide = 8.0;  // a wall, compared with a letter
constexpr double kPillar = 2.0;          // as wide as that many thin walls, it need not be long
constexpr double kShortestLine = 0.018;  // of the picture's side, where a wall is a single line

// The parts of the mask as wide as that, and where they are a little thinner.
cv::Mat partsAsWide(const cv::Mat& mask, double half_width_px) {
    return grownBy(depthIn(mask) >= half_width_px - kRounding_px, 2.0 * half_width_px) & mask;
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
            const auto width =
                static_cast<std::size_t>(static_cast<double>(d[column]) + kRounding_px);
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

// The half width from which strokes are walls, in a drawing with thin lines and thick ones: next to
// the thick ones, since thin lines are wider where they cross. 0: there is one kind of line.
std::size_t leastWallWidth(const std::vector<double>& lengths) {
    const std::size_t pen_px = penOf(lengths);
    std::size_t i = pen_px;
    while (i + 1 < lengths.size() && lengths[i + 1] <= kRise * lengths[i]) ++i;
    if (i + 1 == lengths.size()) return 0;
    while (i + 1 < lengths.size() && lengths[i + 1] > lengths[i]) ++i;
    const auto near_px = static_cast<std::size_t>(std::ceil(kNearThick * static_cast<double>(i)));
    return std::max(near_px, pen_px + 1);
}

double areaOf(const cv::Mat& mask) { return std::max(1, cv::countNonZero(mask)); }

// Long thick strokes, and pillars.
cv::Mat thickStrokes(const cv::Mat& ink, double least_half_width_px) {
    const cv::Mat thick = partsAsWide(ink, least_half_width_px);
    return withoutSmallParts(thick, kLongerThanWide * 2.0 * least_half_width_px) |
           partsAsWide(ink, kPillar * least_half_width_px);
}

// The thick strokes, where the ink is mostly those; else nothing.
cv::Mat solidWalls(const cv::Mat& ink) {
    const std::size_t least_px = leastWallWidth(lengthsByHalfWidth(ink));
    if (least_px == 0) return {};
    const cv::Mat walls = thickStrokes(ink, static_cast<double>(least_px));
    return areaOf(walls) >= kLeastSolid * areaOf(ink) ? walls : cv::Mat();
}

}  // namespace

cv::Mat wallsIn(const cv::Mat& ink) {
    cv::Mat solid = solidWalls(ink);
    if (!solid.empty()) return solid;
    const cv::Mat gaps = narrowGaps(ink, kWidestHollow * std::max(ink.cols, ink.rows));
    if (areaOf(gaps) >= kLeastHollow * areaOf(ink)) {
        cv::Mat filled = solidWalls(ink | gaps);
        if (!filled.empty()) return filled;
    }
    const auto pen_px = static_cast<double>(penOf(lengthsByHalfWidth(ink)));
    const double side_px = std::max(ink.cols, ink.rows);
    const cv::Mat lines = pen_px > 1.0 ? partsAsWide(ink, kThinner * pen_px) : ink;
    return withoutSmallParts(lines, std::max(16.0 * pen_px, kShortestLine * side_px));
}

}  // namespace hedr
