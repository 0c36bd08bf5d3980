#include "tests/core/site/survey/jpeg_like.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace hedr::test {
namespace {

using Block = Eigen::Matrix<double, 8, 8>;

constexpr std::array kTable{
    16, 11, 10, 16, 24,  40,  51,  61,  12, 12, 14, 19, 26,  58,  60,  55,  //
    14, 13, 16, 24, 40,  57,  69,  56,  14, 17, 22, 29, 51,  87,  80,  62,  //
    18, 22, 37, 56, 68,  109, 103, 77,  24, 35, 55, 64, 81,  104, 113, 92,  //
    49, 64, 78, 87, 103, 121, 120, 101, 72, 92, 95, 98, 112, 100, 103, 99};

Block cosines() {
    Block result;
    for (int k = 0; k < 8; ++k) {
        for (int i = 0; i < 8; ++i) {
            result(k, i) = (k == 0 ? std::sqrt(0.125) : 0.5) *
                           std::cos((2 * i + 1) * k * std::numbers::pi / 16.0);
        }
    }
    return result;
}

Block steps(int quality) {
    const int scale = quality < 50 ? 5000 / quality : 200 - 2 * quality;
    Block result;
    for (int i = 0; i < 64; ++i) {
        const int step = (kTable[static_cast<std::size_t>(i)] * scale + 50) / 100;
        result(i / 8, i % 8) = std::clamp(step, 1, 255);
    }
    return result;
}

}  // namespace

PlanLevel jpegLike(const PlanLevel& image, int quality) {
    const Block transform = cosines();
    const Block step = steps(quality);
    auto pixels = std::make_shared<std::vector<std::uint8_t>>(*image.pixels);
    const auto at = [&](int x, int y) -> std::uint8_t& {
        const int column = std::min(x, image.width_px - 1);
        const int row = std::min(y, image.height_px - 1);
        return (*pixels)[static_cast<std::size_t>(row * image.width_px + column)];
    };
    for (int top = 0; top < image.height_px; top += 8) {
        for (int left = 0; left < image.width_px; left += 8) {
            Block block;
            for (int i = 0; i < 64; ++i)
                block(i / 8, i % 8) = at(left + i % 8, top + i / 8) - 128.0;
            const Block waves = transform * block * transform.transpose();
            const Block kept =
                waves.cwiseQuotient(step).array().round().matrix().cwiseProduct(step);
            block = transform.transpose() * kept * transform;
            for (int i = 63; i >= 0; --i) {  // where pixels repeat at the edge, the first one stays
                const double value = std::clamp(block(i / 8, i % 8) + 128.0, 0.0, 255.0);
                at(left + i % 8, top + i / 8) = static_cast<std::uint8_t>(std::lround(value));
            }
        }
    }
    return {image.width_px, image.height_px, 1, pixels};
}

}  // namespace hedr::test
