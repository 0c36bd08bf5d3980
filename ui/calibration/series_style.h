#pragma once

#include <QPainter>
#include <QPen>
#include <QString>
#include <vector>

#include "core/calibration/evidence.h"
#include "ui/theme.h"

namespace hedr {

// How a series is told from the others, by its colour and by its shape. Series of the same name
// belong together, as the ends of the drives and the ellipse around them do: they have one colour
// and one entry in the legend. A series without a name belongs to the one before.
struct SeriesStyle {
    using Shape = EvidenceSeries::Shape;

    QString name{};
    QColor colour{};
    Shape shape = Shape::kLine;
    std::size_t variant = 0;  // the how-manieth name it is with that shape
};

// One for each series.
std::vector<SeriesStyle> seriesStyles(const EvidencePlot& plot, const Theme& theme);
// One for each name; marks tell more than lines, and lines more than fields.
std::vector<SeriesStyle> legendEntries(const EvidencePlot& plot, const Theme& theme);

bool isMark(EvidenceSeries::Shape shape);
bool isField(EvidenceSeries::Shape shape);  // of an area

QPen linePen(const SeriesStyle& style);
QColor fieldColour(const SeriesStyle& style);
QColor cloudColour(const SeriesStyle& style);  // of many samples, below what is drawn on them
// A dot or a square, `size_px` wide, with a rim in the colour of the ground.
void drawMark(QPainter& painter, const QPointF& centre, const SeriesStyle& style, double size_px,
              const QColor& ground);

}  // namespace hedr
