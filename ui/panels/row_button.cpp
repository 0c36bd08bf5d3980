#include "ui/panels/row_button.h"

#include <QKeyEvent>
#include <QPainter>

namespace hedr {

RowButton::RowButton(QWidget* parent) : QAbstractButton(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_Hover);
}

void RowButton::setTheme(const Theme& theme) {
    theme_ = theme;
    update();
}

void RowButton::paintGround(QPainter& painter) const {
    if (!isDown() && !underMouse() && !hasFocus()) return;
    painter.setPen(hasFocus() ? QPen(theme_.accent, 2.0) : QPen(Qt::NoPen));
    painter.setBrush(theme_.chip);
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 8.0, 8.0);
}

void RowButton::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Space) {
        QAbstractButton::keyPressEvent(event);
    } else {
        event->ignore();  // the list's: from row to row, and Enter
    }
}

}  // namespace hedr
