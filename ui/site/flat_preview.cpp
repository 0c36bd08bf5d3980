#include "ui/site/flat_preview.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <utility>

#include "ui/map/plan_layer.h"
#include "ui/map/qt_geometry.h"

namespace hedr {

FlatPreview::FlatPreview(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("The photo made flat"));
    setMinimumHeight(96);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
}

void FlatPreview::setTheme(const Theme& theme) {
    theme_ = theme;
    update();
}

void FlatPreview::show(PlanLevel picture, QPolygonF rectangle, bool inverted_at_night) {
    picture_ = std::move(picture);
    rectangle_ = std::move(rectangle);
    inverted_at_night_ = inverted_at_night;
    update();
}

void FlatPreview::clear() {
    picture_ = {};
    update();
}

QSize FlatPreview::sizeHint() const { return {292, 248}; }

// Metres are pixels of the picture here.
ViewTransform FlatPreview::aroundRectangle() const {
    constexpr double kMargin = 1.12;
    const QRectF part = rectangle_.boundingRect();
    ViewTransform view{{part.center().x(), picture_.height_px - part.center().y()}};
    view.width_px = width();
    view.height_px = height();
    view.pixels_per_metre = std::min(width() / part.width(), height() / part.height()) / kMargin;
    return view;
}

void FlatPreview::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QPainterPath frame;
    frame.addRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 8.0, 8.0);
    painter.fillPath(frame, theme_.background);
    if (picture_.pixels) {
        const PlanImage plan{{}, {picture_}, {.resolution_m = 1.0}};
        const ViewTransform view = aroundRectangle();
        painter.setClipPath(frame);
        drawPlan(painter, plan, inverted_at_night_ ? theme_ : dayTheme(), view);
        painter.setPen(QPen(theme_.accent, 1.5));
        painter.drawPolygon(toQt(view.viewFromWorld() * plan.worldFromPlan()).map(rectangle_));
        painter.setClipping(false);
    }
    painter.strokePath(frame, QPen(theme_.hairline, 1.0));
}

}  // namespace hedr
