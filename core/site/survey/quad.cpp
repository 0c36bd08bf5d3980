#include "core/site/survey/quad.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/site/survey/perspective.h"

namespace hedr {
namespace {

constexpr double kLeastSide_px = 8.0;
constexpr double kLeastSine = 0.02;  // of the angle at a corner, about 1 degree
constexpr double kMostDepthRatio = 20.0;

constexpr std::array kNames{"upper left", "upper right", "lower right", "lower left"};

std::string name(std::size_t corner) { return std::string(kNames[corner % 4]); }

tl::unexpected<Error> refused(const std::string& why) {
    return fail(ErrorCode::kBadValue, "corners", why);
}

double cross(Vector<Plan> a, Vector<Plan> b) { return a.x * b.y - a.y * b.x; }

// Of the turn at each corner: positive where the way goes clockwise on the screen (y is down).
std::array<double, 4> turnSines(const Quad& quad) {
    std::array<double, 4> sines{};
    for (std::size_t i = 0; i < 4; ++i) {
        const Vector<Plan> in = quad.corners[i] - quad.corners[(i + 3) % 4];
        const Vector<Plan> out = quad.corners[(i + 1) % 4] - quad.corners[i];
        sines[i] = cross(in, out) / (in.length() * out.length());
    }
    return sines;
}

Result<void> checkSides(const Quad& quad) {
    for (const Point<Plan>& corner : quad.corners) {
        if (!std::isfinite(corner.x) || !std::isfinite(corner.y)) {
            return refused("a coordinate is not a number");
        }
    }
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t k = i + 1; k < 4; ++k) {
            const double side_px = (quad.corners[k] - quad.corners[i]).length();
            if (side_px >= kLeastSide_px) continue;
            return refused("the " + name(i) + " and the " + name(k) +
                           " corner are less than 8 px apart");
        }
    }
    return {};
}

Result<void> checkTurns(const Quad& quad) {
    const std::array<double, 4> sines = turnSines(quad);
    for (std::size_t i = 0; i < 4; ++i) {
        if (std::abs(sines[i]) >= kLeastSine) continue;
        return refused("the " + name(i + 3) + ", " + name(i) + " and " + name(i + 1) +
                       " corner lie on a line");
    }
    const auto clockwise = std::ranges::count_if(sines, [](double sine) { return sine > 0.0; });
    if (clockwise == 4) return {};
    if (clockwise == 0) return refused("they run anticlockwise, the plan would be mirrored");
    if (clockwise == 2) return refused("the sides cross, they must run around the plan in order");
    const auto odd =
        std::ranges::find_if(sines, [&](double sine) { return (sine > 0.0) == (clockwise == 1); });
    return refused("the " + name(static_cast<std::size_t>(odd - sines.begin())) +
                   " corner lies inside of the triangle of the others");
}

}  // namespace

Quad orderedQuad(const std::array<Point<Plan>, 4>& corners) {
    Point<Plan> middle{};
    for (const Point<Plan>& corner : corners) middle = middle + 0.25 * (corner - Point<Plan>{});
    Quad quad{corners};
    const auto bearing = [&](Point<Plan> p) { return std::atan2(p.y - middle.y, p.x - middle.x); };
    std::ranges::sort(quad.corners, {}, bearing);  // clockwise on the screen

    const auto tilt = [](const Quad& q) {
        const auto& c = q.corners;
        const Vector<Plan> right = (c[1] - c[0]) + (c[2] - c[3]);
        return std::abs(std::atan2(right.y, right.x));
    };
    Quad best = quad;
    for (int turn = 0; turn < 3; ++turn) {
        std::rotate(quad.corners.begin(), quad.corners.begin() + 1, quad.corners.end());
        if (tilt(quad) < tilt(best)) best = quad;
    }
    return best;
}

Result<void> checkQuad(const Quad& quad) {
    if (auto checked = checkSides(quad); !checked) return checked;
    if (auto checked = checkTurns(quad); !checked) return checked;
    const auto photo_from_square = photoFromUnitSquare(quad);
    const std::array depths{
        photo_from_square.depth({0.0, 0.0}), photo_from_square.depth({1.0, 0.0}),
        photo_from_square.depth({1.0, 1.0}), photo_from_square.depth({0.0, 1.0})};
    const auto [nearest, farthest] = std::ranges::minmax(depths);
    if (farthest > kMostDepthRatio * nearest) {
        return refused("the far side is almost at the horizon, too little of the plan is seen");
    }
    return {};
}

}  // namespace hedr
