#pragma once

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <optional>

#include "ui/panels/card.h"

namespace hedr {

// The card of the corridors page: the direction, who told it, and two ways to another one.
class CorridorsCard : public Card {
    Q_OBJECT

  public:
    explicit CorridorsCard(QWidget* parent);
    void setTheme(const Theme& theme) override;
    void show(std::optional<double> direction_rad, const QString& advice);
    void setProgress(std::optional<double> share);  // 0..1: walls are being looked for
    void offerPlan(bool offered);                   // there is one to look at

  signals:
    void planWished();
    void noneWished();

  private:
    QLabel* direction_;
    QLabel* advice_;
    QProgressBar* bar_;
    QPushButton* plan_;
    QPushButton* none_;
};

}  // namespace hedr
