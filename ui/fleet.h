#pragma once

#include <QString>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <list>

#include "ui/link/link_alarm.h"
#include "ui/link/request_board.h"
#include "ui/live_model.h"
#include "ui/robot_mark.h"

namespace hedr {

using RobotId = std::uint32_t;
inline constexpr RobotId kFirstRobot = 1;

struct FleetRobot {
    RobotId id = kFirstRobot;
    RobotMark mark{};
    QString call_sign{};  // the operator's; empty: as the robot calls itself
    LiveModel model{};
    RequestBoard requests{};
    LinkAlarm alarm{};
};

// The robots of one window, at least one, in the order of their coming. What the window says and
// asks beside the map is about the chosen one.
class Fleet {
  public:
    Fleet();  // with one robot, which is not connected yet

    const std::list<FleetRobot>& robots() const { return robots_; }
    std::list<FleetRobot>& robots() { return robots_; }
    std::size_t size() const { return robots_.size(); }
    bool several() const { return robots_.size() > 1; }
    // Of the map, and of what the links tell. Who looks at several robots does not see the
    // difference between sixty and thirty frames a second; the processor does.
    std::chrono::milliseconds framePeriod() const {
        return std::chrono::milliseconds(several() ? 33 : 16);
    }
    const FleetRobot& chosen() const { return *chosen_; }
    FleetRobot& chosen() { return *chosen_; }
    const FleetRobot* next() const;            // after the chosen one; nullptr: it is alone
    FleetRobot* find(RobotId id);              // nullptr: it has been removed
    const FleetRobot* find(RobotId id) const;  // the same

    FleetRobot& add();  // with the trails that the chosen one shows
    void choose(RobotId id);
    // The last one stays, and so does one that is connected.
    bool mayRemove(const FleetRobot& robot) const;
    void remove(RobotId id);

    void setTrailChoice(const TrailChoice& choice);
    // No two robots have the same one.
    QString callSign(const FleetRobot& robot) const;

  private:
    std::size_t freeMark() const;

    std::list<FleetRobot> robots_;
    FleetRobot* chosen_;
    RobotId last_id_ = kFirstRobot;
};

}  // namespace hedr
