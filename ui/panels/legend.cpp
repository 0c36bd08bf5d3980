#include "ui/panels/legend.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/fonts.h"
#include "ui/format.h"
#include "ui/trail_style.h"

namespace hedr {
namespace {

constexpr double kTextLeft_px = 60.0;
constexpr double kSide_px = 10.0;

}  // namespace

LegendRow::LegendRow(const std::string& name, QWidget* parent)
    : QAbstractButton(parent), name_(name) {
    setCheckable(true);
    setChecked(true);
    setFocusPolicy(Qt::TabFocus);
    setAttribute(Qt::WA_Hover);
    setText(trailLabel(name));
    setAccessibleName(text());
    setToolTip(tr("Show or hide this trail"));
}

void LegendRow::setTheme(const Theme& theme) {
    theme_ = theme;
    update();
}

void LegendRow::setApart(const QString& apart) {
    if (apart == apart_) return;
    apart_ = apart;
    setAccessibleDescription(apart);
    update();
}

void LegendRow::setCompact(bool compact) {
    if (compact == compact_) return;
    compact_ = compact;
    updateGeometry();
    update();
}

QSize LegendRow::sizeHint() const {
    if (compact_) {
        const double label = figuresWidth(uiFont(13, QFont::Medium), text());
        return {static_cast<int>(std::ceil(kTextLeft_px + label + kSide_px)), 26};
    }
    // Room for a distance is kept, so that the card stays still while numbers run.
    const double apart = figuresWidth(uiFont(13), tr("%1 apart").arg(formatDistance(999.9)));
    const double label = figuresWidth(uiFont(15, QFont::Medium), text());
    return {static_cast<int>(std::ceil(kTextLeft_px + label + 24.0 + apart + kSide_px)), 32};
}

void LegendRow::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (underMouse() || hasFocus()) {
        painter.setPen(hasFocus() ? QPen(theme_.accent, 2.0) : QPen(Qt::NoPen));
        painter.setBrush(theme_.chip);
        painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 8.0, 8.0);
    }
    const double middle = height() / 2.0;
    const bool shown = isChecked();
    QPen pen = trailPen(name_, theme_);
    if (!shown) pen.setColor(theme_.hairline);
    painter.setPen(pen);
    painter.drawLine(QPointF(kSide_px, middle), QPointF(kTextLeft_px - 12.0, middle));
    QFont label = uiFont(compact_ ? 13 : 15, QFont::Medium);
    label.setStrikeOut(compact_ && !shown);  // there is no room for the word
    painter.setFont(label);
    painter.setPen(shown ? theme_.ink : theme_.dim);
    painter.drawText(QRectF(kTextLeft_px, 0, width() - kTextLeft_px, height()),
                     Qt::AlignLeft | Qt::AlignVCenter, text());
    if (compact_) return;
    painter.setFont(uiFont(13));
    painter.setPen(theme_.dim);
    const QString right = shown ? apart_ : tr("hidden");
    drawFigures(painter, {width() - kSide_px - figuresWidth(painter.font(), right), middle + 4.7},
                right);
}

Legend::Legend(QWidget* parent) : Card(parent), column_(new QVBoxLayout(this)) {
    setAccessibleName(tr("Trails"));
    for (const TrailStyle& style : trailStyles()) {
        if (!style.shown_at_first) hidden_.insert(style.name);
    }
    column_->setContentsMargins(8, 36, 8, 10);
    column_->setSpacing(0);
    setVisible(false);
}

void Legend::setTheme(const Theme& theme) {
    Card::setTheme(theme);
    for (LegendRow* row : rows_) row->setTheme(theme);
}

void Legend::show(const LiveModel& model) {
    const bool same = std::equal(
        rows_.begin(), rows_.end(), model.trails().begin(), model.trails().end(),
        [](const LegendRow* row, const LiveTrail& trail) { return row->name() == trail.name; });
    if (!same) build(model);
    for (std::size_t i = 1; i < rows_.size(); ++i) {
        rows_[i]->setApart(tr("%1 apart").arg(formatDistance(model.apart_m(model.trails()[i]))));
    }
}

void Legend::build(const LiveModel& model) {
    for (LegendRow* row : rows_) delete row;
    rows_.clear();
    for (const LiveTrail& trail : model.trails()) {
        auto* row = new LegendRow(trail.name, this);
        row->setTheme(theme());
        row->setCompact(compact_);
        row->setChecked(!hidden_.contains(trail.name));
        column_->addWidget(row);
        row->setVisible(true);  // Qt shows it only later on a card in sight, too late to be counted
        rows_.push_back(row);
        connect(row, &QAbstractButton::toggled, this,
                [this, name = trail.name](bool shown) { setTrailHidden(name, !shown); });
        emit trailHidden(trail.name, !row->isChecked());
    }
    setVisible(!rows_.empty());
    fitToRows();
}

void Legend::setCompact(bool compact) {
    if (compact == compact_) return;
    compact_ = compact;
    for (LegendRow* row : rows_) row->setCompact(compact);
    fitToRows();
}

void Legend::fitToRows() {
    column_->activate();
    resize(column_->sizeHint());
}

void Legend::setTrailHidden(const std::string& name, bool hidden) {
    if (hidden) {
        hidden_.insert(name);
    } else {
        hidden_.erase(name);
    }
    emit trailHidden(name, hidden);
}

void Legend::paintEvent(QPaintEvent* event) {
    Card::paintEvent(event);
    QPainter painter(this);
    painter.setFont(uiFont(13));
    painter.setPen(theme().dim);
    painter.drawText(QPointF(18.0, 27.0), tr("TRAILS"));
}

}  // namespace hedr
