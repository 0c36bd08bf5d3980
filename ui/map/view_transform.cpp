#include "ui/map/view_transform.h"

#include <algorithm>
#include <cmath>

namespace hedr {

Transform<View, World> ViewTransform::viewFromWorld() const {
    const double c = pixels_per_metre * std::cos(rotation_rad);
    const double s = pixels_per_metre * std::sin(rotation_rad);
    Eigen::Matrix2d linear;
    linear << c, -s, -s, -c;  // turned, then upside down: a screen's y points downwards
    const Eigen::Vector2d middle(width_px / 2.0, height_px / 2.0);
    return {linear, middle - linear * Eigen::Vector2d(centre.x, centre.y)};
}

WorldBox ViewTransform::visibleArea() const {
    const auto world_from_view = worldFromView();
    return boxAround({world_from_view * Point<View>{0.0, 0.0},
                      world_from_view * Point<View>{width_px, 0.0},
                      world_from_view * Point<View>{0.0, height_px},
                      world_from_view * Point<View>{width_px, height_px}});
}

ViewTransform ViewTransform::panned(Vector<View> by) const {
    ViewTransform next = *this;
    next.centre = centre + worldFromView() * (-1.0 * by);
    return next;
}

ViewTransform ViewTransform::zoomed(Point<View> about, double factor) const {
    const Point<World> fixed = worldFromView() * about;
    ViewTransform next = *this;
    next.pixels_per_metre =
        std::clamp(pixels_per_metre * factor, kLeastPixelsPerMetre, kMostPixelsPerMetre);
    const double rest = pixels_per_metre / next.pixels_per_metre;
    next.centre = fixed + rest * (centre - fixed);
    return next;
}

ViewTransform ViewTransform::resized(double new_width_px, double new_height_px) const {
    ViewTransform next = *this;
    next.width_px = new_width_px;
    next.height_px = new_height_px;
    return next;
}

ViewTransform ViewTransform::grown(double by_px) const {
    return resized(width_px + 2.0 * by_px, height_px + 2.0 * by_px);
}

ViewTransform ViewTransform::fitted(const WorldBox& box, const ViewMargins& margins) const {
    ViewTransform next = *this;
    next.centre = {(box.min.x + box.max.x) / 2.0, (box.min.y + box.max.y) / 2.0};
    const double width_m = box.max.x - box.min.x;
    const double height_m = box.max.y - box.min.y;
    const double c = std::abs(std::cos(rotation_rad));
    const double s = std::abs(std::sin(rotation_rad));
    constexpr double kLeast_m = 12.0;  // a single point is shown with its surroundings
    const double seen_width_m = std::max(kLeast_m, c * width_m + s * height_m);
    const double seen_height_m = std::max(kLeast_m, s * width_m + c * height_m);
    const double free_width_px = std::max(1.0, width_px - margins.left_px - margins.right_px);
    const double free_height_px = std::max(1.0, height_px - margins.top_px - margins.bottom_px);
    next.pixels_per_metre =
        std::clamp(std::min(free_width_px / seen_width_m, free_height_px / seen_height_m),
                   kLeastPixelsPerMetre, kMostPixelsPerMetre);
    return next.panned(
        {(margins.left_px - margins.right_px) / 2.0, (margins.top_px - margins.bottom_px) / 2.0});
}

WorldBox united(const WorldBox& a, const WorldBox& b) {
    return boxAround({a.min, a.max, b.min, b.max});
}

WorldBox boxAround(std::initializer_list<Point<World>> points) {
    WorldBox box{*points.begin(), *points.begin()};
    for (const Point<World>& p : points) {
        box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y)};
        box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y)};
    }
    return box;
}

}  // namespace hedr
