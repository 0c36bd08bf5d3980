#include "core/site/mip_pyramid.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace hedr {
namespace {

constexpr int kSmallEnough_px = 512;

PlanLevel scaled(const PlanLevel& level, PlanLevel to) {
    const int type = CV_8UC(level.channels);
    const auto pixels = std::make_shared<std::vector<std::uint8_t>>(
        static_cast<std::size_t>(to.width_px) * static_cast<std::size_t>(to.height_px) *
        static_cast<std::size_t>(to.channels));
    const cv::Mat source(level.height_px, level.width_px, type,
                         const_cast<std::uint8_t*>(level.pixels->data()));  // only read
    cv::Mat target(to.height_px, to.width_px, type, pixels->data());
    cv::resize(source, target, target.size(), 0.0, 0.0, cv::INTER_AREA);
    to.pixels = pixels;
    return to;
}

}  // namespace

std::optional<PlanLevel> halfOf(const PlanLevel& level) {
    if (std::max(level.width_px, level.height_px) < kSmallEnough_px) return std::nullopt;
    return PlanLevel{(level.width_px + 1) / 2, (level.height_px + 1) / 2, level.channels};
}

std::vector<PlanLevel> mipPyramid(const PlanLevel& full_size) {
    std::vector<PlanLevel> levels{full_size};
    while (const auto half = halfOf(levels.back())) {
        levels.push_back(scaled(levels.back(), *half));
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
    return scaled(*from, {side(from->width_px), side(from->height_px), from->channels});
}

}  // namespace hedr
