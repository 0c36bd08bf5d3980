#include "ui/site/plan_row.h"

#include <QPainter>

#include "ui/fonts.h"
#include "ui/icons.h"
#include "ui/site/plan_glance.h"

namespace hedr {
namespace {

constexpr int kInset_px = 8;
constexpr int kPictureWidth_px = 64;
constexpr int kIcon_px = 26;

void paintLine(QPainter& painter, const QRect& place, const QString& text,
               Qt::TextElideMode elide) {
    painter.drawText(place, Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(text, elide, place.width()));
}

}  // namespace

PlanRow::PlanRow(const QString& icon, const QString& name, const QString& detail, QWidget* parent)
    : RowButton(parent), icon_(icon), detail_(detail) {
    setText(name);
    setAccessibleName(name);
    setAccessibleDescription(detail);
    setToolTip(detail);
    setFixedSize(sizeHint());
}

void PlanRow::setPicture(const QImage& picture) {
    picture_ = picture;
    update();
}

void PlanRow::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintGround(painter);
    const QRect inside = rect().adjusted(kInset_px, kInset_px, -kInset_px, -kInset_px);
    paintPicture(painter, {inside.topLeft(), QSize(kPictureWidth_px, inside.height())});
    QRect words = inside.adjusted(kPictureWidth_px + 12, 0, 0, 0);
    painter.setFont(uiFont(15, QFont::DemiBold));
    painter.setPen(theme().ink);
    if (!detail_.isEmpty()) words.setHeight(words.height() / 2);
    paintLine(painter, words, text(), Qt::ElideMiddle);
    painter.setFont(uiFont(13));
    painter.setPen(theme().dim);
    // The last folders tell more than the first.
    if (!detail_.isEmpty()) {
        paintLine(painter, words.translated(0, words.height()), detail_, Qt::ElideLeft);
    }
}

void PlanRow::paintPicture(QPainter& painter, const QRect& place) const {
    if (picture_.isNull()) {
        painter.drawPixmap(place.center() - QPoint(kIcon_px / 2 - 1, kIcon_px / 2 - 1),
                           iconPixmap(icon_, theme().dim, kIcon_px, devicePixelRatioF()));
        return;
    }
    const double ratio = devicePixelRatioF();
    const QImage small = themedPicture(
        picture_.scaled(place.size() * ratio, Qt::KeepAspectRatio, Qt::SmoothTransformation),
        theme());
    QRect shown({}, small.size() / ratio);
    shown.moveCenter(place.center());
    painter.drawImage(shown, small);
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(theme().hairline);
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(shown.adjusted(0, 0, -1, -1));
}

}  // namespace hedr
