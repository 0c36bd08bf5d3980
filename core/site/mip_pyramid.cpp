#include "core/site/mip_pyramid.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace hedr {
namespace {

constexpr int kSmallEnough_px = 512;

PlanPart wholeOf(const PlanLevel& level) { return {0, 0, level.width_px, level.height_px}; }

}  // namespace

PlanLevel areaAveraged(const PlanLevel& level, const PlanPart& part, int width_px, int height_px) {
    const int type = CV_8UC(level.channels);
    const auto pixels = std::make_shared<std::vector<std::uint8_t>>(
        static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px) *
        static_cast<std::size_t>(level.channels));
    const cv::Mat source(level.height_px, level.width_px, type,
                         const_cast<std::uint8_t*>(level.pixels->data()));  // only read
    cv::Mat target(height_px, width_px, type, pixels->data());
    const cv::Rect covered(part.left_px, part.top_px, part.width_px, part.height_px);
    cv::resize(source(covered), target, target.size(), 0.0, 0.0, cv::INTER_AREA);
    return {width_px, height_px, level.channels, pixels};
}

std::optional<PlanLevel> halfOf(const PlanLevel& level) {
    if (std::max(level.width_px, level.height_px) < kSmallEnough_px) return std::nullopt;
    return PlanLevel{(level.width_px + 1) / 2, (level.height_px + 1) / 2, level.channels};
}

std::vector<PlanLevel> mipPyramid(const PlanLevel& full_size) {
    std::vector<PlanLevel> levels{full_size};
    while (const auto half = halfOf(levels.back())) {
        const PlanLevel& last = levels.back();
        levels.push_back(areaAveraged(last, wholeOf(last), half->width_px, half->height_px));
    }
    return levels;
}

PlanLevel fittedInto(const std::vector<PlanLevel>& levels, int side_px) {
    const auto longer = [](const PlanLevel& level) {
        return std::max(level.width_px, level.height_px);
    };
    const auto from = std::find_if(levels.rbegin(), levels.rend() - 1, [&](const PlanLevel& level) {
        return longer(level) >= side_px;
    });
    const double factor = static_cast<double>(side_px) / longer(*from);
    if (factor >= 1.0) return *from;
    const auto side = [&](int px) {
        return std::max(1, static_cast<int>(std::lround(factor * px)));
    };
    return areaAveraged(*from, wholeOf(*from), side(from->width_px), side(from->height_px));
}

}  // namespace hedr
