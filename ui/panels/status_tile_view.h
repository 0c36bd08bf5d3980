#pragma once

#include <QWidget>

#include "ui/fonts.h"
#include "ui/panels/status_tiles.h"
#include "ui/theme.h"

namespace hedr {

// One tile of the status strip. Its words are its accessible text.
class StatusTileView : public QWidget {
    Q_OBJECT

  public:
    explicit StatusTileView(QWidget* parent = nullptr);
    void setTheme(const Theme& theme);
    bool setTile(const StatusTile& tile);  // whether it needs another width now
    void setValueSize(int value_px);
    int neededWidth(int value_px) const;  // for the value and the first part of the detail
    int wantedWidth(int value_px) const;  // for all of it

    // A tile with details behind it can be clicked.
    void setClickable(bool clickable);

  signals:
    void clicked();

  protected:
    void mousePressEvent(QMouseEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

  private:
    void paintMark(QPainter& painter, const QPointF& centre, const QColor& colour) const;
    QString detailWithin(double width);
    bool measureAfter(const StatusTile& before);

    Theme theme_ = dayTheme();
    StatusTile tile_;
    FigureType detail_type_;
    int value_px_ = 25;
    FigureType value_type_;
    double value_width_ = 0.0;  // the widest so far, for one pixel of type size
    double label_width_ = 0.0;
    double detail_width_ = 0.0;
    bool clickable_ = false;
};

}  // namespace hedr
