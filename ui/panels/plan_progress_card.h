#pragma once

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include "ui/panels/card.h"

namespace hedr {

// How far the plan is loaded, and a way out.
class PlanProgressCard : public Card {
    Q_OBJECT

  public:
    explicit PlanProgressCard(QWidget* parent = nullptr);
    void setTheme(const Theme& theme) override;
    void setProgress(double progress);  // 0..1

  signals:
    void canceled();

  private:
    QLabel* label_;
    QProgressBar* bar_;
    QPushButton* cancel_;
};

}  // namespace hedr
