#pragma once

#include <QCursor>
#include <QPainter>

#include "core/geometry/frames.h"
#include "ui/map/view_transform.h"
#include "ui/theme.h"

namespace hedr {

// Something that is done on the map with the pointer, instead of only looking at it. What a tool
// does not take stays with the map: dragging pans, the wheel zooms.
class MapTool {
  public:
    MapTool() = default;
    MapTool(const MapTool&) = delete;
    MapTool& operator=(const MapTool&) = delete;
    virtual ~MapTool() = default;

    // True: the tool takes the drag that begins here, and gets its release.
    virtual bool press(Point<View> at, const ViewTransform& view) = 0;
    virtual void move(Point<View> at, const ViewTransform& view) = 0;  // pressed or not
    virtual void release(Point<View> at, const ViewTransform& view) = 0;
    virtual void click(Point<View> at, const ViewTransform& view) = 0;  // pressed without a drag
    virtual void paint(QPainter& painter, const ViewTransform& view, const Theme& theme) const = 0;
    virtual QCursor cursor() const { return Qt::CrossCursor; }
};

}  // namespace hedr
