#pragma once

#include <QPointF>
#include <QPolygonF>
#include <vector>

namespace hedr {

// Points on the screen, NaN where there is a gap, made fewer than can be told apart: many points
// cost as little as there are pixels.

// Whether no point is left of the one before; gaps do not count.
bool goesRight(const std::vector<QPointF>& points);

// The line as pieces to be drawn one after the other, without points nearer to one another.
std::vector<QPolygonF> linePieces(const std::vector<QPointF>& points, double apart_px);

// What lies between two lines that go right, `wider_px` beyond each, column by column: of a band,
// or (between a line and itself) of a line with many points in a column.
std::vector<QPolygonF> ribbonPieces(const std::vector<QPointF>& lower,
                                    const std::vector<QPointF>& upper, double wider_px);

}  // namespace hedr
