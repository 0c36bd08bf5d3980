#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QWidget>
#include <optional>

#include "ui/site/alignment.h"
#include "ui/theme.h"

namespace hedr {

// Asks for the length of what was clicked on the plan.
class DistancePanel : public QWidget {
    Q_OBJECT

  public:
    explicit DistancePanel(QWidget* parent = nullptr);
    void setTheme(const Theme& theme);
    void show(const Alignment& alignment);

  signals:
    void distanceGiven(double distance_m);

  private:
    void give();

    QLabel* length_;
    QLabel* advice_;
    QLineEdit* field_;
    QPushButton* use_;
};

// "12.5", "12,5", "12.5 m", "250 cm", "41 ft": metres; nothing where it is no length above zero.
std::optional<double> lengthFromText(const QString& text);

}  // namespace hedr
