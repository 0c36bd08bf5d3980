#include "ui/panels/legend.h"

#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <utility>

#include "ui/fonts.h"
#include "ui/format.h"
#include "ui/icons.h"
#include "ui/panels/legend_row.h"
#include "ui/style_sheet.h"

namespace hedr {
namespace {

constexpr int kTop_px = 34;
constexpr int kSide_px = 8;  // on the right the scroll bar is in it
constexpr int kBottom_px = 4;
constexpr int kIcon_px = 20;

}  // namespace

Legend::Legend(QWidget* parent)
    : Card(parent),
      scroll_(new QScrollArea(this)),
      list_(new QWidget),
      more_(new QPushButton(this)) {
    setAccessibleName(tr("Trails"));
    scroll_->setWidget(list_);
    scroll_->setFrameShape(QFrame::NoFrame);
    scroll_->setFocusPolicy(Qt::NoFocus);
    scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    more_->setFocusPolicy(Qt::TabFocus);
    more_->setToolTip(tr("List the hidden trails too, or not"));
    more_->setIconSize({kIcon_px, kIcon_px});
    connect(more_, &QPushButton::clicked, this, &Legend::toggleMore);
    setTabOrder(scroll_, more_);
    setVisible(false);
}

void Legend::setTheme(const Theme& theme) {
    Card::setTheme(theme);
    for (LegendRow* row : rows_) row->setTheme(theme);
    scroll_->setStyleSheet(scrollSheet(theme));
    more_->setStyleSheet(flatButtonSheet(theme));
    sayHowManyMore();
}

void Legend::show(const FleetRobot& robot, const QString& whose) {
    const LiveModel& model = robot.model;
    const QString title = whose.isEmpty() ? tr("TRAILS") : tr("TRAILS · %1").arg(whose);
    if (std::exchange(title_, title) != title) update();
    const bool same = std::equal(
        rows_.begin(), rows_.end(), model.trails().begin(), model.trails().end(),
        [](const LegendRow* row, const LiveTrail& trail) { return row->trail() == trail.name; });
    if (same) return setStates(robot);
    build(model);
    setStates(robot);
    fold();
    setVisible(!rows_.empty());
}

void Legend::build(const LiveModel& model) {
    for (LegendRow* row : rows_) delete row;
    rows_.clear();
    for (const LiveTrail& trail : model.trails()) {
        auto* row = new LegendRow(trail.name, list_);
        row->setTheme(theme());
        row->setCompact(compact_);
        rows_.push_back(row);
        connect(row->toggle(), &QAbstractButton::clicked, this,
                [this, row] { emit showWished(row->trail(), !row->state().shown); });
        connect(row->mark(), &QAbstractButton::clicked, this,
                [this, row] { emit primaryWished(row->trail()); });
    }
}

void Legend::setStates(const FleetRobot& robot) {
    const LiveModel& model = robot.model;
    bool unfolded = false;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const LiveTrail& trail = model.trails()[i];
        const bool was_folded = rows_[i]->folded();
        rows_[i]->setState(
            {model.isShown(trail), &trail == model.primary(), model.statusOf(trail).lost,
             tr("%1 apart").arg(formatDistance(model.apart_m(trail))), robot.mark.shape});
        unfolded = unfolded || was_folded != rows_[i]->folded();
    }
    if (unfolded) fitToRows();
}

// A row that is hidden by a click stays where it is until then, so that a second click can undo it.
void Legend::fold() {
    for (LegendRow* row : rows_) row->setFolded(!row->state().shown && !row->state().primary);
    fitToRows();
}

void Legend::toggleMore() {
    open_ = !open_;
    open_ ? fitToRows() : fold();
    emit resized();
}

void Legend::setCompact(bool compact) {
    if (compact == compact_) return;
    compact_ = compact;
    for (LegendRow* row : rows_) row->setCompact(compact);
    fitToRows();
}

void Legend::setMostHeight(int most_px) {
    if (most_px == most_height_px_) return;
    most_height_px_ = most_px;
    fitToRows();
}

// As wide as the widest row, listed or not, so that "more" moves nothing aside.
void Legend::fitToRows() {
    int width = 0;
    int height = 0;
    for (LegendRow* row : rows_) {
        width = std::max(width, row->sizeHint().width());
        const bool listed = open_ || !row->folded();
        row->setVisible(listed);
        if (!listed) continue;
        row->move(0, height);
        height += LegendRow::kHeight_px;
    }
    for (LegendRow* row : rows_) row->resize(width, LegendRow::kHeight_px);
    list_->resize(width, height);
    sayHowManyMore();
    const int below = (more_->isVisibleTo(this) ? LegendRow::kHeight_px : 0) + kBottom_px;
    const int list_height = std::clamp(most_height_px_ - kTop_px - below, LegendRow::kHeight_px,
                                       std::max(height, LegendRow::kHeight_px));
    scroll_->setGeometry(kSide_px, kTop_px, width + kSide_px - 1, list_height);
    more_->setGeometry(kSide_px, kTop_px + list_height, width, LegendRow::kHeight_px);
    resize(width + 2 * kSide_px, kTop_px + list_height + below);
}

void Legend::sayHowManyMore() {
    const auto folded = std::count_if(rows_.begin(), rows_.end(),
                                      [](const LegendRow* row) { return row->folded(); });
    more_->setVisible(folded > 0 || open_);
    more_->setText(open_ ? tr("Fewer") : tr("%1 more").arg(folded));
    const QPixmap chevron =
        iconPixmap(QStringLiteral("chevron"), theme().dim, kIcon_px, devicePixelRatioF());
    more_->setIcon(open_ ? chevron.transformed(QTransform::fromScale(1.0, -1.0)) : chevron);
}

void Legend::paintEvent(QPaintEvent* event) {
    Card::paintEvent(event);
    QPainter painter(this);
    painter.setFont(uiFont(13));
    painter.setPen(theme().dim);
    painter.drawText(QPointF(18.0, 27.0),
                     painter.fontMetrics().elidedText(title_, Qt::ElideRight, width() - 2 * 18));
}

void Legend::wheelEvent(QWheelEvent* event) { event->accept(); }

}  // namespace hedr
