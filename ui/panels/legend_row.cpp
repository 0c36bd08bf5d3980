#include "ui/panels/legend_row.h"

#include <QPainter>
#include <cmath>

#include "ui/actions.h"
#include "ui/fonts.h"
#include "ui/format.h"
#include "ui/map/robot_symbol.h"
#include "ui/trail_style.h"

namespace hedr {
namespace {

constexpr double kLineLeft_px = 6.0;
constexpr double kLineRight_px = 44.0;
constexpr double kTextLeft_px = 56.0;
constexpr double kSide_px = 10.0;
constexpr double kGap_px = 24.0;
constexpr double kLostMark_px = 20.0;  // a triangle where there is no room for words

QString nextKey() {
    for (const ActionEntry& entry : actionTable()) {
        if (entry.id == ActionId::kNextTrail) return entry.key.toString(QKeySequence::NativeText);
    }
    return {};
}

QFont labelFont(bool compact) { return uiFont(compact ? 13 : 15, QFont::Medium); }

}  // namespace

LegendButton::LegendButton(QWidget* parent) : QAbstractButton(parent) {
    setCheckable(true);
    setFocusPolicy(Qt::TabFocus);  // a click leaves the keys with the map
    setAttribute(Qt::WA_Hover);
}

void LegendButton::setTheme(const Theme& theme) {
    theme_ = theme;
    update();
}

void LegendButton::setState(const LegendRowState& state) {
    state_ = state;
    update();
}

void LegendButton::paintFocus(QPainter& painter) const {
    if (!isEnabled() || !(underMouse() || hasFocus())) return;
    painter.setPen(hasFocus() ? QPen(theme_.accent, 2.0) : QPen(Qt::NoPen));
    painter.setBrush(theme_.chip);
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 8.0, 8.0);
}

PrimaryMark::PrimaryMark(const std::string& trail, QWidget* parent) : LegendButton(parent) {
    setAccessibleName(tr("%1 carries the robot").arg(trailLabel(trail)));
}

void PrimaryMark::setState(const LegendRowState& state) {
    LegendButton::setState(state);
    setChecked(state.primary);
    setEnabled(state.shown || state.primary);
    if (state.primary) {
        setToolTip(tr("The robot is where this trail says"));
    } else if (state.shown) {
        setToolTip(tr("Show the robot where this trail says (%1: the next one)").arg(nextKey()));
    } else {
        setToolTip(tr("Show this trail first, then it can carry the robot"));
    }
}

void PrimaryMark::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintFocus(painter);
    painter.translate(QRectF(rect()).center());
    if (isChecked()) {
        painter.setPen(QPen(theme().accent, 1.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.setBrush(theme().accent);
        painter.drawPolygon(robotShape(24.0, state().robot));
        return;
    }
    painter.setPen(QPen(isEnabled() ? theme().dim : theme().hairline, 2.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(QPointF(), 7.0, 7.0);
}

TrailToggle::TrailToggle(const std::string& trail, QWidget* parent)
    : LegendButton(parent), trail_(trail) {
    setText(trailLabel(trail));
    setAccessibleName(text());
    setToolTip(tr("Show or hide this trail"));
}

void TrailToggle::setState(const LegendRowState& state) {
    LegendButton::setState(state);
    setChecked(state.shown);
    setAccessibleDescription(rightText());
}

void TrailToggle::setCompact(bool compact) {
    compact_ = compact;
    updateGeometry();
    update();
}

QString TrailToggle::rightText() const {
    if (state().lost) return tr("LOST LOCK");
    if (!state().shown) return tr("hidden");
    return state().primary ? tr("primary") : state().apart;
}

QSize TrailToggle::sizeHint() const {
    const double label = figuresWidth(labelFont(compact_), text());
    // Room for a distance is kept, so that the card stays still while numbers run.
    const double apart =
        compact_ ? kLostMark_px
                 : kGap_px + figuresWidth(uiFont(13), tr("%1 apart").arg(formatDistance(999.9)));
    return {static_cast<int>(std::ceil(kTextLeft_px + label + apart + kSide_px)),
            LegendRow::kHeight_px};
}

void TrailToggle::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintFocus(painter);
    const bool shown = isChecked();
    const double middle = height() / 2.0;
    QPen pen = trailPen(trail_, state().primary, theme());
    pen.setCapStyle(Qt::FlatCap);
    if (!shown) pen.setColor(theme().hairline);
    painter.setPen(pen);
    painter.drawLine(QPointF(kLineLeft_px, middle), QPointF(kLineRight_px, middle));
    QFont label = labelFont(compact_);
    label.setStrikeOut(compact_ && !shown);  // there is no room for the word
    painter.setFont(label);
    painter.setPen(shown ? theme().ink : theme().dim);
    painter.drawText(QRectF(kTextLeft_px, 0, width() - kTextLeft_px, height()),
                     Qt::AlignLeft | Qt::AlignVCenter, text());
    if (compact_ && state().lost) {
        const QPointF at(width() - kSide_px - 8.0, middle);
        painter.setPen(QPen(theme().alarm, 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolygon(
            QPolygonF({at + QPointF(0, -6), at + QPointF(6.5, 5.5), at + QPointF(-6.5, 5.5)}));
    }
    if (compact_) return;
    painter.setFont(uiFont(13));
    painter.setPen(state().lost ? theme().alarm : theme().dim);
    const QString right = rightText();
    drawFigures(painter, {width() - kSide_px - figuresWidth(painter.font(), right), middle + 4.7},
                right);
}

LegendRow::LegendRow(const std::string& trail, QWidget* parent)
    : QWidget(parent),
      trail_(trail),
      mark_(new PrimaryMark(trail, this)),
      toggle_(new TrailToggle(trail, this)) {
    mark_->setState(state_);
    toggle_->setState(state_);
}

void LegendRow::setTheme(const Theme& theme) {
    mark_->setTheme(theme);
    toggle_->setTheme(theme);
}

void LegendRow::setState(const LegendRowState& state) {
    if (state.shown || state.primary) folded_ = false;
    if (state == state_) return;
    state_ = state;
    mark_->setState(state);
    toggle_->setState(state);
}

void LegendRow::setCompact(bool compact) { toggle_->setCompact(compact); }

QSize LegendRow::sizeHint() const { return {kHeight_px + toggle_->sizeHint().width(), kHeight_px}; }

void LegendRow::resizeEvent(QResizeEvent*) {
    mark_->setGeometry(0, 0, kHeight_px, kHeight_px);
    toggle_->setGeometry(kHeight_px, 0, width() - kHeight_px, kHeight_px);
}

}  // namespace hedr
