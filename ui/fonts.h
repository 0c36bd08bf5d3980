#pragma once

#include <QFont>
#include <QFontMetricsF>
#include <QPainter>

namespace hedr {

// The shipped font (Inter), the same on every machine. Needs a QGuiApplication.
QFont uiFont(int pixel_size, QFont::Weight weight = QFont::Normal);

// Text whose digits all take the same room, so that a running number does not wobble. (QFont gets
// font features in Qt 6.7 only.) `baseline` is the left end of the line.
void drawFigures(QPainter& painter, QPointF baseline, const QString& text);
double figuresWidth(const QFont& font, const QString& text);

}  // namespace hedr
