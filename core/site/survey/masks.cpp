#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/site/survey/ink.h"

namespace hedr {
namespace {

constexpr double kDoor = 0.03;  // of the picture's side: half a gap that nothing comes through
constexpr double kLong = 6.0;   // compared with its width: a gap within a wall
constexpr double kLeastInside = 0.5;  // of the walls' hull, where they close a building

struct Parts {
    int count = 0;
    cv::Mat labels;  // 0: no part
    cv::Mat stats;

    int area(int i) const { return stats.at<int>(i, cv::CC_STAT_AREA); }
    double extent(int i) const {
        return std::hypot(stats.at<int>(i, cv::CC_STAT_WIDTH),
                          stats.at<int>(i, cv::CC_STAT_HEIGHT));
    }
};

constexpr int kByCorners = 8;  // pixels that touch so are connected
constexpr int kBySides = 4;

Parts partsOf(const cv::Mat& mask, int connectivity = kByCorners) {
    Parts parts;
    cv::Mat centres;
    parts.count =
        cv::connectedComponentsWithStats(mask, parts.labels, parts.stats, centres, connectivity);
    return parts;
}

// The parts for which `kept` says so, by label.
cv::Mat maskOf(const Parts& parts, const std::vector<std::uint8_t>& kept) {
    cv::Mat mask(parts.labels.size(), CV_8U);
    for (int row = 0; row < mask.rows; ++row) {
        const int* const label = parts.labels.ptr<int>(row);
        std::transform(label, label + mask.cols, mask.ptr<std::uint8_t>(row), [&](int i) {
            return kept[static_cast<std::size_t>(i)] != 0 ? std::uint8_t{255} : std::uint8_t{0};
        });
    }
    return mask;
}

// 255 for the labels that occur where the mask is set.
std::vector<std::uint8_t> labelsWithin(const Parts& parts, const cv::Mat& mask) {
    std::vector<std::uint8_t> within(static_cast<std::size_t>(parts.count), 0);
    for (int row = 0; row < mask.rows; ++row) {
        const int* const label = parts.labels.ptr<int>(row);
        const std::uint8_t* const set = mask.ptr<std::uint8_t>(row);
        for (int column = 0; column < mask.cols; ++column) {
            if (set[column] != 0) within[static_cast<std::size_t>(label[column])] = 255;
        }
    }
    within[0] = 0;
    return within;
}

cv::Mat hullOf(const cv::Mat& mask) {
    cv::Mat hull(mask.size(), CV_8U, cv::Scalar(0));
    std::vector<cv::Point> points;
    cv::findNonZero(mask, points);
    if (points.empty()) return hull;
    std::vector<cv::Point> corners;
    cv::convexHull(points, corners);
    cv::fillConvexPoly(hull, corners, cv::Scalar(255));
    return hull;
}

// What a disc reaches from anywhere outside the hull without touching a line.
cv::Mat reachedFromBeside(const cv::Mat& hull, const cv::Mat& lines, double radius_px) {
    const int frame_px = static_cast<int>(std::ceil(radius_px)) + 2;  // the disc gets around
    const auto framed = [&](const cv::Mat& mask) {
        cv::Mat wider;
        cv::copyMakeBorder(mask, wider, frame_px, frame_px, frame_px, frame_px, cv::BORDER_CONSTANT,
                           cv::Scalar(0));
        return wider;
    };
    const Parts roomy = partsOf(depthIn(~framed(lines)) > radius_px);
    const cv::Mat reached =
        grownBy(maskOf(roomy, labelsWithin(roomy, ~framed(hull))), radius_px - 0.5);
    return reached(cv::Rect(frame_px, frame_px, lines.cols, lines.rows)) & ~lines;
}

// The disc leaves corners out; they belong to what it reached.
cv::Mat withCorners(const cv::Mat& reached, const cv::Mat& lines, double radius_px) {
    const Parts rest = partsOf(~(reached | lines));
    std::vector<std::uint8_t> corners = labelsWithin(rest, grownBy(reached, 1.0));
    for (int i = 1; i < rest.count; ++i) {
        if (rest.area(i) > 4.0 * radius_px * radius_px) corners[static_cast<std::size_t>(i)] = 0;
    }
    return reached | maskOf(rest, corners);
}

}  // namespace

cv::Mat depthIn(const cv::Mat& mask) {
    cv::Mat depth;
    cv::distanceTransform(mask, depth, cv::DIST_L2, cv::DIST_MASK_5);
    return depth;
}

cv::Mat grownBy(const cv::Mat& mask, double radius_px) { return depthIn(~mask) <= radius_px; }

cv::Mat withoutSmallParts(const cv::Mat& mask, double least_extent_px) {
    const Parts parts = partsOf(mask);
    std::vector<std::uint8_t> large(static_cast<std::size_t>(parts.count), 0);
    for (int i = 1; i < parts.count; ++i) {
        large[static_cast<std::size_t>(i)] = parts.extent(i) >= least_extent_px ? 255 : 0;
    }
    return maskOf(parts, large);
}

cv::Mat narrowGaps(const cv::Mat& ink, double most_half_width_px) {
    const Parts gaps = partsOf(~ink, kBySides);  // a slanting line one pixel wide closes a gap
    const cv::Mat depth = depthIn(~ink);
    std::vector<double> half_widths(static_cast<std::size_t>(gaps.count), 0.0);
    for (int row = 0; row < ink.rows; ++row) {
        const int* const label = gaps.labels.ptr<int>(row);
        const float* const d = depth.ptr<float>(row);
        for (int column = 0; column < ink.cols; ++column) {
            double& widest = half_widths[static_cast<std::size_t>(label[column])];
            widest = std::max(widest, static_cast<double>(d[column]));
        }
    }
    std::vector<std::uint8_t> narrow(static_cast<std::size_t>(gaps.count), 0);
    for (int i = 1; i < gaps.count; ++i) {
        const double half_width_px = half_widths[static_cast<std::size_t>(i)];
        const bool is_long = gaps.extent(i) >= kLong * 2.0 * half_width_px;
        narrow[static_cast<std::size_t>(i)] = is_long && half_width_px <= most_half_width_px;
    }
    return maskOf(gaps, narrow);
}

cv::Mat outsideOf(const cv::Mat& lines, const cv::Mat& walls) {
    const cv::Mat all_lines = lines | walls;
    const cv::Mat hull = hullOf(walls);
    const double radius_px = kDoor * std::max(lines.cols, lines.rows);
    const cv::Mat reached = reachedFromBeside(hull, all_lines, radius_px);
    if (cv::countNonZero(hull & ~reached) < kLeastInside * cv::countNonZero(hull)) {
        return cv::Mat(lines.size(), CV_8U, cv::Scalar(0));
    }
    const Parts islands = partsOf(~withCorners(reached, all_lines, radius_px));
    return ~maskOf(islands, labelsWithin(islands, walls));
}

}  // namespace hedr
