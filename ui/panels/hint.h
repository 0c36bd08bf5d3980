#pragma once

#include <QAbstractButton>

#include "ui/theme.h"

namespace hedr {

// What an empty map asks for. A click asks for a plan.
class Hint : public QAbstractButton {
    Q_OBJECT

  public:
    explicit Hint(QWidget* parent = nullptr);
    void setTheme(const Theme& theme);
    QSize sizeHint() const override { return {440, 220}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    Theme theme_ = dayTheme();
};

}  // namespace hedr
