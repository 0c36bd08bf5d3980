#include "ui/calibration/scroll_box.h"

#include <QKeyEvent>
#include <QLayout>
#include <QScrollBar>

namespace hedr {
namespace {

constexpr int kFrame_px = 2;  // of the focus; see calibrationSheet

}  // namespace

ScrollBox::ScrollBox(QWidget* content, QWidget* parent) : QScrollArea(parent) {
    setWidget(content);
    setWidgetResizable(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::NoFocus);
    constexpr int kInset_px = kReach_px - kFrame_px;
    content->layout()->setContentsMargins(kInset_px, kInset_px, kInset_px, kInset_px);
    connect(verticalScrollBar(), &QScrollBar::rangeChanged, this, [this](int, int most) {
        setFocusPolicy(most > 0 ? Qt::StrongFocus : Qt::NoFocus);
        bringIntoSight();
    });
    connect(verticalScrollBar(), &QScrollBar::actionTriggered, this,
            [this] { in_sight_ = nullptr; });
}

QSize ScrollBox::sizeHint() const {
    return widget()->sizeHint() + QSize(2 * kFrame_px, 2 * kFrame_px);
}

void ScrollBox::keepInSight(const QWidget* row) {
    in_sight_ = row;
    bringIntoSight();
}

void ScrollBox::bringIntoSight() {
    if (!in_sight_) return;
    const int top = in_sight_->y();
    const int bottom = in_sight_->geometry().bottom() + 1;
    QScrollBar* bar = verticalScrollBar();
    const int lowest = bottom - viewport()->height();  // of the positions that show all of it
    bar->setValue(qMin(top, qMax(lowest, bar->value())));
}

// Keys that a row leaves over are the card's.
void ScrollBox::keyPressEvent(QKeyEvent* event) {
    hasFocus() ? QScrollArea::keyPressEvent(event) : event->ignore();
}

void ScrollBox::resizeEvent(QResizeEvent* event) {
    QScrollArea::resizeEvent(event);
    bringIntoSight();
}

}  // namespace hedr
