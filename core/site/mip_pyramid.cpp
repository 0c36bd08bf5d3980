#include "core/site/mip_pyramid.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace hedr {
namespace {

constexpr int kSmallEnough_px = 512;

PlanLevel halved(const PlanLevel& level) {
    const int type = CV_8UC(level.channels);
    PlanLevel half{(level.width_px + 1) / 2, (level.height_px + 1) / 2, level.channels, {}};
    const auto pixels = std::make_shared<std::vector<std::uint8_t>>(
        static_cast<std::size_t>(half.width_px) * static_cast<std::size_t>(half.height_px) *
        static_cast<std::size_t>(half.channels));
    const cv::Mat source(level.height_px, level.width_px, type,
                         const_cast<std::uint8_t*>(level.pixels->data()));  // only read
    cv::Mat target(half.height_px, half.width_px, type, pixels->data());
    cv::resize(source, target, target.size(), 0.0, 0.0, cv::INTER_AREA);
    half.pixels = pixels;
    return half;
}

}  // namespace

std::vector<PlanLevel> mipPyramid(const PlanLevel& full_size) {
    std::vector<PlanLevel> levels{full_size};
    while (std::max(levels.back().width_px, levels.back().height_px) >= kSmallEnough_px) {
        levels.push_back(halved(levels.back()));
    }
    return levels;
}

}  // namespace hedr
