#include "ui/icons.h"

#include <QPainter>
#include <QSvgRenderer>

namespace hedr {

QPixmap iconPixmap(const QString& name, const QColor& colour, int size_px, double device_ratio) {
    const int pixels = qRound(size_px * device_ratio);
    QPixmap pixmap(pixels, pixels);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    QSvgRenderer(QStringLiteral(":/icons/%1.svg").arg(name)).render(&painter);
    painter.setCompositionMode(QPainter::CompositionMode_SourceIn);
    painter.fillRect(pixmap.rect(), colour);
    painter.end();
    pixmap.setDevicePixelRatio(device_ratio);
    return pixmap;
}

}  // namespace hedr
