#include "ui/site/flat_preview.h"

#include <QPainter>
#include <QPainterPath>
#include <QtMath>
#include <algorithm>

#include "ui/map/plan_layer.h"
#include "ui/map/qt_geometry.h"

namespace hedr {

FlatPreview::FlatPreview(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("The photo made flat"));
    setMinimumHeight(64);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
}

void FlatPreview::setTheme(const Theme& theme) {
    theme_ = theme;
    update();
}

void FlatPreview::show(const std::vector<PlanLevel>& photo, const Rectification& rectification,
                       const Quad& quad) {
    const QRectF part = partAround(rectification, quad);
    Eigen::Matrix3d shift = Eigen::Matrix3d::Identity();
    shift.topRightCorner<2, 1>() << -part.x(), -part.y();
    const Rectification shown{Perspective<Flat, Flat>(shift) * rectification.flat_from_photo,
                              qCeil(part.width()), qCeil(part.height()), rectification.aspect};
    const double most_px = devicePixelRatioF() * std::max(width(), height());
    picture_ = rectifiedPreview(photo, shown, qCeil(most_px));
    rectangle_.clear();
    for (const Point<Plan>& corner : quad.corners) {
        const Point<Flat> p = shown.flat_from_photo * corner;
        rectangle_ << QPointF(p.x * width() / part.width(), p.y * height() / part.height());
    }
    update();
}

void FlatPreview::clear() {
    picture_ = {};
    update();
}

QSize FlatPreview::sizeHint() const { return {292, 248}; }

// The rectangle and something around it, in the shape of this widget.
QRectF FlatPreview::partAround(const Rectification& rectification, const Quad& quad) const {
    constexpr double kMargin = 1.12;
    QPolygonF rectangle;
    for (const Point<Plan>& corner : quad.corners) {
        const Point<Flat> p = rectification.flat_from_photo * corner;
        rectangle << QPointF(p.x, p.y);
    }
    const QRectF inner = rectangle.boundingRect();
    const double flat_px = kMargin * std::max(inner.width() / width(), inner.height() / height());
    QRectF part({}, flat_px * QSizeF(size()));
    part.moveCenter(inner.center());
    return part;
}

void FlatPreview::resizeEvent(QResizeEvent*) { emit resized(); }

void FlatPreview::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QPainterPath frame;
    frame.addRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 8.0, 8.0);
    painter.fillPath(frame, theme_.background);
    if (picture_.pixels) {
        const PlanImage plan{{}, {picture_}, {.resolution_m = 1.0}};
        const ViewTransform view{{picture_.width_px / 2.0, picture_.height_px / 2.0},
                                 1.0 * width() / picture_.width_px,
                                 0.0,
                                 1.0 * width(),
                                 1.0 * height()};
        painter.setClipPath(frame);
        drawPlan(painter, plan, inverted_at_night_ ? theme_ : dayTheme(), view);
        painter.setPen(QPen(theme_.accent, 1.5));
        painter.drawPolygon(rectangle_);
        painter.setClipping(false);
    }
    painter.strokePath(frame, QPen(theme_.hairline, 1.0));
}

}  // namespace hedr
