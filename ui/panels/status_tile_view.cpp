#include "ui/panels/status_tile_view.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/fonts.h"

namespace hedr {
namespace {

constexpr double kMarkRoom_px = 26.0;
constexpr int kDetail_px = 13;

double padding(int value_px) { return value_px >= 23 ? 14.0 : 8.0; }

double markRoom(const StatusTile& tile) { return tile.mark == Mark::kNone ? 0.0 : kMarkRoom_px; }

QFont valueFont(int value_px) { return uiFont(value_px, QFont::DemiBold); }

// As wide as the text itself.
QString inNoughts(QString text) {
    for (QChar& letter : text) {
        if (letter.isDigit()) letter = u'0';
    }
    return text;
}

QString separator() { return QStringLiteral(" · "); }

int padded(double width, int value_px) {
    return static_cast<int>(std::ceil(width + 2.0 * padding(value_px)));
}

}  // namespace

StatusTileView::StatusTileView(QWidget* parent)
    : QWidget(parent), detail_type_(uiFont(kDetail_px)), value_type_(valueFont(value_px_)) {
    setAttribute(Qt::WA_OpaquePaintEvent);
}

void StatusTileView::setTheme(const Theme& theme) {
    theme_ = theme;
    update();
}

// Measuring costs more than painting, and mostly only figures change, which are all alike wide.
bool StatusTileView::measureAfter(const StatusTile& before) {
    const double value = value_width_;
    const double detail = detail_width_;
    const double label = label_width_;
    constexpr int kSample_px = 100;
    const auto widen = [&](const QString& now, const QString& then) {
        if (inNoughts(now) == inNoughts(then)) return;
        value_width_ =
            std::max(value_width_, figuresWidth(valueFont(kSample_px), now) / kSample_px);
    };
    widen(tile_.value, before.value);
    widen(tile_.widest_value, before.widest_value);
    if (inNoughts(tile_.detail) != inNoughts(before.detail)) {
        detail_width_ = std::max(detail_width_, detail_type_.width(tile_.detail));
    }
    if (tile_.label != before.label) label_width_ = detail_type_.width(tile_.label);
    return value != value_width_ || detail != detail_width_ || label != label_width_ ||
           markRoom(tile_) != markRoom(before);
}

bool StatusTileView::setTile(const StatusTile& tile) {
    if (tile == tile_) return false;
    const StatusTile before = std::exchange(tile_, tile);
    setAccessibleName(tile.label);
    setAccessibleDescription(tile.value + QStringLiteral(", ") + tile.detail);
    setToolTip(tile.note.isEmpty() ? tile.detail : tile.detail + QChar(u'\n') + tile.note);
    update();
    return measureAfter(before);
}

void StatusTileView::setClickable(bool clickable) {
    clickable_ = clickable;
    setCursor(clickable ? Qt::PointingHandCursor : Qt::ArrowCursor);
}

void StatusTileView::mousePressEvent(QMouseEvent* event) {
    if (clickable_ && event->button() == Qt::LeftButton) emit clicked();
}

void StatusTileView::setValueSize(int value_px) {
    if (value_px == value_px_) return;
    value_px_ = value_px;
    value_type_ = FigureType(valueFont(value_px));
    update();
}

int StatusTileView::neededWidth(int value_px) const {
    return padded(std::max(label_width_, value_px * value_width_ + markRoom(tile_)), value_px);
}

int StatusTileView::wantedWidth(int value_px) const {
    const int most_px = value_px >= 23 ? 260 : 130;
    return std::max(neededWidth(value_px), std::min(padded(detail_width_, value_px), most_px));
}

// Leaves out whole parts from the end before it cuts a word.
QString StatusTileView::detailWithin(double width) {
    QString detail = tile_.detail;
    while (detail_type_.width(detail) > width && detail.contains(separator())) {
        detail.truncate(detail.lastIndexOf(separator()));
    }
    if (detail_type_.width(detail) > width && detail.contains(QStringLiteral(", "))) {
        detail.truncate(detail.lastIndexOf(QStringLiteral(", ")));
    }
    return detail_type_.width(detail) > width
               ? QFontMetricsF(detail_type_.font()).elidedText(detail, Qt::ElideRight, width)
               : detail;
}

void StatusTileView::paintMark(QPainter& painter, const QPointF& centre,
                               const QColor& colour) const {
    painter.setPen(QPen(colour, 2.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    switch (tile_.mark) {
        case Mark::kRing:
            painter.drawEllipse(centre, 6.5, 6.5);
            break;
        case Mark::kTriangle:
            painter.drawPolygon(QPolygonF(
                {centre + QPointF(0, -7.5), centre + QPointF(8, 6.5), centre + QPointF(-8, 6.5)}));
            break;
        case Mark::kCross:
            painter.drawLine(centre + QPointF(-6, -6), centre + QPointF(6, 6));
            painter.drawLine(centre + QPointF(6, -6), centre + QPointF(-6, 6));
            break;
        case Mark::kDisc:
        case Mark::kRecording:
            painter.setPen(Qt::NoPen);
            painter.setBrush(tile_.mark == Mark::kRecording ? theme_.recording : colour);
            painter.drawEllipse(centre, 8.0, 8.0);
            break;
        case Mark::kNone:
            break;
    }
}

void StatusTileView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), theme_.chrome);
    painter.setRenderHint(QPainter::Antialiasing);
    const double left = padding(value_px_);
    painter.setPen(theme_.dim);
    detail_type_.draw(painter, {left, 25.0}, tile_.label);
    detail_type_.draw(painter, {left, 77.0}, detailWithin(width() - 2.0 * left));
    const QColor colour = colourOf(tile_.tone, theme_);
    paintMark(painter, {left + 8.0, 47.0}, colour);
    painter.setPen(colour);
    value_type_.draw(painter, {left + markRoom(tile_), 47.0 + 0.364 * value_px_}, tile_.value);
}

}  // namespace hedr
