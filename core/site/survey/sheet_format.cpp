#include "core/site/survey/sheet_format.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace hedr {
namespace {

constexpr std::array kFormats{
    SheetFormat{"A4, A3, A2, A1, A0", std::numbers::sqrt2},
    SheetFormat{"Letter, ANSI C", 11.0 / 8.5},
    SheetFormat{"Tabloid, ANSI D", 17.0 / 11.0},
    SheetFormat{"ARCH A, ARCH C, 4:3", 4.0 / 3.0},
    SheetFormat{"ARCH B, ARCH D, 3:2", 3.0 / 2.0},
    SheetFormat{"screen, 16:9", 16.0 / 9.0},
    SheetFormat{"square", 1.0},
};
constexpr double kUsual = 0.5;
constexpr double kLongest = 2.5;
constexpr double kLeast = 0.05;
// What the corners' sigma does not know: paper that is curved, a frame drawn within the margins.
constexpr double kSigmaOfPaper = 0.004;

double normalDensity(double error, double sigma) {
    return std::exp(-0.5 * error * error / (sigma * sigma)) /
           (sigma * std::sqrt(2.0 * std::numbers::pi));
}

}  // namespace

std::span<const SheetFormat> sheetFormats() { return kFormats; }

std::vector<LikelySheetFormat> likelyFormats(const SheetAspect& seen) {
    const double longer = std::max(seen.value, 1.0 / seen.value);
    const double sigma = std::hypot(seen.sigma, kSigmaOfPaper);
    double sum = (1.0 - kUsual) / std::log(kLongest);
    std::vector<LikelySheetFormat> likely;
    for (const SheetFormat& format : kFormats) {
        const double side = format.longer_by_shorter;
        const double weight = kUsual / static_cast<double>(kFormats.size()) *
                              normalDensity(std::log(longer / side), sigma);
        likely.push_back({format, seen.value < 1.0 ? 1.0 / side : side, weight});
        sum += weight;
    }
    for (LikelySheetFormat& each : likely) each.probability /= sum;
    std::ranges::sort(likely, std::greater{}, &LikelySheetFormat::probability);
    std::erase_if(likely, [](const auto& each) { return each.probability < kLeast; });
    return likely;
}

}  // namespace hedr
