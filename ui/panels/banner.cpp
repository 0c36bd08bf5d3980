#include "ui/panels/banner.h"

#include <QClipboard>
#include <QFontMetrics>
#include <QGuiApplication>
#include <QPainter>
#include <QTimer>
#include <algorithm>

#include "ui/error_text.h"
#include "ui/fonts.h"
#include "ui/style_sheet.h"

namespace hedr {
namespace {

constexpr int kUnread_ms = 400;  // a double click must not acknowledge what has just appeared
constexpr int kLeft_px = 66;
constexpr int kRight_px = 24;
constexpr int kButton_px = 84;
constexpr int kButtonHeight_px = 44;
constexpr int kBetween_px = 6;
constexpr int kLeftOfButtons_px = 22;

QFont textFont() { return uiFont(16, QFont::Medium); }

QColor colourOf(BannerTone tone, const Theme& theme) {
    switch (tone) {
        case BannerTone::kNews:
            return theme.good;
        case BannerTone::kWarning:
            return theme.warning;
        case BannerTone::kAlarm:
            break;
    }
    return theme.alarm;
}

}  // namespace

Banner::Banner(QWidget* parent)
    : Card(parent),
      button_(new QPushButton(tr("OK"), this)),
      copy_button_(new QPushButton(tr("Copy"), this)) {
    button_->setToolTip(tr("I have read this"));
    button_->setAccessibleName(tr("Acknowledge"));
    button_->hide();
    connect(button_, &QPushButton::clicked, this, &Banner::acknowledge);
    copy_button_->hide();
    connect(copy_button_, &QPushButton::clicked, this, &Banner::copyLine);
    setVisible(false);
}

void Banner::setTheme(const Theme& theme) {
    Card::setTheme(theme);
    for (QPushButton* button : {button_, copy_button_}) button->setStyleSheet(buttonSheet(theme));
}

void Banner::setText(const QString& text, BannerTone tone) {
    if (text == text_ && tone == tone_) return;
    text_ = text;
    tone_ = tone;
    setAccessibleName(text);
    showCopyButton();
    setVisible(!text.isEmpty());
    update();
}

void Banner::setAcknowledgeable(bool acknowledgeable) {
    acknowledgeable_ = acknowledgeable;
    button_->setVisible(acknowledgeable);
}

void Banner::showCopyButton() {
    const QString line = lineToCopy(text_);
    copy_button_->setText(tr("Copy"));
    copy_button_->setToolTip(line);
    copy_button_->setAccessibleName(tr("Copy %1").arg(line));
    copy_button_->setVisible(!line.isEmpty());
    placeButtons();
}

void Banner::copyLine() {
    QGuiApplication::clipboard()->setText(lineToCopy(text_));
    copy_button_->setText(tr("Copied"));
    placeButtons();
}

// A warning that has not been read steps back behind an alarm.
void Banner::add(const QString& text, BannerTone tone) {
    const Message added{text, tone};
    const Message shown{text_, tone_};
    if (added == shown || std::ranges::find(waiting_, added) != waiting_.end()) return;
    const auto place =
        std::ranges::find_if(waiting_, [&](const Message& message) { return message.tone < tone; });
    if (text_.isEmpty()) {
        setText(text, tone);
    } else if (tone_ < tone) {
        waiting_.insert(waiting_.begin(), shown);
        showInstead(added);
    } else {
        waiting_.insert(place, added);
    }
    showButtonText();
}

void Banner::acknowledge() {
    if (waiting_.empty()) {
        setText({}, BannerTone::kNews);
    } else {
        const Message next = waiting_.front();
        waiting_.erase(waiting_.begin());
        showInstead(next);
    }
    showButtonText();
    emit acknowledged();
}

void Banner::showInstead(const Message& message) {
    setText(message.text, message.tone);
    button_->setEnabled(false);
    QTimer::singleShot(kUnread_ms, button_, [this] { button_->setEnabled(true); });
}

void Banner::showButtonText() {
    button_->setText(waiting_.empty() ? tr("OK") : tr("Next (%1)").arg(waiting_.size()));
    placeButtons();
}

int Banner::buttonWidth() const { return std::max(kButton_px, button_->sizeHint().width()); }

int Banner::copyWidth() const {
    return copy_button_->isHidden() ? 0 : std::max(kButton_px, copy_button_->sizeHint().width());
}

// Right of the text.
int Banner::buttonRoom() const {
    const int acknowledge = acknowledgeable_ ? buttonWidth() + kBetween_px : 0;
    const int copy = copyWidth() > 0 ? copyWidth() + kBetween_px : 0;
    return acknowledge + copy > 0 ? acknowledge + copy + kLeftOfButtons_px : kRight_px;
}

QSize Banner::sizeWithin(int width) const {
    const int around = kLeft_px + buttonRoom();
    const QFontMetrics metrics(textFont());
    const QRect text = metrics.boundingRect(QRect(0, 0, std::max(120, width - around), 1000),
                                            Qt::TextWordWrap, text_);
    return {std::min(width, text.width() + 2 + around), std::max(56, text.height() + 30)};
}

void Banner::placeButtons() {
    const int top = height() / 2 - kButtonHeight_px / 2;
    const int acknowledge_left = width() - buttonWidth() - kBetween_px;
    const int copy_right = acknowledgeable_ ? acknowledge_left : width();
    button_->setGeometry(acknowledge_left, top, buttonWidth(), kButtonHeight_px);
    copy_button_->setGeometry(copy_right - copyWidth() - kBetween_px, top, copyWidth(),
                              kButtonHeight_px);
}

void Banner::resizeEvent(QResizeEvent*) { placeButtons(); }

// A tick, or a triangle.
void Banner::paintSign(QPainter& painter, const QPointF& middle) const {
    if (tone_ == BannerTone::kNews) {
        painter.drawPolyline(QPolygonF(
            {middle + QPointF(-11, 1), middle + QPointF(-3, 9), middle + QPointF(11, -8)}));
        return;
    }
    painter.drawPolygon(
        QPolygonF({middle + QPointF(0, -10), middle + QPointF(12, 10), middle + QPointF(-12, 10)}));
}

void Banner::paintEvent(QPaintEvent*) {
    const QColor colour = colourOf(tone_, theme());
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colour, 2.0));
    painter.setBrush(theme().chrome);
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 10.0, 10.0);
    painter.setPen(QPen(colour, 3.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    paintSign(painter, {38.0, height() / 2.0 - 1.0});
    painter.setFont(textFont());
    painter.setPen(theme().ink);
    painter.drawText(QRectF(kLeft_px, 0, width() - kLeft_px - buttonRoom() + 2, height()),
                     Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap, text_);
}

}  // namespace hedr
