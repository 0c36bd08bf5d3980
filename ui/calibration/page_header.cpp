#include "ui/calibration/page_header.h"

#include <QPainter>
#include <algorithm>

#include "ui/fonts.h"

namespace hedr {

PageHeader::PageHeader(QWidget* parent) : QWidget(parent) {}

void PageHeader::setTheme(const Theme& theme) {
    theme_ = theme;
    update();
}

void PageHeader::setMargin(int margin_px) {
    margin_px_ = margin_px;
    update();
}

void PageHeader::show(const QString& title, const QString& context) {
    title_ = title;
    context_ = context;
    setAccessibleName(title);
    setAccessibleDescription(context);
    update();
}

// The title goes first; the context has what is left, its last words being the ones that change.
void PageHeader::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), theme_.chrome);
    painter.fillRect(0, height() - 1, width(), 1, theme_.hairline);
    const QFont large = uiFont(22, QFont::DemiBold);
    const QFont small = uiFont(15);
    const QRect inside = rect().adjusted(margin_px_, 0, -margin_px_, -1);
    constexpr int kBetween_px = 24;
    const int context_px = std::min(QFontMetrics(small).horizontalAdvance(context_) + 1,
                                    inside.width() / 2 - kBetween_px);
    const QRect left = inside.adjusted(0, 0, -context_px - kBetween_px, 0);
    painter.setFont(large);
    painter.setPen(theme_.ink);
    painter.drawText(left, Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(title_, Qt::ElideRight, left.width()));
    painter.setFont(small);
    painter.setPen(theme_.dim);
    painter.drawText(inside, Qt::AlignRight | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(context_, Qt::ElideLeft, context_px));
}

}  // namespace hedr
