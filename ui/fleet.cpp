#include "ui/fleet.h"

#include <QCoreApplication>
#include <algorithm>
#include <iterator>

namespace hedr {
namespace {

QString ownName(const FleetRobot& robot) {
    if (!robot.call_sign.isEmpty()) return robot.call_sign;
    const auto& hello = robot.model.last().robot;
    const QString name = hello ? QString::fromStdString(hello->vehicle).trimmed() : QString();
    return name.isEmpty() ? QCoreApplication::translate("Fleet", "Robot") : name;
}

auto withId(RobotId id) {
    return [id](const FleetRobot& robot) { return robot.id == id; };
}

}  // namespace

Fleet::Fleet() : robots_(1), chosen_(&robots_.front()) {}

const FleetRobot* Fleet::find(RobotId id) const {
    const auto found = std::ranges::find_if(robots_, withId(id));
    return found == robots_.end() ? nullptr : &*found;
}

FleetRobot* Fleet::find(RobotId id) {
    const auto found = std::ranges::find_if(robots_, withId(id));
    return found == robots_.end() ? nullptr : &*found;
}

const FleetRobot* Fleet::next() const {
    if (!several()) return nullptr;
    const auto after = std::next(std::ranges::find_if(robots_, withId(chosen_->id)));
    return after == robots_.end() ? &robots_.front() : &*after;
}

FleetRobot& Fleet::add() {
    const RobotMark mark = robotMark(freeMark());
    FleetRobot& robot = robots_.emplace_back();
    robot.id = ++last_id_;
    robot.mark = mark;
    robot.model.setChoice(chosen_->model.choice());
    return robot;
}

// The first that no robot has, so that one that came again looks like before.
std::size_t Fleet::freeMark() const {
    const auto taken = [this](std::size_t place) {
        return std::ranges::any_of(
            robots_, [&](const FleetRobot& robot) { return robot.mark == robotMark(place); });
    };
    std::size_t place = 0;
    while (place < robots_.size() && taken(place)) ++place;
    return place;
}

void Fleet::choose(RobotId id) {
    if (FleetRobot* robot = find(id)) chosen_ = robot;
}

bool Fleet::mayRemove(const FleetRobot& robot) const {
    return several() && robot.model.last().port == PortState::kClosed;
}

void Fleet::remove(RobotId id) {
    const FleetRobot* robot = find(id);
    if (!robot || !mayRemove(*robot)) return;
    const bool was_chosen = robot == chosen_;
    std::erase_if(robots_, withId(id));
    if (was_chosen) chosen_ = &robots_.front();
}

void Fleet::setTrailChoice(const TrailChoice& choice) {
    for (FleetRobot& robot : robots_) robot.model.setChoice(choice);
}

QString Fleet::callSign(const FleetRobot& robot) const {
    const QString name = ownName(robot);
    const auto earlier = std::ranges::count_if(robots_, [&](const FleetRobot& other) {
        return other.id < robot.id && ownName(other) == name;
    });
    return earlier == 0 ? name : QStringLiteral("%1 %2").arg(name).arg(earlier + 1);
}

}  // namespace hedr
