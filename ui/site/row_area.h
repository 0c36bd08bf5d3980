#pragma once

#include <QPointer>
#include <QScrollArea>
#include <QTimer>
#include <algorithm>

namespace hedr {

// Scrolls rows where there is no room for all. Wishes to be as high as what it holds, which
// QScrollArea asks for once only.
class RowArea : public QScrollArea {
  public:
    explicit RowArea(QWidget* rows, QWidget* parent) : QScrollArea(parent) {
        setWidget(rows);
        setWidgetResizable(true);
        setFrameShape(QFrame::NoFrame);
        setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        setFocusPolicy(Qt::NoFocus);
    }
    QSize sizeHint() const override { return widget()->sizeHint(); }

    // All rows where there is room, `least` where there is not.
    void setRows(int count, int row_px, int least) {
        setMinimumHeight(std::min(count, least) * row_px);
        setMaximumHeight(count * row_px);
        setVisible(count > 0);
        updateGeometry();
    }

    // Also when there is less room later.
    void keepInSight(QWidget* row) {
        in_sight_ = row;
        scrollSoon();
    }

  protected:
    void resizeEvent(QResizeEvent* event) override {
        QScrollArea::resizeEvent(event);
        scrollSoon();
    }

  private:
    // When the rows have their places.
    void scrollSoon() {
        QTimer::singleShot(0, this, [this] {
            if (in_sight_) ensureWidgetVisible(in_sight_, 0, 0);
        });
    }

    QPointer<QWidget> in_sight_;
};

}  // namespace hedr
