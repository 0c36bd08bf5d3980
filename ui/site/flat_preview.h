#pragma once

#include <QPolygonF>
#include <QWidget>

#include "core/site/plan.h"
#include "ui/map/view_transform.h"
#include "ui/theme.h"

namespace hedr {

// A small picture of a photo that has been made flat, around the rectangle that was
// marked in it.
class FlatPreview : public QWidget {
    Q_OBJECT

  public:
    explicit FlatPreview(QWidget* parent = nullptr);
    void setTheme(const Theme& theme);
    void show(PlanLevel picture, QPolygonF rectangle, bool inverted_at_night);
    void clear();
    QSize sizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    ViewTransform aroundRectangle() const;

    Theme theme_ = dayTheme();
    PlanLevel picture_{};
    QPolygonF rectangle_{};  // in pixels of the picture
    bool inverted_at_night_ = true;
};

}  // namespace hedr
