#pragma once

#include "core/geometry/frames.h"
#include "core/track/track.h"

namespace hedr {

struct ViewMargins {
    double left_px = 0.0;
    double top_px = 0.0;
    double right_px = 0.0;
    double bottom_px = 0.0;
    friend bool operator==(const ViewMargins&, const ViewMargins&) = default;
};

// Which part of the world a widget shows: a value that can be tested without the widget.
struct ViewTransform {
    Point<World> centre{};
    double pixels_per_metre = 40.0;
    double rotation_rad = 0.0;  // of the world on the screen, counter-clockwise
    double width_px = 0.0;
    double height_px = 0.0;

    Transform<View, World> viewFromWorld() const;
    Transform<World, View> worldFromView() const { return viewFromWorld().inverse(); }
    WorldBox visibleArea() const;  // the upright box around what is seen

    ViewTransform panned(Vector<View> by) const;  // the content moves by `by`
    ViewTransform zoomed(Point<View> about, double factor) const;
    ViewTransform resized(double width_px, double height_px) const;
    ViewTransform grown(double by_px) const;  // on all four sides
    // The whole box in the middle of what the margins leave free.
    ViewTransform fitted(const WorldBox& box, const ViewMargins& margins) const;

    friend bool operator==(const ViewTransform&, const ViewTransform&) = default;
};

inline constexpr double kLeastPixelsPerMetre = 0.02;
inline constexpr double kMostPixelsPerMetre = 2000.0;

WorldBox united(const WorldBox& a, const WorldBox& b);
WorldBox boxAround(std::initializer_list<Point<World>> points);

}  // namespace hedr
