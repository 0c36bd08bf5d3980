#include "core/site/raster/orientation.h"

#include <opencv2/core.hpp>
#include <utility>

namespace hedr {
namespace {

using Pixels = std::vector<std::uint8_t>;

cv::Mat view(const PlanLevel& level, const Pixels& pixels) {
    return {level.height_px, level.width_px, CV_8UC(level.channels),
            const_cast<std::uint8_t*>(pixels.data())};
}

// Rows and columns change places; then or instead, the picture is turned over.
struct Turn {
    bool transposed = false;
    bool left_to_right = false;
    bool upside_down = false;
};

Turn turnOf(int exif_orientation) {
    switch (exif_orientation) {
        case 2:
            return {false, true, false};
        case 3:
            return {false, true, true};
        case 4:
            return {false, false, true};
        case 5:
            return {true, false, false};
        case 6:
            return {true, true, false};
        case 7:
            return {true, true, true};
        case 8:
            return {true, false, true};
        default:
            return {};
    }
}

}  // namespace

PlanLevel oriented(PlanLevel level, int exif_orientation) {
    const Turn turn = turnOf(exif_orientation);
    if (!turn.transposed && !turn.left_to_right && !turn.upside_down) return level;
    PlanLevel result = level;
    if (turn.transposed) std::swap(result.width_px, result.height_px);
    if (!level.pixels) return result;
    const auto pixels = std::make_shared<Pixels>(level.pixels->size());
    const cv::Mat from = view(level, *level.pixels);
    cv::Mat to = view(result, *pixels);
    if (turn.transposed) {
        cv::transpose(from, to);
    } else {
        from.copyTo(to);
    }
    if (turn.left_to_right || turn.upside_down) {
        const int code = !turn.left_to_right ? 0 : (turn.upside_down ? -1 : 1);
        cv::flip(to, to, code);
    }
    result.pixels = pixels;
    return result;
}

}  // namespace hedr
