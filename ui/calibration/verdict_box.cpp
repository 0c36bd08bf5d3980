#include "ui/calibration/verdict_box.h"

#include <QPainter>
#include <QVBoxLayout>

#include "ui/calibration/tone_mark.h"
#include "ui/link/tone_label.h"

namespace hedr {
namespace {

constexpr int kPadding_px = 16;
constexpr int kMarkRoom_px = 24;

}  // namespace

QColor verdictGround(Tone tone, const Theme& theme) {
    if (tone == Tone::kDim || tone == Tone::kPlain) return theme.chip;
    const QColor colour = colourOf(tone, theme);
    constexpr double kShare = 0.11;
    const auto mixed = [](int over, int under) {
        return qRound(kShare * over + (1.0 - kShare) * under);
    };
    return {mixed(colour.red(), theme.chrome.red()), mixed(colour.green(), theme.chrome.green()),
            mixed(colour.blue(), theme.chrome.blue())};
}

VerdictBox::VerdictBox(QWidget* parent)
    : QWidget(parent),
      word_(new QLabel(this)),
      interval_(new QLabel(this)),
      reason_(new QLabel(this)) {
    word_->setProperty("role", QStringLiteral("step"));
    word_->setContentsMargins(kMarkRoom_px, 0, 0, 0);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kPadding_px, 12, kPadding_px, 12);
    column->setSpacing(4);
    for (QLabel* label : {word_, interval_, reason_}) {
        label->setTextFormat(Qt::PlainText);
        label->setWordWrap(true);
        column->addWidget(label);
    }
    interval_->setProperty("role", QStringLiteral("words"));
    reason_->setProperty("role", QStringLiteral("words"));
    column->addStretch();
    setMinimumHeight(112);  // room for two lines of a reason is kept
}

void VerdictBox::setTheme(const Theme& theme) {
    theme_ = theme;
    update();
}

void VerdictBox::show(const VerdictText& text) {
    text_ = text;
    word_->setText(text.word);
    interval_->setText(text.interval);
    interval_->setVisible(!text.interval.isEmpty());
    reason_->setText(text.reason);
    for (QLabel* label : {word_, interval_}) setTone(*label, text.tone);
    setAccessibleName(text.word);
    setAccessibleDescription(text.interval + u' ' + text.reason);
    update();
}

void VerdictBox::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(verdictGround(text_.tone, theme_));
    painter.drawRoundedRect(rect(), 8.0, 8.0);
    drawToneMark(painter, {kPadding_px + 8.0, word_->geometry().top() + 10.0}, text_.tone,
                 colourOf(text_.tone, theme_));
}

}  // namespace hedr
