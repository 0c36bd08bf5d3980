#include "ui/site/floor_row.h"

#include <QPainter>
#include <QPainterPath>

#include "ui/fonts.h"

namespace hedr {
namespace {

constexpr double kEdge_px = 6.0;
constexpr double kTextLeft_px = 2.0 * kEdge_px + FloorRow::kPicture.width() + 4.0;

}  // namespace

FloorRow::FloorRow(QWidget* parent) : QAbstractButton(parent) {
    setCheckable(true);
    setFocusPolicy(Qt::TabFocus);  // a click leaves the keys with the map
    setAttribute(Qt::WA_Hover);
    setFixedHeight(kHeight_px);
}

void FloorRow::setTheme(const Theme& theme) {
    theme_ = theme;
    update();
}

void FloorRow::setFloor(const QString& name, const QString& note, bool shown) {
    setText(name);
    note_ = note;
    setChecked(shown);
    setAccessibleName(name);
    setAccessibleDescription(note);
    setToolTip(shown ? tr("This floor is on the map") : tr("Look at %1").arg(name));
    update();
}

void FloorRow::setPicture(const QImage& picture) {
    picture_ = picture;
    update();
}

void FloorRow::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    if (isChecked() || underMouse() || hasFocus()) {
        painter.setPen(hasFocus() ? QPen(theme_.accent, 2.0) : QPen(Qt::NoPen));
        painter.setBrush(theme_.chip);
        painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 8.0, 8.0);
    }
    const QRectF picture({kEdge_px, kEdge_px}, QSizeF(kPicture));
    QPainterPath corners;
    corners.addRoundedRect(picture, 4.0, 4.0);
    painter.fillPath(corners, theme_.background);
    painter.save();
    painter.setClipPath(corners);
    if (!picture_.isNull()) painter.drawImage(picture, picture_);
    painter.restore();
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(isChecked() ? theme_.accent : theme_.hairline, isChecked() ? 2.0 : 1.0));
    painter.drawPath(corners);
    const double width_px = width() - kTextLeft_px - kEdge_px;
    painter.setPen(theme_.ink);
    painter.setFont(uiFont(15, isChecked() ? QFont::DemiBold : QFont::Medium));
    const QString name = painter.fontMetrics().elidedText(text(), Qt::ElideRight, int(width_px));
    painter.drawText(QRectF(kTextLeft_px, 10, width_px, 20), Qt::AlignVCenter, name);
    painter.setPen(theme_.dim);
    painter.setFont(uiFont(13));
    painter.drawText(QRectF(kTextLeft_px, 30, width_px, 20), Qt::AlignVCenter, note_);
}

}  // namespace hedr
