#include "ui/map/marks.h"

#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "core/geometry/angle.h"
#include "ui/fonts.h"
#include "ui/map/qt_geometry.h"
#include "ui/map/robot_symbol.h"

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

Spread spreadOf(const PoseVariance& variance, Point<World> at, const ViewTransform& view) {
    const auto xx = static_cast<double>(variance.var_x_m2);
    const auto xy = static_cast<double>(variance.cov_xy_m2);
    const auto yy = static_cast<double>(variance.var_y_m2);
    const double middle = (xx + yy) / 2.0;
    const double apart = std::hypot((xx - yy) / 2.0, xy);
    const auto axis_px = [&](double variance_m2) {
        return 2.0 * std::sqrt(std::max(0.0, variance_m2)) * view.pixels_per_metre;
    };
    return {view.viewFromWorld() * at, axis_px(middle + apart), axis_px(middle - apart),
            0.5 * std::atan2(2.0 * xy, xx - yy) + view.rotation_rad};
}

QRectF spreadBounds(const Spread& spread) {
    const double reach = spread.major_px + 2.0;
    return QRectF(toQt(spread.centre), QSizeF()).adjusted(-reach, -reach, reach, reach);
}

bool fitsInto(const Spread& spread, const QSizeF& view_px) {
    return 2.0 * spread.major_px <= std::min(view_px.width(), view_px.height());
}

void drawSpread(QPainter& painter, const Spread& spread, const QColor& colour) {
    QColor fill = colour;
    fill.setAlphaF(0.16F);  // the plan below stays readable
    painter.save();
    painter.translate(toQt(spread.centre));
    painter.rotate(-degFromRad(spread.angle_rad));
    painter.setPen(QPen(colour, 1.5));
    painter.setBrush(fill);
    painter.drawEllipse(QPointF(), spread.major_px, spread.minor_px);
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
              const std::optional<Needle>& needle, const Theme& theme) {
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
    if (needle) {
        const bool old = isOld(needle->state);
        painter.translate(centre);
        painter.rotate(-degFromRad(needle->heading_rad + rotation_rad));
        painter.setPen(old ? QPen(ageColour(needle->state, theme), 1.5) : QPen(Qt::NoPen));
        painter.setBrush(old ? theme.chrome : theme.accent);
        painter.drawPolygon(QPolygonF({{18.0, 0.0}, {-11.0, 8.0}, {-6.0, 0.0}, {-11.0, -8.0}}));
    }
    painter.restore();
}

QRectF reachLabelRect(const Reach& reach, const QSizeF& size, const LabelRoom& room) {
    constexpr double kRobot_px = 34.0;
    constexpr double kGap_px = 8.0;
    const QRectF& inside = room.inside;
    const QPointF centre = toQt(reach.centre);
    const double least = std::max(reach.radius_px, kRobot_px);
    const double up = std::min(least, inside.height() / 4.0) + kGap_px + size.height() / 2.0;
    const double aside = std::min(least, inside.width() / 4.0) + kGap_px + size.width() / 2.0;
    const auto placed = [&](const QPointF& way) {
        QRectF rect(QPointF(), size);
        rect.moveCenter(centre + way);
        rect.moveLeft(
            std::max(inside.left(), std::min(rect.left(), inside.right() - size.width())));
        rect.moveTop(std::max(inside.top(), std::min(rect.top(), inside.bottom() - size.height())));
        return rect;
    };
    const QRegion taken = room.covered.united(
        QRectF(centre.x() - kRobot_px / 2.0, centre.y() - kRobot_px / 2.0, kRobot_px, kRobot_px)
            .toAlignedRect());
    const QPointF ways[] = {{0, -up}, {0, up}, {aside, 0}, {-aside, 0}};
    for (const double further : {1.0, 1.5, 2.0}) {
        for (const QPointF& way : ways) {
            const QRectF rect = placed(further * way);
            if (!taken.intersects(rect.toAlignedRect())) return rect;
        }
    }
    return placed(ways[0]);
}

void drawReach(QPainter& painter, const Reach& reach, const LabelRoom& room, const QColor& colour,
               const Theme& theme) {
    const QPointF centre = toQt(reach.centre);
    QColor fill = colour;
    fill.setAlphaF(0.12F);
    painter.save();
    painter.setBrush(fill);
    painter.setPen(QPen(colour, 2.0, Qt::DashLine));
    painter.drawEllipse(centre, reach.radius_px, reach.radius_px);
    painter.setFont(uiFont(15, QFont::DemiBold));
    const QFontMetricsF metrics(painter.font());
    const QSizeF size(figuresWidth(painter.font(), reach.text), metrics.height());
    const QRectF label = reachLabelRect(reach, size, room);
    drawRimmedText(painter, label.topLeft() + QPointF(0.0, metrics.ascent()), reach.text, colour,
                   theme.paper);
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
