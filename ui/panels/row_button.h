#pragma once

#include <QAbstractButton>

#include "ui/theme.h"

namespace hedr {

// One line of a list on a card: lights up under the mouse and with the focus.
class RowButton : public QAbstractButton {
    Q_OBJECT

  public:
    explicit RowButton(QWidget* parent);
    void setTheme(const Theme& theme);

  protected:
    const Theme& theme() const { return theme_; }
    void paintGround(QPainter& painter) const;      // below what is painted of the row
    void keyPressEvent(QKeyEvent* event) override;  // only Space is its own

  private:
    Theme theme_ = dayTheme();
};

}  // namespace hedr
