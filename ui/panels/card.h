#pragma once

#include <QWidget>

#include "ui/theme.h"

namespace hedr {

// A rounded sheet that lies on the map.
class Card : public QWidget {
    Q_OBJECT

  public:
    explicit Card(QWidget* parent = nullptr);
    virtual void setTheme(const Theme& theme);

  protected:
    const Theme& theme() const { return theme_; }
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;  // the map below must not be dragged

  private:
    Theme theme_ = dayTheme();
};

}  // namespace hedr
