#pragma once

#include <QPainter>

#include "ui/panels/status_tiles.h"

namespace hedr {

// A sign, 16 px wide, that tells a tone without its colour: a check mark, a triangle, a cross; a
// ring where there is nothing to tell.
inline void drawToneMark(QPainter& painter, const QPointF& centre, Tone tone,
                         const QColor& colour) {
    painter.setPen(QPen(colour, 2.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    const auto at = [&](double x, double y) { return centre + QPointF(x, y); };
    switch (tone) {
        case Tone::kGood:
            painter.drawPolyline(QPolygonF({at(-6.5, 0.5), at(-2.0, 5.0), at(6.5, -5.0)}));
            break;
        case Tone::kWarning:
            painter.drawPolygon(QPolygonF({at(0.0, -6.0), at(7.0, 6.0), at(-7.0, 6.0)}));
            break;
        case Tone::kAlarm:
            painter.drawLine(at(-5.5, -5.5), at(5.5, 5.5));
            painter.drawLine(at(5.5, -5.5), at(-5.5, 5.5));
            break;
        case Tone::kPlain:
        case Tone::kDim:
            painter.drawEllipse(centre, 6.0, 6.0);
            break;
    }
}

}  // namespace hedr
