#include "ui/panels/rail.h"

#include <QPainter>
#include <QVBoxLayout>

#include "ui/fonts.h"
#include "ui/icons.h"

namespace hedr {

RailButton::RailButton(QWidget* parent) : QAbstractButton(parent) {
    setFocusPolicy(Qt::TabFocus);  // a click leaves the keys with the map
    setAttribute(Qt::WA_Hover);
    setFixedSize(sizeHint());
}

void RailButton::setTheme(const Theme& theme) {
    theme_ = theme;
    update();
}

void RailButton::setEntry(const ActionEntry& entry) {
    icon_ = entry.icon;
    setText(entry.text);
    setAccessibleName(entry.text);
    setToolTip(
        QStringLiteral("%1 (%2)").arg(entry.tip, entry.key.toString(QKeySequence::NativeText)));
    update();
}

void RailButton::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (isChecked() || isDown() || underMouse() || hasFocus()) {
        painter.setPen(hasFocus() ? QPen(theme_.accent, 2.0) : QPen(Qt::NoPen));
        painter.setBrush(isChecked() || isDown() || underMouse() ? theme_.chip : theme_.chrome);
        painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 8.0, 8.0);
    }
    constexpr int kIcon_px = 26;
    painter.drawPixmap(
        (width() - kIcon_px) / 2, 10,
        iconPixmap(icon_, isChecked() ? theme_.accent : theme_.ink, kIcon_px, devicePixelRatioF()));
    painter.setFont(uiFont(13));
    painter.setPen(theme_.ink);
    painter.drawText(QRectF(0, 40, width(), 18), Qt::AlignCenter, text());
}

Rail::Rail(QWidget* parent) : Card(parent) {
    setAccessibleName(tr("Actions"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 8, 6, 8);
    column->setSpacing(8);
    for (const ActionEntry& entry : actionTable()) {
        if (!entry.on_rail) continue;
        auto* button = new RailButton(this);
        button->setEntry(entry);
        button->setCheckable(entry.id == ActionId::kFollow);
        column->addWidget(button);
        buttons_[entry.id] = button;
        connect(button, &QAbstractButton::clicked, this,
                [this, id = entry.id] { emit triggered(id); });
    }
}

void Rail::setTheme(const Theme& theme) {
    Card::setTheme(theme);
    for (const auto& [id, button] : buttons_) button->setTheme(theme);
    for (ActionEntry entry : actionTable()) {
        if (entry.id != ActionId::kTheme) continue;
        const bool night = theme.name == ThemeName::kNight;
        entry.text = night ? tr("Day") : tr("Night");
        entry.icon = night ? QStringLiteral("day") : QStringLiteral("night");
        buttons_[entry.id]->setEntry(entry);
    }
}

void Rail::setFollowing(bool following) { buttons_[ActionId::kFollow]->setChecked(following); }

}  // namespace hedr
