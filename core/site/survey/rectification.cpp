#include "core/site/survey/rectification.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hedr {
namespace {

constexpr double kMostAspect = 50.0;
constexpr double kMarginDepth = 0.5;  // of the quad's farthest corner; depth grows to the camera
constexpr double kMostGrowth = 3.0;   // of the number of pixels

struct Bounds {
    Point<Flat> min{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
    Point<Flat> max{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest()};

    void include(Point<Flat> p) {
        min = {std::min(min.x, p.x), std::min(min.y, p.y)};
        max = {std::max(max.x, p.x), std::max(max.y, p.y)};
    }
    double width() const { return max.x - min.x; }
    double height() const { return max.y - min.y; }
    double area() const { return width() * height(); }
    void cut(Point<Flat> least, Point<Flat> most) {
        min = {std::max(min.x, least.x), std::max(min.y, least.y)};
        max = {std::min(max.x, most.x), std::min(max.y, most.y)};
    }
};

double longest(const Quad& quad, std::size_t side) {
    const auto& c = quad.corners;
    return std::max((c[side + 1] - c[side]).length(), (c[(side + 3) % 4] - c[side + 2]).length());
}

// The quad's rectangle becomes [0, width] x [0, height].
Perspective<Flat, Plan> flattened(const Quad& quad, double aspect) {
    const double width_px = std::max(longest(quad, 0), longest(quad, 1) * aspect);
    const Eigen::Vector3d scale(width_px, width_px / aspect, 1.0);
    const Perspective<Flat, UnitSquare> flat_from_square(scale.asDiagonal());
    return flat_from_square * photoFromUnitSquare(quad).inverse();
}

// Where the outline of the photo, cut off before the horizon, comes to lie.
Bounds boundsOf(const Perspective<Flat, Plan>& flat_from_photo, double w, double h,
                const Quad& quad) {
    Bounds bounds;
    double least_depth = std::numeric_limits<double>::max();
    for (const Point<Plan>& corner : quad.corners) {
        bounds.include(flat_from_photo * corner);
        least_depth = std::min(least_depth, kMarginDepth * flat_from_photo.depth(corner));
    }
    const std::array<Point<Plan>, 4> outline{{{0.0, 0.0}, {w, 0.0}, {w, h}, {0.0, h}}};
    for (std::size_t i = 0; i < 4; ++i) {
        const Point<Plan> from = outline[i];
        const Point<Plan> to = outline[(i + 1) % 4];
        const double before = flat_from_photo.depth(from) - least_depth;
        const double after = flat_from_photo.depth(to) - least_depth;
        if (before >= 0.0) bounds.include(flat_from_photo * from);
        if (before * after < 0.0) {
            bounds.include(flat_from_photo * (from + before / (before - after) * (to - from)));
        }
    }
    return bounds;
}

// Cuts the broadest margins around [0, width] x [0, height] until the area is small enough.
void cutMargins(Bounds& bounds, double width, double height, double most_area) {
    for (double share = 8.0; bounds.area() > most_area && share > 0.01; share *= 0.8) {
        bounds.cut({-share * width, -share * height},
                   {(1.0 + share) * width, (1.0 + share) * height});
    }
}

}  // namespace

Result<Rectification> rectificationOf(int photo_width_px, int photo_height_px, const Quad& quad,
                                      std::optional<double> aspect,
                                      const std::optional<FocalLength>& focal_length) {
    if (photo_width_px < 1 || photo_height_px < 1) {
        return fail(ErrorCode::kBadValue, "photo", "it has no pixels");
    }
    if (auto checked = checkQuad(quad); !checked) return tl::make_unexpected(checked.error());
    if (aspect && !(*aspect >= 1.0 / kMostAspect && *aspect <= kMostAspect)) {
        return fail(ErrorCode::kBadValue, "aspect",
                    "width / height is " + std::to_string(*aspect) + ", must be within 0.02 to 50");
    }
    const SheetAspect shape =
        aspect ? SheetAspect{*aspect, 0.0}
               : sheetAspect(quad, photo_width_px, photo_height_px, focal_length);
    const Perspective<Flat, Plan> flat_from_photo = flattened(quad, shape.value);
    const double most_px = kMostGrowth * photo_width_px * photo_height_px;
    Bounds bounds = boundsOf(flat_from_photo, photo_width_px, photo_height_px, quad);
    const Point<Flat> lower_right = flat_from_photo * quad.corners[2];
    cutMargins(bounds, lower_right.x, lower_right.y, most_px);
    const double scale = std::min(1.0, std::sqrt(most_px / bounds.area()));
    Eigen::Matrix3d shift;
    shift << scale, 0.0, -scale * bounds.min.x, 0.0, scale, -scale * bounds.min.y, 0.0, 0.0, 1.0;
    const auto pixels = [&](double length) {
        return std::max(1, static_cast<int>(std::lround(scale * length)));
    };
    return Rectification{Perspective<Flat, Flat>(shift) * flat_from_photo, pixels(bounds.width()),
                         pixels(bounds.height()), shape};
}

Result<PlanLevel> rectified(const PlanLevel& photo, const Quad& quad, std::optional<double> aspect,
                            const PlanProgress& progress) {
    return rectificationOf(photo.width_px, photo.height_px, quad, aspect)
        .and_then([&](const Rectification& r) { return rectified(photo, r, progress); });
}

}  // namespace hedr
