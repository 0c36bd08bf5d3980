#include "ui/site/wall_layer.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/map/qt_geometry.h"

namespace hedr {
namespace {

bool isCutOff(const MapPlan& plan, Point<Plan> p) {
    if (!plan.crop) return false;
    return p.x < plan.crop->min.x || p.y < plan.crop->min.y || p.x > plan.crop->max.x ||
           p.y > plan.crop->max.y;
}

QVector<QRgb> colourTable(const Theme& theme) {
    QVector<QRgb> colours(3);
    colours[static_cast<int>(Cell::kWall)] = wallColour(theme).rgba();
    colours[static_cast<int>(Cell::kFree)] = freeColour(theme).rgba();
    colours[static_cast<int>(Cell::kUnknown)] = QColor(Qt::transparent).rgba();
    return colours;
}

}  // namespace

WallCells wallCells(const FreeSpace& space, const MapPlan& plan) {
    const double size = space.plan_px_per_cell;
    const Transform<Plan, Plan> plan_from_cells(size * Eigen::Matrix2d::Identity(),
                                                Eigen::Vector2d::Zero());
    WallCells walls{QImage(space.width, space.height, QImage::Format_Indexed8),
                    plan.image.worldFromPlan() * plan_from_cells, false};
    auto cell = space.cells.begin();
    for (int row = 0; row < space.height; ++row) {
        std::uint8_t* const line = walls.cells.scanLine(row);
        for (int column = 0; column < space.width; ++column, ++cell) {
            const bool cut_off = isCutOff(plan, {(column + 0.5) * size, (row + 0.5) * size});
            const Cell shown = cut_off ? Cell::kUnknown : *cell;
            line[column] = static_cast<std::uint8_t>(shown);
            walls.any_walls = walls.any_walls || shown == Cell::kWall;
        }
    }
    return walls;
}

// No trail has these two, and they say where a robot can go.
QColor wallColour(const Theme& theme) { return theme.alarm; }

QColor freeColour(const Theme& theme) {
    QColor tint = theme.good;
    tint.setAlphaF(0.16F);
    return tint;
}

QImage wallPicture(std::span<const WallCells> plans, const ViewTransform& view, const Theme& theme,
                   double device_ratio) {
    const QSizeF size(view.width_px, view.height_px);
    QImage picture((device_ratio * size).toSize(), QImage::Format_ARGB32_Premultiplied);
    picture.setDevicePixelRatio(device_ratio);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    for (const WallCells& plan : plans) {
        const QTransform shown = toQt(view.viewFromWorld() * plan.world_from_cells);
        const QRect part =
            shown.inverted().mapRect(QRectF({}, size)).toAlignedRect().adjusted(-1, -1, 1, 1) &
            plan.cells.rect();
        QImage cells = plan.cells.copy(part);
        cells.setColorTable(colourTable(theme));
        painter.setTransform(shown);
        // In the painter's own format, which it scales many times faster.
        painter.drawImage(part.topLeft(), cells.convertToFormat(picture.format()));
    }
    return picture;
}

void drawStrokes(QImage& picture, std::span<const WallStroke> strokes, const ViewTransform& view,
                 const Theme& theme) {
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setCompositionMode(QPainter::CompositionMode_Source);
    for (const WallStroke& stroke : strokes) {
        QPolygonF line;
        for (const Point<World>& point : stroke.points) line << toQt(view.viewFromWorld() * point);
        if (line.size() == 1) line << line.front() + QPointF(0.01, 0.0);  // a dot
        const QColor colour = stroke.pen == WallPen::kWall ? wallColour(theme) : freeColour(theme);
        const double width_px = std::max(1.0, stroke.width_m * view.pixels_per_metre);
        painter.setPen(QPen(colour, width_px, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolyline(line);
    }
}

}  // namespace hedr
