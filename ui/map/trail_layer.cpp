#include "ui/map/trail_layer.h"

#include <QPolygonF>
#include <algorithm>
#include <cmath>
#include <vector>

#include "ui/map/qt_geometry.h"

namespace hedr {
namespace {

constexpr double kTolerance_px = 0.5;
constexpr int kChunk = 256;       // QPainter's time grows faster than a polyline's length
constexpr double kMargin_px = 8;  // half a pen and the joins

QRectF viewRect(const ViewTransform& view) {
    return QRectF(0, 0, view.width_px, view.height_px)
        .adjusted(-kMargin_px, -kMargin_px, kMargin_px, kMargin_px);
}

double lengthOf(const std::vector<QPointF>& line) {
    double length = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        length += QLineF(line[i - 1], line[i]).length();
    }
    return length;
}

// Draws a run and gives the length after it. Dashes go on from chunk to chunk.
double drawRun(QPainter& painter, QPen pen, const std::vector<QPointF>& line, double length) {
    const bool dashed = pen.style() != Qt::SolidLine;
    const int count = static_cast<int>(line.size());
    for (int from = 0; from + 1 < count; from += kChunk) {
        const int points = std::min(kChunk + 1, count - from);
        if (dashed) {
            pen.setDashOffset(length / pen.widthF());
            for (int i = from + 1; i < from + points; ++i) {
                const auto at = static_cast<std::size_t>(i);
                length += QLineF(line[at - 1], line[at]).length();
            }
        }
        painter.setPen(pen);
        painter.drawPolyline(line.data() + from, points);
    }
    return length;
}

QRectF boundsOf(const std::vector<QPointF>& line) {
    return QPolygonF(QList<QPointF>(line.begin(), line.end())).boundingRect();
}

double cross(QPointF a, QPointF b) { return a.x() * b.y() - a.y() * b.x(); }

// Leaves out every point that a straight line passes within the tolerance, in one pass (Sklansky
// and Gonzalez 1980, cone intersection): joins are what costs time.
class Straightener {
  public:
    explicit Straightener(std::vector<QPointF>& line) : line_(line) {}

    void add(QPointF point) {
        if (line_.empty()) return line_.push_back(point);
        if (!fits(point)) {
            line_.push_back(last_);
            reach_ = 0.0;
            (void)fits(point);
        }
        last_ = point;
        waits_ = true;
    }
    void end() {
        if (waits_) line_.push_back(last_);
    }

  private:
    // Narrows the cone of directions by which all points since the last corner are passed.
    bool fits(QPointF point) {
        const QPointF way = point - line_.back();
        const double distance = std::hypot(way.x(), way.y());
        if (distance <= kTolerance_px) return reach_ <= kTolerance_px;
        const QPointF aside = kTolerance_px / distance * QPointF(-way.y(), way.x());
        if (reach_ <= kTolerance_px) {
            right_ = way - aside;
            left_ = way + aside;
        } else {
            // Whoever turns back has a corner there.
            if (distance < reach_ - kTolerance_px || cross(right_, way) < 0.0 ||
                cross(way, left_) < 0.0)
                return false;
            if (cross(right_, way - aside) > 0.0) right_ = way - aside;
            if (cross(way + aside, left_) > 0.0) left_ = way + aside;
        }
        reach_ = std::max(reach_, distance);
        return true;
    }

    std::vector<QPointF>& line_;
    QPointF last_{};
    QPointF right_{};
    QPointF left_{};
    double reach_ = 0.0;  // of the points since the last corner
    bool waits_ = false;
};

}  // namespace

TrailEnd drawTrail(QPainter& painter, const Track& track, const QPen& pen,
                   const ViewTransform& view) {
    if (track.empty()) return {};
    const bool dashed = pen.style() != Qt::SolidLine;
    // Dashes are counted from the very start, so that they stay where they are when the map moves.
    const WorldBox area = dashed ? track.bounds() : view.grown(kMargin_px).visibleArea();
    const double device_scale = view.pixels_per_metre * painter.device()->devicePixelRatioF();
    const auto view_from_world = view.viewFromWorld();
    const QRectF seen = viewRect(view);
    std::vector<QPointF> line;
    double length = 0.0;
    track.simplified(area, kTolerance_px / device_scale, [&](std::span<const Point<World>> run) {
        line.clear();
        for (const Point<World>& p : run) line.push_back(toQt(view_from_world * p));
        if (dashed && !boundsOf(line).adjusted(-1, -1, 1, 1).intersects(seen)) {
            length += lengthOf(line);
        } else {
            length = drawRun(painter, pen, line, length);
        }
    });
    return {track.size(), length};
}

TrailEnd drawTrailTail(QPainter& painter, const Track& track, const QPen& pen,
                       const ViewTransform& view, const TrailEnd& end,
                       double end_pixels_per_metre) {
    const double length_px = end.length_px * view.pixels_per_metre / end_pixels_per_metre;
    if (end.points >= track.size()) return {end.points, length_px};
    const auto view_from_world = view.viewFromWorld();
    std::vector<QPointF> line;
    Straightener straightener(line);
    for (std::size_t i = end.points > 0 ? end.points - 1 : 0; i < track.size(); ++i) {
        straightener.add(toQt(view_from_world * track.at(i).pose.position));
    }
    straightener.end();
    return {track.size(), drawRun(painter, pen, line, length_px)};
}

QRectF trailTailBounds(const Track& track, std::size_t from, const ViewTransform& view) {
    if (track.empty()) return {};
    const std::size_t first = std::min(from > 0 ? from - 1 : 0, track.size() - 1);
    const auto view_from_world = view.viewFromWorld();
    WorldBox box = boxAround({track.back().pose.position});
    for (std::size_t i = first; i < track.size(); ++i) {
        box = united(box, boxAround({track.at(i).pose.position}));
    }
    const QRectF rect = QRectF(toQt(view_from_world * box.min), toQt(view_from_world * box.max));
    const QRectF other = QRectF(toQt(view_from_world * Point<World>{box.min.x, box.max.y}),
                                toQt(view_from_world * Point<World>{box.max.x, box.min.y}));
    return rect.normalized()
        .united(other.normalized())
        .adjusted(-kMargin_px, -kMargin_px, kMargin_px, kMargin_px);
}

}  // namespace hedr
