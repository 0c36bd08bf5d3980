#pragma once

#include <QPushButton>
#include <map>

#include "ui/panels/card.h"
#include "ui/site/align_method.h"

namespace hedr {

class ChoicesPanel;
class DistancePanel;
class MovePanel;
class PointsPanel;

// The card beside the map while a plan is aligned: a row of methods, and the chosen one's panel.
class AlignCard : public Card {
    Q_OBJECT

  public:
    explicit AlignCard(QWidget* parent = nullptr);
    void setTheme(const Theme& theme) override;
    void setMethod(AlignMethod method);
    void offerStraightening(bool offered);

    PointsPanel& points() { return *points_; }
    DistancePanel& distance() { return *distance_; }
    MovePanel& hand() { return *hand_; }
    ChoicesPanel& choices() { return *choices_; }

  signals:
    void methodChosen(hedr::AlignMethod method);
    void straightenWished();

  private:
    std::map<AlignMethod, QPushButton*> tabs_{};
    PointsPanel* points_;
    DistancePanel* distance_;
    MovePanel* hand_;
    ChoicesPanel* choices_;
    QPushButton* straighten_;
};

}  // namespace hedr
