#include "ui/panels/robots_card.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/actions.h"
#include "ui/fonts.h"
#include "ui/format.h"
#include "ui/icons.h"
#include "ui/link/link_figures.h"
#include "ui/map/robot_symbol.h"
#include "ui/style_sheet.h"

namespace hedr {
namespace {

constexpr int kRow_px = 40;
constexpr int kTop_px = 34;
constexpr int kSide_px = 8;
constexpr int kMark_px = 40;
constexpr int kRemove_px = 32;
constexpr int kGap_px = 20;

QFont nameFont(bool chosen) { return uiFont(15, chosen ? QFont::DemiBold : QFont::Medium); }

QString keyOf(ActionId id) {
    for (const ActionEntry& entry : actionTable()) {
        if (entry.id == id) return entry.key.toString(QKeySequence::NativeText);
    }
    return {};
}

struct StateWords {
    QString text;
    Tone tone;
};

StateWords liveWords(const LiveModel& model, ReceiveClock::time_point now) {
    if (model.link(now).trouble == LinkTrouble::kRobotFault) {
        return {RobotsCard::tr("FAULT"), Tone::kAlarm};
    }
    if (model.trust(now) == Trust::kLostLock) return {RobotsCard::tr("LOST LOCK"), Tone::kAlarm};
    constexpr double kWorthSaying = 0.05;
    const double loss = recentLoss(model).value_or(0.0);
    if (loss < kWorthSaying) return {RobotsCard::tr("LIVE"), Tone::kGood};
    return {RobotsCard::tr("LIVE · loss %1").arg(formatLoss(loss)), Tone::kWarning};
}

StateWords stateWords(const LiveModel& model, ReceiveClock::time_point now) {
    const LinkVerdict link = model.link(now);
    switch (link.state) {
        case LinkState::kOff:
            return {RobotsCard::tr("not connected"), Tone::kDim};
        case LinkState::kWaiting:
            return {RobotsCard::tr("waiting"), Tone::kPlain};
        case LinkState::kStale:
            return {RobotsCard::tr("STALE %1").arg(formatAge(link.age_s)), Tone::kWarning};
        case LinkState::kLost:
            return {RobotsCard::tr("LOST %1").arg(formatAge(link.age_s)), Tone::kAlarm};
        case LinkState::kLive:
            break;
    }
    return liveWords(model, now);
}

}  // namespace

std::vector<RobotEntry> robotEntries(const Fleet& fleet, ReceiveClock::time_point now) {
    std::vector<RobotEntry> entries;
    for (const FleetRobot& robot : fleet.robots()) {
        const auto [text, tone] = stateWords(robot.model, now);
        entries.push_back({robot.id, robot.mark, fleet.callSign(robot), text, tone,
                           &robot == &fleet.chosen(), fleet.mayRemove(robot)});
    }
    return entries;
}

RobotRow::RobotRow(QWidget* parent) : QAbstractButton(parent), remove_(new QPushButton(this)) {
    setCheckable(true);
    setFocusPolicy(Qt::TabFocus);  // a click leaves the keys with the map
    setAttribute(Qt::WA_Hover);
    remove_->setFocusPolicy(Qt::TabFocus);
    remove_->setToolTip(tr("Take it off the list; its mission is kept"));
    remove_->hide();
    connect(remove_, &QPushButton::clicked, this, &RobotRow::removeWished);
}

void RobotRow::setTheme(const Theme& theme) {
    theme_ = theme;
    remove_->setStyleSheet(flatButtonSheet(theme) + QStringLiteral("QPushButton { padding: 0; }"));
    remove_->setIcon(
        QIcon(iconPixmap(QStringLiteral("close"), theme.dim, 16, devicePixelRatioF())));
    update();
}

void RobotRow::setEntry(const RobotEntry& entry) {
    entry_ = entry;
    setText(entry.call_sign);
    setAccessibleName(entry.call_sign);
    setAccessibleDescription(entry.state);
    setToolTip(entry.chosen
                   ? tr("The strip and the keys are about this robot")
                   : tr("Turn to this robot (%1: the next one)").arg(keyOf(ActionId::kNextRobot)));
    setChecked(entry.chosen);
    remove_->setAccessibleName(tr("Remove %1").arg(entry.call_sign));
    remove_->setVisible(entry.removable);
    updateGeometry();
    update();
}

// Room for the longest state is kept, so that the card stays still while numbers run.
QSize RobotRow::sizeHint() const {
    const double state = figuresWidth(uiFont(13), tr("LIVE · loss %1").arg(formatLoss(0.888)));
    const double name = figuresWidth(nameFont(true), entry_.call_sign);
    return {static_cast<int>(std::ceil(kMark_px + name + kGap_px + state + kRemove_px + kSide_px)),
            kRow_px};
}

void RobotRow::resizeEvent(QResizeEvent*) {
    remove_->setGeometry(width() - kRemove_px, (height() - kRemove_px) / 2, kRemove_px, kRemove_px);
}

void RobotRow::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (isChecked() || underMouse() || hasFocus()) {
        painter.setPen(hasFocus() ? QPen(theme_.accent, 2.0) : QPen(Qt::NoPen));
        painter.setBrush(theme_.chip);
        painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 8.0, 8.0);
    }
    painter.save();
    painter.translate(kMark_px / 2.0, height() / 2.0);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colourOf(entry_.mark, theme_));
    painter.drawPolygon(robotShape(24.0, entry_.mark.shape));
    painter.restore();
    painter.setFont(nameFont(entry_.chosen));
    painter.setPen(theme_.ink);
    painter.drawText(rect().adjusted(kMark_px, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, text());
    painter.setFont(uiFont(13));
    painter.setPen(colourOf(entry_.tone, theme_));
    const int right = width() - (entry_.removable ? kRemove_px : kSide_px + 2);
    drawFigures(painter, {right - figuresWidth(painter.font(), entry_.state), height() / 2.0 + 4.7},
                entry_.state);
}

RobotsCard::RobotsCard(QWidget* parent)
    : Card(parent), add_(new QPushButton(tr("Connect another robot"), this)) {
    setAccessibleName(tr("Robots"));
    add_->setFocusPolicy(Qt::TabFocus);
    add_->setToolTip(keyOf(ActionId::kAddRobot));
    connect(add_, &QPushButton::clicked, this, &RobotsCard::addWished);
    setVisible(false);
}

void RobotsCard::setTheme(const Theme& theme) {
    Card::setTheme(theme);
    for (RobotRow* row : rows_) row->setTheme(theme);
    add_->setStyleSheet(flatButtonSheet(theme));
}

void RobotsCard::show(const std::vector<RobotEntry>& entries) {
    if (entries == entries_) return;
    entries_ = entries;
    while (rows_.size() > entries.size()) {
        rows_.back()->deleteLater();
        rows_.back()->hide();
        rows_.pop_back();
    }
    while (rows_.size() < entries.size()) {
        auto* row = new RobotRow(this);
        const std::size_t place = rows_.size();
        row->setTheme(theme());
        row->setVisible(true);
        connect(row, &QAbstractButton::clicked, this,
                [this, place] { emit robotChosen(entries_.at(place).id); });
        connect(row, &RobotRow::removeWished, this,
                [this, place] { emit removeWished(entries_.at(place).id); });
        rows_.push_back(row);
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) rows_[i]->setEntry(entries_[i]);
    fitToRows();
}

void RobotsCard::setLeastWidth(int least_px) {
    if (std::exchange(least_width_px_, least_px) != least_px) fitToRows();
}

void RobotsCard::fitToRows() {
    int width = std::max(add_->sizeHint().width(), least_width_px_ - 2 * kSide_px);
    for (const RobotRow* row : rows_) width = std::max(width, row->sizeHint().width());
    int y = kTop_px;
    for (RobotRow* row : rows_) {
        row->setGeometry(kSide_px, y, width, kRow_px);
        y += kRow_px;
    }
    add_->setGeometry(kSide_px, y, width, kRow_px);
    resize(width + 2 * kSide_px, y + kRow_px + 4);
}

void RobotsCard::paintEvent(QPaintEvent* event) {
    Card::paintEvent(event);
    QPainter painter(this);
    painter.setFont(uiFont(13));
    painter.setPen(theme().dim);
    painter.drawText(QPointF(18.0, 27.0), tr("ROBOTS"));
}

}  // namespace hedr
