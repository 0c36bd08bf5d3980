#include "ui/panels/card.h"

#include <QMouseEvent>
#include <QPainter>

namespace hedr {

Card::Card(QWidget* parent) : QWidget(parent) {}

void Card::setTheme(const Theme& theme) {
    theme_ = theme;
    update();
}

void Card::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(theme_.hairline, 1.0));
    painter.setBrush(theme_.chrome);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 12.0, 12.0);
}

void Card::mousePressEvent(QMouseEvent* event) { event->accept(); }

}  // namespace hedr
