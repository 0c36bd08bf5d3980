#include "ui/map/marks.h"

#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "core/geometry/angle.h"
#include "ui/fonts.h"
#include "ui/map/qt_geometry.h"

namespace hedr {
namespace {

void drawChromeRect(QPainter& painter, const QRectF& rect, const Theme& theme) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.chrome);
    painter.drawRoundedRect(rect, 8.0, 8.0);
}

// Text with a rim of the paper's colour, readable on any plan.
void drawRimmedText(QPainter& painter, QPointF baseline, const QString& text, const QColor& ink,
                    const QColor& rim) {
    QPainterPath path;
    path.addText(baseline, painter.font(), text);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(rim, 5.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(path);
    painter.setPen(Qt::NoPen);
    painter.fillPath(path, ink);
}

QString lengthText(double length_m) {
    if (length_m >= 1000.0) return QStringLiteral("%1 km").arg(length_m / 1000.0);
    if (length_m < 1.0) return QStringLiteral("%1 cm").arg(length_m * 100.0);
    return QStringLiteral("%1 m").arg(length_m);
}

}  // namespace

void drawHome(QPainter& painter, Point<View> at, const Theme& theme) {
    painter.save();
    painter.translate(toQt(at));
    painter.setPen(QPen(theme.paper, 6.0));
    painter.setBrush(theme.paper);
    painter.drawEllipse(QPointF(), 10.0, 10.0);
    painter.setPen(QPen(theme.ink, 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawEllipse(QPointF(), 10.0, 10.0);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme.ink, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolygon(
        QPolygonF({{0.0, -5.0}, {4.6, -0.8}, {4.6, 4.4}, {-4.6, 4.4}, {-4.6, -0.8}}));
    painter.restore();
}

ScaleBar scaleBar(double pixels_per_metre, double most_px) {
    const double most_m = most_px / pixels_per_metre;
    const double decade = std::pow(10.0, std::floor(std::log10(most_m)));
    const double step = most_m / decade >= 5.0 ? 5.0 : most_m / decade >= 2.0 ? 2.0 : 1.0;
    return {step * decade, step * decade * pixels_per_metre};
}

void drawScaleBar(QPainter& painter, QPointF right_bottom, const ScaleBar& bar,
                  const Theme& theme) {
    const QSizeF size(bar.length_px + 28.0, 40.0);
    const QRectF card(right_bottom - QPointF(size.width(), size.height()), size);
    painter.save();
    drawChromeRect(painter, card, theme);
    painter.setFont(uiFont(14));
    painter.setPen(theme.ink);
    painter.drawText(card.adjusted(0, 4, 0, -16), Qt::AlignCenter, lengthText(bar.length_m));
    const double left = card.left() + 14.0;
    const double right = card.right() - 14.0;
    const double y = card.bottom() - 11.0;
    painter.setPen(QPen(theme.ink, 2.0, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
    painter.drawPolyline(QPolygonF({{left, y - 6.0}, {left, y}, {right, y}, {right, y - 6.0}}));
    painter.restore();
}

void drawDial(QPainter& painter, QPointF centre, double rotation_rad,
              std::optional<double> heading_rad, const Theme& theme) {
    constexpr double kRadius_px = 28.0;
    const auto at = [&](double angle_rad, double radius_px) {
        const double screen = angle_rad + rotation_rad;
        return centre + radius_px * QPointF(std::cos(screen), -std::sin(screen));
    };
    painter.save();
    painter.setPen(QPen(theme.hairline, 1.0));
    painter.setBrush(theme.chrome);
    painter.drawEllipse(centre, kRadius_px, kRadius_px);
    painter.setPen(QPen(theme.dim, 1.5, Qt::SolidLine, Qt::FlatCap));
    for (int quarter = 0; quarter < 4; ++quarter) {
        const double angle = quarter * kPi / 2.0;
        painter.drawLine(at(angle, kRadius_px - 6.0), at(angle, kRadius_px - 1.0));
    }
    painter.setFont(uiFont(12, QFont::Medium));
    for (const int degrees : {0, 90}) {
        const QPointF middle = at(radFromDeg(degrees), kRadius_px + 14.0);
        drawRimmedText(
            painter,
            middle + QPointF(-figuresWidth(painter.font(), QString::number(degrees)) / 2, 4.5),
            QStringLiteral("%1°").arg(degrees), theme.dim, theme.background);
    }
    if (heading_rad) {
        painter.translate(centre);
        painter.rotate(-degFromRad(*heading_rad + rotation_rad));
        painter.setPen(Qt::NoPen);
        painter.setBrush(theme.accent);
        painter.drawPolygon(QPolygonF({{18.0, 0.0}, {-11.0, 8.0}, {-6.0, 0.0}, {-11.0, -8.0}}));
    }
    painter.restore();
}

void drawReach(QPainter& painter, const Reach& reach, const QRectF& inside, const QColor& colour,
               const Theme& theme) {
    const QPointF centre = toQt(reach.centre);
    QColor fill = colour;
    fill.setAlphaF(0.12F);
    painter.save();
    painter.setBrush(fill);
    painter.setPen(QPen(colour, 2.0, Qt::DashLine));
    painter.drawEllipse(centre, reach.radius_px, reach.radius_px);
    painter.setFont(uiFont(15, QFont::DemiBold));
    const double width = figuresWidth(painter.font(), reach.text);
    // Above the circle, or above the robot where the circle's top is out of sight.
    const double room_px = std::min(std::max(reach.radius_px, 34.0), inside.height() / 4.0);
    const double x = std::clamp(centre.x() - width / 2.0, inside.left(),
                                std::max(inside.left(), inside.right() - width));
    const double y = std::clamp(centre.y() - room_px - 10.0, inside.top() + 20.0, inside.bottom());
    drawRimmedText(painter, {x, y}, reach.text, colour, theme.paper);
    painter.restore();
}

void drawStaleFrame(QPainter& painter, const QRectF& rect, const QColor& colour) {
    constexpr double kWidth_px = 6.0;
    painter.save();
    QPen pen(colour, kWidth_px, Qt::CustomDashLine, Qt::FlatCap, Qt::MiterJoin);
    pen.setDashPattern({3.0, 2.0});
    painter.setPen(pen);
    painter.setBrush(Qt::NoBrush);
    const double half = kWidth_px / 2.0;
    painter.drawRect(rect.adjusted(half, half, -half, -half));
    painter.restore();
}

}  // namespace hedr
