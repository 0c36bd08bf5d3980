#include "ui/map/call_sign.h"

#include <cmath>

#include "ui/fonts.h"
#include "ui/map/qt_geometry.h"

namespace hedr {
namespace {

constexpr double kSide_px = 5.0;
constexpr double kHeight_px = 20.0;
constexpr double kGap_px = 3.0;  // that the symbol's bounds leave free of it

QFont font() { return uiFont(14, QFont::DemiBold); }

}  // namespace

void CallSign::setText(const QString& text) {
    if (text == text_.text()) return;
    text_.setTextFormat(Qt::PlainText);
    text_.setText(text);
    text_.prepare({}, font());
    plate_px_ = {std::ceil(text_.size().width() + 2.0 * kSide_px), kHeight_px};
}

QRectF CallSign::bounds(const RobotSymbol& robot) const {
    if (empty()) return {};
    return {{std::round(robot.position.x - plate_px_.width() / 2.0),
             std::round(robotBounds(robot).bottom() - kGap_px)},
            plate_px_};
}

void CallSign::draw(QPainter& painter, const RobotSymbol& robot, const Theme& theme) const {
    if (empty()) return;
    const QRectF place = bounds(robot);
    QColor plate = theme.paper;
    plate.setAlphaF(0.85F);
    painter.fillRect(place, plate);
    painter.setFont(font());
    painter.setPen(isOld(robot.state) ? ageColour(robot.state, theme) : theme.accent);
    const QPointF inset(kSide_px, (kHeight_px - text_.size().height()) / 2.0);
    painter.drawStaticText(place.topLeft() + inset, text_);
}

}  // namespace hedr
