#pragma once

#include <QPushButton>
#include <QScrollArea>
#include <string>
#include <vector>

#include "ui/fleet.h"
#include "ui/panels/card.h"

namespace hedr {

class LegendRow;

// Which trail is which, which of them are shown and which one carries the robot. Trails that are
// hidden wait behind "more".
class Legend : public Card {
    Q_OBJECT

  public:
    explicit Legend(QWidget* parent = nullptr);
    void setTheme(const Theme& theme) override;
    // `whose`: the robot's call sign where there are several.
    void show(const FleetRobot& robot, const QString& whose);
    void setCompact(bool compact);    // for a narrow map: names without distances
    void setMostHeight(int most_px);  // more rows are scrolled

  signals:
    void showWished(const std::string& trail, bool shown);
    void primaryWished(const std::string& trail);
    void resized();

  protected:
    void paintEvent(QPaintEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

  private:
    void build(const LiveModel& model);
    void setStates(const FleetRobot& robot);
    void fold();
    void toggleMore();
    void fitToRows();
    void sayHowManyMore();

    QScrollArea* scroll_;
    QWidget* list_;
    QPushButton* more_;
    std::vector<LegendRow*> rows_;
    QString title_;
    bool open_ = false;
    bool compact_ = false;
    int most_height_px_ = 1 << 20;
};

}  // namespace hedr
