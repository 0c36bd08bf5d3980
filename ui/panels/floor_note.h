#pragma once

#include <QLabel>
#include <QPushButton>

#include "ui/panels/card.h"

namespace hedr {

// Says that the floor on the map is not the one that the robot is on, with both ways to mend that.
class FloorNote : public Card {
    Q_OBJECT

  public:
    explicit FloorNote(QWidget* parent = nullptr);
    void setTheme(const Theme& theme) override;
    void setFloors(const QString& shown, const QString& of_robot);
    int widthWithin(int width_px) const;

  signals:
    void robotIsHere();
    void backWished();  // to the robot's floor

  private:
    QLabel* text_;
    QPushButton* here_;
    QPushButton* back_;
};

}  // namespace hedr
