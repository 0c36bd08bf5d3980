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

// Calls `place` with every piece (one digit, or the text between digits) and its offset; gives the
// whole width.
template <class WidthOf, class Place>
double layOut(const QString& text, double digit_width, WidthOf width_of, Place place) {
    double x = 0.0;
    for (qsizetype from = 0; from < text.size();) {
        qsizetype to = from + 1;
        const bool digit = text[from].isDigit();
        while (!digit && to < text.size() && !text[to].isDigit()) ++to;
        const QString piece = text.mid(from, to - from);
        const double own_width = width_of(piece);
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

FigureType::FigureType(const QFont& font) : font_(font) {
    const QFontMetricsF metrics(font);
    ascent_px_ = metrics.ascent();
    for (char16_t digit = u'0'; digit <= u'9'; ++digit) {
        digit_width_px_ = std::max(digit_width_px_, metrics.horizontalAdvance(QChar(digit)));
    }
}

FigureType::Piece& FigureType::laidOut(const QString& text) {
    constexpr qsizetype kMost = 64;
    if (const auto found = pieces_.find(text); found != pieces_.end()) return *found;
    if (pieces_.size() >= kMost) pieces_.clear();
    Piece piece{QStaticText(text), QFontMetricsF(font_).horizontalAdvance(text)};
    piece.text.setTextFormat(Qt::PlainText);
    piece.text.prepare({}, font_);
    return *pieces_.insert(text, piece);
}

double FigureType::width(const QString& text) {
    return layOut(
        text, digit_width_px_, [this](const QString& piece) { return laidOut(piece).width_px; },
        [](const QString&, double) {});
}

void FigureType::draw(QPainter& painter, QPointF baseline, const QString& text) {
    painter.setFont(font_);
    layOut(
        text, digit_width_px_, [this](const QString& piece) { return laidOut(piece).width_px; },
        [&](const QString& piece, double x) {
            painter.drawStaticText(baseline + QPointF(x, -ascent_px_), laidOut(piece).text);
        });
}

void drawFigures(QPainter& painter, QPointF baseline, const QString& text) {
    FigureType(painter.font()).draw(painter, baseline, text);
}

double figuresWidth(const QFont& font, const QString& text) { return FigureType(font).width(text); }

}  // namespace hedr
