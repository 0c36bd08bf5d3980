#pragma once

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include "ui/panels/card.h"

namespace hedr {

// How far the work on a plan is, and a way out.
class PlanProgressCard : public Card {
    Q_OBJECT

  public:
    explicit PlanProgressCard(const QString& work, QWidget* parent = nullptr);  // "Loading"
    void setTheme(const Theme& theme) override;
    void setProgress(double progress);  // 0..1

  signals:
    void canceled();

  private:
    QString work_;
    QLabel* label_;
    QProgressBar* bar_;
    QPushButton* cancel_;
};

}  // namespace hedr
