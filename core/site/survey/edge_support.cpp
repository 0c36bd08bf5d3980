#include "core/site/survey/edge_support.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hedr {
namespace {

constexpr double kLeastSlope = 0.012;  // of the tone per pixel, across the line
constexpr double kLeastCosine = 0.9;   // of the slope's angle to the normal
constexpr double kLeastStep = 0.05;    // of the tone: a twentieth of the brightness
constexpr std::array kNear_px{-2.0, -1.0, 0.0, 1.0, 2.0};
constexpr double kInside_px = 4.0;
constexpr std::array kOutside_px{4.0, 7.0, 10.0};

bool hasEdge(const PhotoTones& tones, Point<Small> p, Vector<Small> normal) {
    return std::ranges::any_of(kNear_px, [&](double off) {
        const Point<Small> at = p + off * normal;
        if (!tones.contains(at)) return false;
        const Vector<Small> slope = tones.slope(at);
        const double across = slope.x * normal.x + slope.y * normal.y;
        return across > kLeastSlope && across > kLeastCosine * slope.length();
    });
}

// A broad step, not a drawn line: the dark side stays dark.
bool hasStep(const PhotoTones& tones, Point<Small> p, Vector<Small> normal) {
    const Point<Small> bright = p + kInside_px * normal;
    if (!tones.contains(bright)) return false;
    const auto inside = static_cast<double>(tones.broad[tones.index(bright)]);
    return std::ranges::all_of(kOutside_px, [&](double off) {
        const Point<Small> dark = p + (-off) * normal;
        return !tones.contains(dark) ||
               inside - static_cast<double>(tones.broad[tones.index(dark)]) > kLeastStep;
    });
}

}  // namespace

EdgeSupport::EdgeSupport(const PhotoTones& tones, const EdgeLine& line) : line_(line) {
    // Every point of the picture is within a diagonal of the line's foot seen from the middle.
    const double diagonal_px = std::hypot(tones.width_px, tones.height_px);
    start_ = along({0.5 * tones.width_px, 0.5 * tones.height_px}) - 0.5 * diagonal_px;
    const Vector<Small> direction{-line.normal.y, line.normal.x};
    const Point<Small> foot = Point<Small>{} + line.offset * line.normal;
    const auto samples = static_cast<std::size_t>(diagonal_px) + 1;
    edges_.assign(samples + 1, 0);
    steps_.assign(samples + 1, 0);
    visible_.assign(samples + 1, 0);
    for (std::size_t i = 0; i < samples; ++i) {
        const Point<Small> p = foot + (start_ + static_cast<double>(i)) * direction;
        const bool visible = tones.contains(p);
        const bool edge = visible && hasEdge(tones, p, line.normal);
        const bool step = edge && hasStep(tones, p, line.normal);
        visible_[i + 1] = visible_[i] + (visible ? 1 : 0);
        edges_[i + 1] = edges_[i] + (edge ? 1 : 0);
        steps_[i + 1] = steps_[i] + (step ? 1 : 0);
    }
}

double EdgeSupport::along(Point<Small> p) const {
    return -line_.normal.y * p.x + line_.normal.x * p.y;
}

double EdgeSupport::count(const std::vector<int>& sums, Point<Small> from, Point<Small> to) const {
    const auto sample = [&](Point<Small> p) {
        const double last = static_cast<double>(sums.size() - 1);
        return static_cast<std::size_t>(std::clamp(along(p) - start_, 0.0, last));
    };
    return std::abs(sums[sample(to)] - sums[sample(from)]);
}

double EdgeSupport::share(const std::vector<int>& sums, Point<Small> from, Point<Small> to) const {
    return count(sums, from, to) / std::max(1.0, count(visible_, from, to));
}

}  // namespace hedr
