#include "ui/calibration/series_style.h"

#include <QPolygonF>
#include <algorithm>
#include <array>

namespace hedr {
namespace {

using Shape = EvidenceSeries::Shape;

constexpr std::array kSeriesColours{&Theme::accent,     &Theme::odometry, &Theme::robot_trail,
                                    &Theme::hedr,       &Theme::gyro,     &Theme::gh_filter,
                                    &Theme::gyrodometry};

// In widths of the line.
const std::vector<QList<qreal>>& dashPatterns(Shape shape) {
    static const std::vector<QList<qreal>> lines{{}, {9.0, 2.0}, {9.0, 2.0, 2.0, 2.0}};
    static const std::vector<QList<qreal>> dashes{{3.0, 2.0}, {6.0, 2.0, 1.5, 2.0}, {1.0, 1.5}};
    return shape == Shape::kDashes ? dashes : lines;
}

struct SeriesName {
    QString name;
    std::vector<Shape> shapes{};
};

SeriesName& named(std::vector<SeriesName>& names, const QString& name) {
    const auto found = std::ranges::find(names, name, &SeriesName::name);
    if (found != names.end()) return *found;
    return names.emplace_back(SeriesName{name});
}

std::size_t placeOf(const std::vector<SeriesName>& names, const QString& name) {
    return static_cast<std::size_t>(std::ranges::find(names, name, &SeriesName::name) -
                                    names.begin());
}

int tellingRank(Shape shape) { return isMark(shape) ? 2 : isField(shape) ? 0 : 1; }

QPolygonF markOutline(const QPointF& centre, const SeriesStyle& style, double half_px) {
    const bool turned = style.variant % 2 == 1;
    if (style.shape == Shape::kDots) {  // the second kind of dot is a triangle
        return {{centre + QPointF(0.0, -1.1 * half_px), centre + QPointF(1.1 * half_px, half_px),
                 centre + QPointF(-1.1 * half_px, half_px)}};
    }
    if (turned) {
        const double reach = 1.3 * half_px;
        return {{centre + QPointF(0, -reach), centre + QPointF(reach, 0),
                 centre + QPointF(0, reach), centre + QPointF(-reach, 0)}};
    }
    return QRectF(centre - QPointF(half_px, half_px), QSizeF(2.0 * half_px, 2.0 * half_px));
}

QColor paled(QColor colour, float opacity) {
    colour.setAlphaF(opacity);
    return colour;
}

}  // namespace

bool isMark(Shape shape) { return shape == Shape::kDots || shape == Shape::kSquares; }

bool isField(Shape shape) { return shape == Shape::kBand || shape == Shape::kEllipse; }

std::vector<SeriesStyle> seriesStyles(const EvidencePlot& plot, const Theme& theme) {
    std::vector<SeriesStyle> styles;
    std::vector<SeriesName> names;
    for (const EvidenceSeries& series : plot.series) {
        QString name = QString::fromStdString(series.name);
        if (name.isEmpty() && !styles.empty()) name = styles.back().name;
        std::size_t variant = 0;
        for (const SeriesName& other : names) {
            const bool alike = std::ranges::count(other.shapes, series.shape) > 0;
            if (other.name != name && alike) ++variant;
        }
        named(names, name).shapes.push_back(series.shape);
        const auto colour = kSeriesColours[placeOf(names, name) % kSeriesColours.size()];
        styles.push_back({name, theme.*colour, series.shape, variant});
    }
    return styles;
}

std::vector<SeriesStyle> legendEntries(const EvidencePlot& plot, const Theme& theme) {
    std::vector<SeriesStyle> entries;
    for (const SeriesStyle& style : seriesStyles(plot, theme)) {
        if (style.name.isEmpty()) continue;
        const auto same = std::ranges::find(entries, style.name, &SeriesStyle::name);
        if (same == entries.end()) {
            entries.push_back(style);
        } else if (tellingRank(style.shape) > tellingRank(same->shape)) {
            *same = style;
        }
    }
    return entries;
}

QPen linePen(const SeriesStyle& style) {
    if (isField(style.shape)) return {style.colour, 1.5};
    const auto& patterns = dashPatterns(style.shape);
    const QList<qreal>& dashes = patterns[style.variant % patterns.size()];
    QPen pen(style.colour, 2.0, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin);
    if (!dashes.empty()) pen.setDashPattern(dashes);
    return pen;
}

QColor fieldColour(const SeriesStyle& style) {
    // A light colour on a dark ground needs more.
    return paled(style.colour, style.colour.lightnessF() > 0.5F ? 0.26F : 0.16F);
}

QColor cloudColour(const SeriesStyle& style) { return paled(style.colour, 0.5F); }

void drawMark(QPainter& painter, const QPointF& centre, const SeriesStyle& style, double size_px,
              const QColor& ground) {
    const double half_px = 0.5 * size_px;
    painter.setPen(QPen(ground, 1.5));
    painter.setBrush(style.colour);
    if (style.shape == Shape::kDots && style.variant % 2 == 0) {
        painter.drawEllipse(centre, half_px, half_px);
    } else {
        painter.drawPolygon(markOutline(centre, style, half_px));
    }
}

}  // namespace hedr
