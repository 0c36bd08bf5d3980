#pragma once

#include <QFont>
#include <QFontMetricsF>
#include <QHash>
#include <QPainter>
#include <QStaticText>

namespace hedr {

// The shipped font (Inter), the same on every machine. Needs a QGuiApplication.
QFont uiFont(int pixel_size, QFont::Weight weight = QFont::Normal);

// Text whose digits all take the same room, so that a running number does not wobble. (QFont gets
// font features in Qt 6.7 only.) `baseline` is the left end of the line.
// What has been laid out is kept, for text that is another one ten times a second.
class FigureType {
  public:
    explicit FigureType(const QFont& font);
    const QFont& font() const { return font_; }
    double width(const QString& text);
    void draw(QPainter& painter, QPointF baseline, const QString& text);

  private:
    struct Piece {
        QStaticText text;
        double width_px = 0.0;
    };
    Piece& laidOut(const QString& text);

    QFont font_;
    double digit_width_px_ = 0.0;  // of the widest one
    double ascent_px_ = 0.0;
    QHash<QString, Piece> pieces_;
};

// For text that seldom changes.
void drawFigures(QPainter& painter, QPointF baseline, const QString& text);
double figuresWidth(const QFont& font, const QString& text);

}  // namespace hedr
