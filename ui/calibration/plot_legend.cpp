#include "ui/calibration/plot_legend.h"

#include <QPainter>
#include <algorithm>

#include "ui/calibration/series_style.h"
#include "ui/fonts.h"

namespace hedr {
namespace {

constexpr int kLine_px = 24;
constexpr int kBetween_px = 24;

QFont legendFont() { return uiFont(13); }

int sampleWidth(const SeriesStyle& style) { return isMark(style.shape) ? 12 : 24; }

// From the left end of an entry to its words.
int wordsFrom(const SeriesStyle& style) { return sampleWidth(style) + 8; }

void drawSample(QPainter& painter, const QPointF& centre, const SeriesStyle& style,
                const Theme& theme) {
    if (isMark(style.shape)) return drawMark(painter, centre, style, 12.0, theme.chrome);
    painter.setPen(style.shape == EvidenceSeries::Shape::kBand ? QPen(Qt::NoPen) : linePen(style));
    painter.setBrush(fieldColour(style));
    if (isField(style.shape)) {
        painter.drawRoundedRect(QRectF(centre - QPointF(12.0, 6.0), QSizeF(24.0, 12.0)), 6.0, 6.0);
    } else {
        painter.drawLine(centre - QPointF(12.0, 0.0), centre + QPointF(12.0, 0.0));
    }
}

}  // namespace

PlotLegend::PlotLegend(QWidget* parent) : QWidget(parent) {
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
}

void PlotLegend::setTheme(const Theme& theme) {
    theme_ = theme;
    update();
}

void PlotLegend::show(const EvidencePlot& plot) {
    names_.series.clear();
    QStringList words;
    for (const EvidenceSeries& series : plot.series) {
        names_.series.push_back({.name = series.name, .shape = series.shape});
    }
    for (const SeriesStyle& entry : legendEntries(names_, theme_)) words << entry.name;
    update();
    if (words.join(QStringLiteral(", ")) == accessibleName()) return;
    setAccessibleName(words.join(QStringLiteral(", ")));
    updateGeometry();
}

std::vector<QRect> PlotLegend::places(int width_px, const std::vector<SeriesStyle>& entries) const {
    const QFontMetrics metrics(legendFont());
    std::vector<QRect> places;
    QPoint at(0, 0);
    for (const SeriesStyle& entry : entries) {
        const int wanted_px = wordsFrom(entry) + metrics.horizontalAdvance(entry.name) + 2;
        const int entry_px = std::min(wanted_px, std::max(width_px, wordsFrom(entry)));
        if (at.x() > 0 && at.x() + entry_px > width_px) at = {0, at.y() + kLine_px};
        places.emplace_back(at, QSize(entry_px, kLine_px));
        at.rx() += entry_px + kBetween_px;
    }
    return places;
}

int PlotLegend::heightForWidth(int width_px) const {
    const std::vector<QRect> all = places(width_px, legendEntries(names_, theme_));
    return all.empty() ? kLine_px : all.back().bottom() + 1;
}

void PlotLegend::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(legendFont());
    const std::vector<SeriesStyle> entries = legendEntries(names_, theme_);
    const std::vector<QRect> all = places(width(), entries);
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const QRect words = all[i].adjusted(wordsFrom(entries[i]), 0, 0, 0);
        drawSample(painter,
                   {all[i].left() + 0.5 * sampleWidth(entries[i]), all[i].center().y() + 1.0},
                   entries[i], theme_);
        painter.setPen(theme_.ink);
        painter.drawText(
            words, Qt::AlignLeft | Qt::AlignVCenter,
            painter.fontMetrics().elidedText(entries[i].name, Qt::ElideRight, words.width()));
    }
}

}  // namespace hedr
