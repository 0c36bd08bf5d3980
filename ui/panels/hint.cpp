#include "ui/panels/hint.h"

#include <QPainter>

#include "ui/fonts.h"
#include "ui/icons.h"

namespace hedr {

Hint::Hint(QWidget* parent) : QAbstractButton(parent) {
    setText(tr("Drop a floor plan here, or press P"));
    setAccessibleName(text());
    setToolTip(tr("Open a floor plan (P)"));
    setFocusPolicy(Qt::TabFocus);
    setAttribute(Qt::WA_Hover);
    setCursor(Qt::PointingHandCursor);
    resize(sizeHint());
}

void Hint::setTheme(const Theme& theme) {
    theme_ = theme;
    update();
}

void Hint::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const bool near = underMouse() || hasFocus();
    QPen pen(near ? theme_.accent : theme_.dim, 2.0, Qt::CustomDashLine, Qt::FlatCap);
    pen.setDashPattern({5.0, 4.0});
    painter.setPen(pen);
    painter.setBrush(theme_.paper);
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 12.0, 12.0);
    constexpr int kIcon_px = 48;
    painter.drawPixmap((width() - kIcon_px) / 2, 44,
                       iconPixmap(QStringLiteral("plan"), near ? theme_.accent : theme_.dim,
                                  kIcon_px, devicePixelRatioF()));
    painter.setFont(uiFont(18, QFont::DemiBold));
    painter.setPen(theme_.ink);
    painter.drawText(QRectF(0, 108, width(), 28), Qt::AlignCenter, text());
    painter.setFont(uiFont(14));
    painter.setPen(theme_.dim);
    painter.drawText(QRectF(0, 140, width(), 24), Qt::AlignCenter,
                     tr("An image, a PDF, a drawing or a map. It works without one, too."));
}

}  // namespace hedr
