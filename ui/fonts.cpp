#include "ui/fonts.h"

#include <QFontDatabase>
#include <algorithm>

// Q_INIT_RESOURCE must stand outside every namespace.
static void initResources() { Q_INIT_RESOURCE(assets); }

namespace hedr {
namespace {

QString loadFamily() {
    initResources();
    int id = -1;
    for (const char* file :
         {":/fonts/Inter-Medium.otf", ":/fonts/Inter-SemiBold.otf", ":/fonts/Inter-Regular.otf"}) {
        id = QFontDatabase::addApplicationFont(QString::fromLatin1(file));
    }
    return QFontDatabase::applicationFontFamilies(id).value(0);
}

double digitWidth(const QFontMetricsF& metrics) {
    double widest = 0.0;
    for (char16_t digit = u'0'; digit <= u'9'; ++digit) {
        widest = std::max(widest, metrics.horizontalAdvance(QChar(digit)));
    }
    return widest;
}

// Calls `place` with every piece (one digit, or the text between digits), its offset and its width.
template <class Place>
double layOut(const QFont& font, const QString& text, Place place) {
    const QFontMetricsF metrics(font);
    const double digit_width = digitWidth(metrics);
    double x = 0.0;
    for (qsizetype from = 0; from < text.size();) {
        qsizetype to = from + 1;
        const bool digit = text[from].isDigit();
        while (!digit && to < text.size() && !text[to].isDigit()) ++to;
        const QString piece = text.mid(from, to - from);
        const double own_width = metrics.horizontalAdvance(piece);
        const double width = digit ? digit_width : own_width;
        place(piece, x + (width - own_width) / 2.0);
        x += width;
        from = to;
    }
    return x;
}

}  // namespace

QFont uiFont(int pixel_size, QFont::Weight weight) {
    static const QString family = loadFamily();
    QFont font(family);
    font.setPixelSize(pixel_size);
    font.setWeight(weight);
    font.setHintingPreference(QFont::PreferNoHinting);
    return font;
}

void drawFigures(QPainter& painter, QPointF baseline, const QString& text) {
    layOut(painter.font(), text, [&](const QString& piece, double x) {
        painter.drawText(baseline + QPointF(x, 0.0), piece);
    });
}

double figuresWidth(const QFont& font, const QString& text) {
    return layOut(font, text, [](const QString&, double) {});
}

}  // namespace hedr
