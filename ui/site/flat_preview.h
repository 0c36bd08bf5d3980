#pragma once

#include <QPolygonF>
#include <QWidget>
#include <vector>

#include "core/site/survey/rectification.h"
#include "ui/theme.h"

namespace hedr {

// A small picture of what becomes of a photo that is made flat, around the rectangle that is marked
// in it.
class FlatPreview : public QWidget {
    Q_OBJECT

  public:
    explicit FlatPreview(QWidget* parent = nullptr);
    void setTheme(const Theme& theme);
    void setInvertedAtNight(bool inverted) { inverted_at_night_ = inverted; }
    void show(const std::vector<PlanLevel>& photo, const Rectification& rectification,
              const Quad& quad);
    void clear();
    QSize sizeHint() const override;

  signals:
    void resized();  // its picture has another shape now

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    QRectF partAround(const Rectification& rectification, const Quad& quad) const;

    Theme theme_ = dayTheme();
    PlanLevel picture_{};
    QPolygonF rectangle_{};  // in pixels of this widget
    bool inverted_at_night_ = true;
};

}  // namespace hedr
