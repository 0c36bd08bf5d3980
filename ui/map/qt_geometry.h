#pragma once

#include <QPointF>
#include <QTransform>

#include "core/geometry/frames.h"

namespace hedr {

inline QPointF toQt(Point<View> p) { return {p.x, p.y}; }
inline Point<View> viewPoint(QPointF p) { return {p.x(), p.y()}; }

template <class From>
QTransform toQt(const Transform<View, From>& t) {
    const auto& l = t.linear();
    return {l(0, 0), l(1, 0), l(0, 1), l(1, 1), t.offset().x(), t.offset().y()};
}

}  // namespace hedr
