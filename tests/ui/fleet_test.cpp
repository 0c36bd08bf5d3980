#include "ui/fleet.h"

#include <gtest/gtest.h>

#include "tests/ui/scene.h"

namespace hedr {
namespace {

void hear(FleetRobot& robot, const std::string& vehicle) {
    LiveBatch batch = test::sampleBatch(1.0);
    batch.robot = HelloReport{};
    batch.robot->vehicle = vehicle;
    robot.model.apply(batch, test::atSecond(1.0));
}

TEST(Fleet, HasOneRobotFromTheBeginning) {
    Fleet fleet;
    EXPECT_FALSE(fleet.several());
    EXPECT_EQ(fleet.chosen().id, kFirstRobot);
    EXPECT_EQ(fleet.next(), nullptr);
    EXPECT_FALSE(fleet.mayRemove(fleet.chosen()));
    fleet.remove(kFirstRobot);
    EXPECT_EQ(fleet.size(), 1U);
}

TEST(Fleet, TellsEveryRobotByColourAndShape) {
    Fleet fleet;
    for (int i = 0; i < 11; ++i) fleet.add();
    for (const FleetRobot& a : fleet.robots()) {
        for (const FleetRobot& b : fleet.robots()) {
            EXPECT_TRUE(&a == &b || a.mark != b.mark) << a.id << " and " << b.id;
        }
    }
    const RobotMark second = fleet.find(2)->mark;
    fleet.remove(2);
    EXPECT_EQ(fleet.add().mark, second) << "free again";
    EXPECT_EQ(fleet.find(2), nullptr) << "but its number never comes again";
}

TEST(Fleet, NeighboursDifferInBoth) {
    for (std::size_t i = 0; i < 12; ++i) {
        EXPECT_NE(robotMark(i).shape, robotMark(i + 1).shape);
        EXPECT_NE(robotMark(i).colour, robotMark(i + 1).colour);
    }
}

TEST(Fleet, NoTwoRobotsHaveTheSameCallSign) {
    Fleet fleet;
    FleetRobot& first = fleet.chosen();
    FleetRobot& second = fleet.add();
    EXPECT_EQ(fleet.callSign(first), "Robot");
    EXPECT_EQ(fleet.callSign(second), "Robot 2");
    hear(first, "PackBot");
    hear(second, "PackBot");
    EXPECT_EQ(fleet.callSign(first), "PackBot");
    EXPECT_EQ(fleet.callSign(second), "PackBot 2");
    second.call_sign = "Bravo";
    EXPECT_EQ(fleet.callSign(second), "Bravo");
}

TEST(Fleet, TurnsToTheNextAndAroundAgain) {
    Fleet fleet;
    const RobotId second = fleet.add().id;
    const RobotId third = fleet.add().id;
    EXPECT_EQ(fleet.chosen().id, kFirstRobot) << "adding does not choose";
    for (const RobotId expected : {second, third, kFirstRobot}) {
        fleet.choose(fleet.next()->id);
        EXPECT_EQ(fleet.chosen().id, expected);
    }
    fleet.choose(99);
    EXPECT_EQ(fleet.chosen().id, kFirstRobot);
}

TEST(Fleet, KeepsARobotThatIsConnected) {
    Fleet fleet;
    FleetRobot& second = fleet.add();
    hear(second, "PackBot");
    ASSERT_EQ(second.model.last().port, PortState::kOpen);
    fleet.remove(second.id);
    EXPECT_EQ(fleet.size(), 2U);
    fleet.choose(second.id);
    second.model.apply(LiveBatch(), test::atSecond(2.0));
    fleet.remove(second.id);
    EXPECT_EQ(fleet.size(), 1U);
    EXPECT_EQ(fleet.chosen().id, kFirstRobot);
}

TEST(Fleet, AnotherRobotShowsTheTrailsThatTheChosenOneShows) {
    Fleet fleet;
    fleet.chosen().model.choosePrimary("gyro");
    EXPECT_EQ(fleet.add().model.choice(), fleet.chosen().model.choice());
}

}  // namespace
}  // namespace hedr
