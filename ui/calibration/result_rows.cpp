#include "ui/calibration/result_rows.h"

#include <QCoreApplication>
#include <QPainter>
#include <algorithm>

#include "ui/fonts.h"

namespace hedr {
namespace {

QString rowText(const char* text) { return QCoreApplication::translate("ResultRows", text); }

QFont largeFont() { return uiFont(25, QFont::DemiBold); }

void drawWords(QPainter& painter, double baseline, double width_px, const QString& words) {
    painter.drawText(QPointF(0.0, baseline),
                     QFontMetricsF(painter.font()).elidedText(words, Qt::ElideRight, width_px));
}

QString sentenceCase(QString words) {
    if (!words.isEmpty()) words[0] = words[0].toUpper();
    return words;
}

}  // namespace

ResultRow::ResultRow(Heights heights, QWidget* parent) : QWidget(parent), heights_(heights) {
    setRoomy(true);
}

void ResultRow::setTheme(const Theme& theme) {
    theme_ = theme;
    update();
}

void ResultRow::setRoomy(bool roomy) {
    roomy_ = roomy;
    setFixedHeight(roomy ? heights_.roomy_px : heights_.tight_px);
    update();
}

void ResultRow::setSecondColumn(double from_px) {
    second_column_px_ = from_px;
    update();
}

void ResultRow::say(const QString& name, const QString& words) {
    setAccessibleName(name);
    setAccessibleDescription(words);
    setVisible(true);
    update();
}

FoundRow::FoundRow(QWidget* parent) : ResultRow({88, 72}, parent) {}

void FoundRow::show(const FoundParameter& found) {
    text_ = foundText(found);
    say(text_.name, QStringList{text_.value, text_.margin, text_.was}.join(QStringLiteral(", ")));
}

double FoundRow::valueWidth() const { return figuresWidth(largeFont(), text_.value); }

// A margin for which there is no room beside the value goes with what was.
void FoundRow::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const double value_base = isRoomy() ? 46.0 : 38.0;
    painter.setFont(uiFont(15));
    painter.setPen(theme().dim);
    drawWords(painter, 14.0, width(), text_.name);
    FigureType large(largeFont());
    painter.setPen(theme().ink);
    large.draw(painter, {0.0, value_base}, text_.value);
    FigureType small(uiFont(15));
    painter.setPen(theme().dim);
    constexpr double kBetween_px = 16.0;
    const double from_px = std::max(secondColumn(), large.width(text_.value) + kBetween_px);
    const bool beside = from_px + small.width(text_.margin) <= width();
    if (beside) small.draw(painter, {from_px, value_base}, text_.margin);
    painter.setFont(uiFont(13));
    drawWords(painter, isRoomy() ? 68.0 : 57.0, width(),
              beside ? text_.was : text_.margin + QStringLiteral(", ") + text_.was);
}

FigureRow::FigureRow(QWidget* parent) : ResultRow({48, 44}, parent) {}

void FigureRow::show(const EvidenceFigure& figure) {
    value_ = figureValue(figure);
    interval_ = figureInterval(figure);
    say(QString::fromStdString(figure.name),
        interval_.isEmpty() ? value_ : value_ + QStringLiteral(", ") + interval_);
}

void FigureRow::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    constexpr double kValueBase_px = 32.0;
    painter.setFont(uiFont(13));
    painter.setPen(theme().dim);
    drawWords(painter, 12.0, width(), accessibleName());
    FigureType type(uiFont(15, QFont::Medium));
    painter.setPen(theme().ink);
    type.draw(painter, {0.0, kValueBase_px}, value_);
    FigureType small(uiFont(13));
    painter.setPen(theme().dim);
    const double after_value_px = type.width(value_) + 12.0;
    const double room_px = width() - small.width(interval_);
    if (after_value_px > room_px) return;
    const double from_px = std::min(std::max(secondColumn(), after_value_px), room_px);
    small.draw(painter, {from_px, kValueBase_px}, interval_);
}

ProofBars::ProofBars(QWidget* parent) : ResultRow({80, 72}, parent) {}

void ProofBars::show(const std::optional<Proof>& proof, Tone tone) {
    tone_ = tone;
    before_.clear();
    if (!proof || proof->parts == 0) {
        return say(rowText("Held-out error"), rowText("Nothing could be held out yet."));
    }
    const double most = std::max(proof->before, proof->after);
    before_ = rowText("was %1").arg(errorValue(proof->before, proof->unit, most));
    after_ = rowText("now %1").arg(errorValue(proof->after, proof->unit, most));
    before_share_ = most > 0.0 ? proof->before / most : 0.0;
    after_share_ = most > 0.0 ? proof->after / most : 0.0;
    say(rowText("%1, held out").arg(sentenceCase(QString::fromStdString(proof->what))),
        before_ + QStringLiteral(", ") + after_);
}

void ProofBars::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(uiFont(14));
    if (before_.isEmpty()) {
        return paintBar(painter, 0.0, 1.0, theme().chip, accessibleDescription());
    }
    paintBar(painter, 0.0, before_share_, theme().dim, before_);
    paintBar(painter, isRoomy() ? 44.0 : 38.0, after_share_, colourOf(tone_, theme()), after_);
}

void ProofBars::paintBar(QPainter& painter, double top, double share, const QColor& colour,
                         const QString& words) const {
    constexpr double kBar_px = 14.0;
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawRoundedRect(QRectF(0.0, top, std::max(kBar_px, share * width()), kBar_px),
                            0.5 * kBar_px, 0.5 * kBar_px);
    painter.setPen(theme().ink);
    painter.drawText(QPointF(0.0, top + kBar_px + 16.0), words);
}

}  // namespace hedr
