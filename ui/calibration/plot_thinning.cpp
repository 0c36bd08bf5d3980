#include "ui/calibration/plot_thinning.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hedr {
namespace {

bool isGap(const QPointF& point) { return std::isnan(point.x()) || std::isnan(point.y()); }

bool isNear(const QPointF& a, const QPointF& b, double apart_px) {
    return std::abs(a.x() - b.x()) < apart_px && std::abs(a.y() - b.y()) < apart_px;
}

// One column of a ribbon; y grows downwards.
struct Column {
    double x = 0.0;
    double top = std::numeric_limits<double>::infinity();
    double bottom = -std::numeric_limits<double>::infinity();

    void reach(const QPointF& a, const QPointF& b) {
        top = std::min({top, a.y(), b.y()});
        bottom = std::max({bottom, a.y(), b.y()});
    }
};

QPolygonF outlineOf(const std::vector<Column>& columns, double wider_px) {
    QPolygonF there;
    QPolygonF back;
    for (const Column& column : columns) {
        there << QPointF(column.x, column.top - wider_px);
        back << QPointF(column.x, column.bottom + wider_px);
    }
    std::reverse(back.begin(), back.end());
    return there + back;
}

}  // namespace

bool goesRight(const std::vector<QPointF>& points) {
    double furthest = -std::numeric_limits<double>::infinity();
    for (const QPointF& point : points) {
        if (isGap(point)) continue;
        if (point.x() < furthest) return false;
        furthest = point.x();
    }
    return true;
}

std::vector<QPolygonF> linePieces(const std::vector<QPointF>& points, double apart_px) {
    constexpr qsizetype kLongest = 128;  // the painter's time grows faster than the piece
    std::vector<QPolygonF> pieces;
    QPolygonF piece;
    const auto finish = [&] {
        if (piece.size() > 1) pieces.push_back(piece);
        piece.clear();
    };
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (isGap(points[i])) {
            finish();
            continue;
        }
        const bool last = i + 1 == points.size() || isGap(points[i + 1]);
        if (!piece.empty() && !last && isNear(points[i], piece.back(), apart_px)) continue;
        piece << points[i];
        if (piece.size() < kLongest || last) continue;
        finish();
        piece << points[i];
    }
    finish();
    return pieces;
}

std::vector<QPolygonF> ribbonPieces(const std::vector<QPointF>& lower,
                                    const std::vector<QPointF>& upper, double wider_px) {
    std::vector<QPolygonF> pieces;
    std::vector<Column> columns;
    const auto finish = [&] {
        if (columns.size() > 1) pieces.push_back(outlineOf(columns, wider_px));
        columns.clear();
    };
    const std::size_t count = std::min(lower.size(), upper.size());
    for (std::size_t i = 0; i < count; ++i) {
        if (isGap(lower[i]) || isGap(upper[i])) {
            finish();
            continue;
        }
        const bool same = !columns.empty() && lower[i].x() - columns.back().x < 1.0;
        if (!same) columns.push_back({lower[i].x()});
        columns.back().reach(lower[i], upper[i]);
    }
    finish();
    return pieces;
}

}  // namespace hedr
