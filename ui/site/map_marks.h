#pragma once

#include <QColor>
#include <QPainter>
#include <QPointF>
#include <QString>
#include <cstddef>

#include "ui/theme.h"

namespace hedr {

// What pages draw on the map; a light rim keeps a mark readable on any plan.
inline constexpr double kMarkReach_px = 16.0;     // of the pointer, to take hold of a mark
inline constexpr double kNumberRadius_px = 12.0;  // of a numbered circle

void drawDot(QPainter& painter, QPointF at, double radius_px, const QColor& fill,
             const Theme& theme);
void drawNumber(QPainter& painter, QPointF at, std::size_t number, const QColor& colour,
                const Theme& theme);
void drawLine(QPainter& painter, QPointF from, QPointF to, const QColor& colour,
              const Theme& theme);

// A few words at the lower edge of the map.
void drawNote(QPainter& painter, const QString& text, const Theme& theme);

}  // namespace hedr
