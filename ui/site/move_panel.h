#pragma once

#include <QLabel>
#include <QPushButton>
#include <QWidget>

#include "core/site/plan.h"
#include "ui/theme.h"

namespace hedr {

// What is done to a plan by hand, in figures, and its quarter turns.
class MovePanel : public QWidget {
    Q_OBJECT

  public:
    explicit MovePanel(QWidget* parent = nullptr);
    void setTheme(const Theme& theme);
    void show(const PlanPlacement& placement);

  signals:
    void turnWished(double angle_rad);

  private:
    QLabel* rotation_;
    QLabel* scale_;
    QPushButton* left_;
    QPushButton* right_;
};

}  // namespace hedr
