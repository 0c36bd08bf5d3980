#include "ui/map/follow.h"

#include <algorithm>
#include <cmath>

namespace hedr {
namespace {

constexpr double kInset = 0.18;      // of the free width and height, on each side
constexpr double kLookAhead = 0.15;  // of the smaller one

struct Range {
    double low;
    double high;
};

Range inner(double from, double to) {
    const double inset = kInset * (to - from);
    return {from + inset, std::max(from + inset, to - inset)};
}

// How far both ends must move to lie within the range; the first end counts more.
double shift(double first, double second, const Range& range) {
    const auto into = [&](double x) { return std::clamp(x, range.low, range.high) - x; };
    const double by_second = into(second);
    return by_second + into(first + by_second);
}

}  // namespace

ViewTransform followed(const ViewTransform& view, const Pose<World>& robot,
                       const ViewMargins& margins) {
    const Range across = inner(margins.left_px, view.width_px - margins.right_px);
    const Range down = inner(margins.top_px, view.height_px - margins.bottom_px);
    const double ahead_px = kLookAhead * std::min(view.width_px, view.height_px);
    const double heading_rad = robot.heading_rad + view.rotation_rad;
    const Point<View> at = view.viewFromWorld() * robot.position;
    const Point<View> ahead =
        at + ahead_px * Vector<View>{std::cos(heading_rad), -std::sin(heading_rad)};
    const Vector<View> by{std::round(shift(at.x, ahead.x, across)),
                          std::round(shift(at.y, ahead.y, down))};
    return by == Vector<View>{} ? view : view.panned(by);
}

}  // namespace hedr
