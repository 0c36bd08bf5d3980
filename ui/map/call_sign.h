#pragma once

#include <QPainter>
#include <QStaticText>

#include "ui/map/robot_symbol.h"

namespace hedr {

// A robot's name below its symbol, on a plate of its own. It is laid out once for as long as it
// stays the same: several robots have one each, in every frame.
class CallSign {
  public:
    void setText(const QString& text);
    bool empty() const { return text_.text().isEmpty(); }
    QRectF bounds(const RobotSymbol& robot) const;
    void draw(QPainter& painter, const RobotSymbol& robot, const Theme& theme) const;

  private:
    QStaticText text_;
    QSizeF plate_px_{};
};

}  // namespace hedr
