#pragma once

#include <QPainter>

#include "core/track/track.h"
#include "ui/map/view_transform.h"

namespace hedr {

// How far a trail has been drawn, so that what is new can go on from there.
struct TrailEnd {
    std::size_t points = 0;
    double length_px = 0.0;  // of the drawn line, for the phase of its dashes
};

// Draws all of a track within half a device pixel of its exact line.
TrailEnd drawTrail(QPainter& painter, const Track& track, const QPen& pen,
                   const ViewTransform& view);

// Draws what has come since `end`, which was measured at `end_pixels_per_metre`; gives the new end
// at the scale of the view.
TrailEnd drawTrailTail(QPainter& painter, const Track& track, const QPen& pen,
                       const ViewTransform& view, const TrailEnd& end, double end_pixels_per_metre);

// What a tail covers on the screen, with room for the pen.
QRectF trailTailBounds(const Track& track, std::size_t from, const ViewTransform& view);

}  // namespace hedr
