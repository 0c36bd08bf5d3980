#include "ui/site/map_marks.h"

#include "ui/fonts.h"

namespace hedr {

void drawDot(QPainter& painter, QPointF at, double radius_px, const QColor& fill,
             const Theme& theme) {
    painter.setPen(QPen(theme.chrome, 2.0));
    painter.setBrush(fill);
    painter.drawEllipse(at, radius_px, radius_px);
}

void drawNumber(QPainter& painter, QPointF at, std::size_t number, const QColor& colour,
                const Theme& theme) {
    painter.setPen(QPen(theme.chrome, 6.0));
    painter.setBrush(theme.chrome);
    painter.drawEllipse(at, kNumberRadius_px, kNumberRadius_px);
    painter.setPen(QPen(colour, 2.5));
    painter.drawEllipse(at, kNumberRadius_px, kNumberRadius_px);
    painter.setFont(uiFont(13, QFont::DemiBold));
    painter.setPen(colour);
    painter.drawText(QRectF(at.x() - 20, at.y() - 20, 40, 40), Qt::AlignCenter,
                     QString::number(number));
}

void drawLine(QPainter& painter, QPointF from, QPointF to, const QColor& colour,
              const Theme& theme) {
    painter.setPen(QPen(theme.chrome, 6.0, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(from, to);
    painter.setPen(QPen(colour, 2.5, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(from, to);
}

void drawNote(QPainter& painter, const QString& text, const Theme& theme) {
    constexpr int kHeight_px = 32;
    constexpr int kMargin_px = 24;
    painter.setFont(uiFont(14));
    const QRect map = painter.viewport();
    QRectF pill(0, 0, painter.fontMetrics().horizontalAdvance(text) + 32, kHeight_px);
    const double device_ratio = painter.device()->devicePixelRatioF();
    pill.moveCenter({map.width() / device_ratio / 2.0, 0.0});
    pill.moveBottom(map.height() / device_ratio - kMargin_px);
    painter.setPen(QPen(theme.hairline, 1.0));
    painter.setBrush(theme.chrome);
    painter.drawRoundedRect(pill, kHeight_px / 2.0, kHeight_px / 2.0);
    painter.setPen(theme.ink);
    painter.drawText(pill, Qt::AlignCenter, text);
}

}  // namespace hedr
