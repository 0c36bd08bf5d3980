#include "ui/calibration/procedure_row.h"

#include <QKeyEvent>
#include <QPainter>

#include "ui/calibration/tone_mark.h"
#include "ui/calibration/verdict_text.h"
#include "ui/fonts.h"

namespace hedr {
namespace {

constexpr int kInset_px = 8;
constexpr int kLast_px = 200;  // room for how it went
constexpr int kMark_px = 28;

void drawFitting(QPainter& painter, const QRect& place, const QString& text) {
    painter.drawText(place, Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(text, Qt::ElideRight, place.width()));
}

}  // namespace

ProcedureRow::ProcedureRow(QWidget* parent) : QAbstractButton(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_Hover);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void ProcedureRow::setTheme(const Theme& theme) {
    theme_ = theme;
    update();
}

void ProcedureRow::show(const ProcedureEntry& entry) {
    entry_ = entry;
    if (entry_.last.isEmpty()) entry_.last = tr("never");
    setText(entry.title);
    setAccessibleName(entry.title);
    setAccessibleDescription(tr("%1 Last: %2").arg(entry.purpose, entry_.last));
    setToolTip(entry.purpose);
    setVisible(true);
    update();
}

void ProcedureRow::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (isDown() || underMouse() || hasFocus()) {
        painter.setPen(hasFocus() ? QPen(theme_.accent, 2.0) : QPen(Qt::NoPen));
        painter.setBrush(theme_.chip);
        painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 8.0, 8.0);
    }
    const QRect inside = rect().adjusted(kInset_px, 10, -kInset_px, -10);
    const QRect last(inside.right() + 1 - kLast_px, inside.top(), kLast_px, inside.height());
    QRect line = inside.adjusted(0, 0, -kLast_px - 16, -inside.height() / 2);
    painter.setFont(uiFont(16, QFont::DemiBold));
    painter.setPen(theme_.ink);
    drawFitting(painter, line, text());
    painter.setFont(uiFont(14));
    painter.setPen(theme_.dim);
    drawFitting(painter, line.translated(0, line.height()), entry_.purpose);
    const Tone tone = entry_.verdict ? verdictTone(*entry_.verdict) : Tone::kDim;
    const QColor colour = colourOf(tone, theme_);
    painter.setPen(colour);
    drawFitting(painter, last.adjusted(kMark_px, 0, 0, 0), entry_.last);
    if (entry_.verdict)
        drawToneMark(painter, {last.left() + 8.0, last.center().y() + 1.0}, tone, colour);
}

void ProcedureRow::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Space) {
        QAbstractButton::keyPressEvent(event);
    } else {
        event->ignore();  // the list's: from row to row, and Enter
    }
}

}  // namespace hedr
