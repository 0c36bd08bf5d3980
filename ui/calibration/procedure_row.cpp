#include "ui/calibration/procedure_row.h"

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

ProcedureRow::ProcedureRow(QWidget* parent) : RowButton(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
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
    paintGround(painter);
    const QRect inside = rect().adjusted(kInset_px, 10, -kInset_px, -10);
    const QRect last(inside.right() + 1 - kLast_px, inside.top(), kLast_px, inside.height());
    QRect line = inside.adjusted(0, 0, -kLast_px - 16, -inside.height() / 2);
    painter.setFont(uiFont(16, QFont::DemiBold));
    painter.setPen(theme().ink);
    drawFitting(painter, line, text());
    painter.setFont(uiFont(14));
    painter.setPen(theme().dim);
    drawFitting(painter, line.translated(0, line.height()), entry_.purpose);
    const Tone tone = entry_.verdict ? verdictTone(*entry_.verdict) : Tone::kDim;
    const QColor colour = colourOf(tone, theme());
    painter.setPen(colour);
    drawFitting(painter, last.adjusted(kMark_px, 0, 0, 0), entry_.last);
    if (entry_.verdict)
        drawToneMark(painter, {last.left() + 8.0, last.center().y() + 1.0}, tone, colour);
}

}  // namespace hedr
