#pragma once

#include <QAbstractButton>
#include <QPushButton>
#include <vector>

#include "ui/fleet.h"
#include "ui/panels/card.h"
#include "ui/panels/status_tiles.h"

namespace hedr {

// What the list says of one robot.
struct RobotEntry {
    RobotId id = kFirstRobot;
    RobotMark mark{};
    QString call_sign{};
    QString state{};  // of its link; of its heading where that is worse
    Tone tone = Tone::kPlain;
    bool chosen = false;
    bool removable = false;
    friend bool operator==(const RobotEntry&, const RobotEntry&) = default;
};

std::vector<RobotEntry> robotEntries(const Fleet& fleet, ReceiveClock::time_point now);

// One robot in the list: a click makes it the chosen one.
class RobotRow : public QAbstractButton {
    Q_OBJECT

  public:
    explicit RobotRow(QWidget* parent);
    void setTheme(const Theme& theme);
    void setEntry(const RobotEntry& entry);
    QSize sizeHint() const override;

  signals:
    void removeWished();

  protected:
    void nextCheckState() override {}
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    Theme theme_ = dayTheme();
    RobotEntry entry_{};
    QPushButton* remove_;
};

// The robots of this window and how well each is heard.
class RobotsCard : public Card {
    Q_OBJECT

  public:
    explicit RobotsCard(QWidget* parent = nullptr);
    void setTheme(const Theme& theme) override;
    void show(const std::vector<RobotEntry>& entries);
    void setLeastWidth(int least_px);  // of a card that it lies above

  signals:
    void robotChosen(hedr::RobotId robot);
    void removeWished(hedr::RobotId robot);
    void addWished();

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    void fitToRows();

    std::vector<RobotEntry> entries_;
    std::vector<RobotRow*> rows_;
    QPushButton* add_;
    int least_width_px_ = 0;
};

}  // namespace hedr
