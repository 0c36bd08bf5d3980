#include "radio/link/robot_write.h"

#include <gtest/gtest.h>

#include <map>

#include "core/simulation/random.h"

namespace hedr {
namespace {

using State = RobotWrite::State;

const std::vector<ParameterSet> kWishes{{1, 150'100}, {2, 149'900}, {3, 342'000}};
const std::map<std::uint8_t, std::int32_t> kBefore{{1, 150'000}, {2, 150'000}, {3, 340'000}};
const std::map<std::uint8_t, std::int32_t> kAfter{{1, 150'100}, {2, 149'900}, {3, 342'000}};

// A robot that does what it is asked, and what may come of one request.
struct ObedientRobot {
    std::map<std::uint8_t, std::int32_t> values = kBefore;

    RequestProgress answer(const Request& request) {
        if (const auto* get = std::get_if<ParameterGet>(&request))
            return {.wish = request, .state = RequestState::kDone, .value = values.at(get->id)};
        const auto& set = std::get<ParameterSet>(request);
        values[set.id] = set.value;
        return {.wish = request, .state = RequestState::kDone, .value = set.value};
    }
};

// Asks one request; `state` is what comes of it, and unless it is refused the robot may have heard.
void step(RobotWrite& write, ObedientRobot& robot, std::uint64_t ticket,
          RequestState state = RequestState::kDone, bool heard = true) {
    const auto request = write.next();
    if (!request) return;
    write.asked(ticket);
    RequestProgress progress{.wish = *request};
    if (heard && state != RequestState::kRefused) progress = robot.answer(*request);
    progress.ticket = ticket;
    progress.state = state;
    write.hear(progress);
}

void finish(RobotWrite& write, ObedientRobot& robot) {
    for (std::uint64_t ticket = 1000; !write.over() && ticket < 1100; ++ticket) {
        write.linkReturned();
        write.tryAgain();
        step(write, robot, ticket);
    }
}

TEST(RobotWrite, GivesTheRobotAllNewValuesAndComparesThem) {
    RobotWrite write(kWishes);
    ObedientRobot robot;
    finish(write, robot);
    EXPECT_EQ(write.state(), State::kDone);
    EXPECT_EQ(robot.values, kAfter);
    EXPECT_EQ(write.values()[2].before, 340'000);
}

TEST(RobotWrite, WritesNothingWhereTheRobotHasItAlready) {
    RobotWrite write(kWishes);
    ObedientRobot robot{kAfter};
    for (std::uint64_t ticket = 1; !write.over() && ticket < 20; ++ticket) {
        EXPECT_TRUE(std::holds_alternative<ParameterGet>(*write.next()));
        step(write, robot, ticket);
    }
    EXPECT_EQ(write.state(), State::kDone);
}

TEST(RobotWrite, PutsBackWhatWasThereWhenAValueIsRefused) {
    RobotWrite write(kWishes);
    ObedientRobot robot;
    for (std::uint64_t ticket = 1; ticket <= 5; ++ticket) step(write, robot, ticket);
    EXPECT_NE(robot.values, kBefore);
    step(write, robot, 6, RequestState::kRefused);
    EXPECT_EQ(write.state(), State::kPuttingBack);
    finish(write, robot);
    EXPECT_EQ(write.state(), State::kAsBefore);
    EXPECT_EQ(robot.values, kBefore);
    EXPECT_EQ(write.reason(), "The robot refused a value.");
}

TEST(RobotWrite, PutsBackWhenTheLinkIsLostInMidWriteAndComesBack) {
    RobotWrite write(kWishes);
    ObedientRobot robot;
    for (std::uint64_t ticket = 1; ticket <= 4; ++ticket) step(write, robot, ticket);
    step(write, robot, 5, RequestState::kCanceled);  // sent, perhaps heard
    step(write, robot, 6, RequestState::kCanceled, false);
    EXPECT_EQ(write.state(), State::kWaitingForLink);
    EXPECT_FALSE(write.next());
    finish(write, robot);
    EXPECT_EQ(write.state(), State::kAsBefore);
    EXPECT_EQ(robot.values, kBefore);
}

// It is heard all the time, but it moves.
TEST(RobotWrite, TriesAgainLaterWhereTheRobotRefusesWhatItHad) {
    RobotWrite write(kWishes);
    ObedientRobot robot;
    for (std::uint64_t ticket = 1; ticket <= 5; ++ticket) step(write, robot, ticket);
    step(write, robot, 6, RequestState::kRefused);
    step(write, robot, 7, RequestState::kRefused, false);
    EXPECT_EQ(write.state(), State::kWaitingForRobot);
    EXPECT_EQ(write.delay(), "The robot refused a value.");
    EXPECT_FALSE(write.next());
    write.linkReturned();
    EXPECT_FALSE(write.next()) << "the link is not what it waits for";
    write.tryAgain();
    finish(write, robot);
    EXPECT_EQ(write.state(), State::kAsBefore);
    EXPECT_EQ(robot.values, kBefore);
}

TEST(RobotWrite, NoticesARestartOfTheRobotAfterAValueWasRead) {
    RobotWrite write(kWishes);
    ObedientRobot robot;
    for (std::uint64_t ticket = 1; ticket <= 5; ++ticket) step(write, robot, ticket);
    robot.values = kBefore;
    finish(write, robot);
    EXPECT_EQ(write.state(), State::kAsBefore);
    EXPECT_EQ(robot.values, kBefore);
}

TEST(RobotWrite, WritesNothingToARobotThatDoesNotAnswer) {
    RobotWrite write(kWishes);
    ObedientRobot robot;
    step(write, robot, 1);
    step(write, robot, 2, RequestState::kNoAnswer, false);
    EXPECT_EQ(write.state(), State::kAsBefore);
    EXPECT_EQ(write.reason(), "The robot did not answer. Nothing was written.");
}

TEST(RobotWrite, CanceledPutsBack) {
    RobotWrite write(kWishes);
    ObedientRobot robot;
    for (std::uint64_t ticket = 1; ticket <= 4; ++ticket) step(write, robot, ticket);
    write.cancel();
    finish(write, robot);
    EXPECT_EQ(write.state(), State::kAsBefore);
    EXPECT_EQ(robot.values, kBefore);
}

// Whatever happens, the robot has all new values or all old ones, and it is said which.
TEST(RobotWrite, IsAllOrNothingInAThousandTroubledWrites) {
    constexpr std::array kTroubles{RequestState::kRefused, RequestState::kDiffers,
                                   RequestState::kNoAnswer, RequestState::kCanceled};
    Random random(1);
    int done = 0;
    for (int trial = 0; trial < 1000; ++trial) {
        RobotWrite write(kWishes);
        ObedientRobot robot;
        for (std::uint64_t ticket = 1; !write.over() && ticket < 30; ++ticket) {
            const bool trouble = random.uniform() < 0.1;
            const auto kind = kTroubles[static_cast<std::size_t>(random.uniform(0.0, 4.0))];
            if (random.uniform() < 0.03) robot.values = kBefore;  // restarted
            if (random.uniform() < 0.02) write.cancel();
            if (random.uniform() < 0.3) write.linkReturned();
            if (random.uniform() < 0.3) write.tryAgain();
            step(write, robot, ticket, trouble ? kind : RequestState::kDone,
                 random.uniform() < 0.5 || !trouble);
        }
        finish(write, robot);
        ASSERT_TRUE(write.over()) << trial;
        done += write.state() == State::kDone ? 1 : 0;
        EXPECT_EQ(robot.values, write.state() == State::kDone ? kAfter : kBefore) << trial;
        EXPECT_EQ(write.reason().empty(), write.state() == State::kDone) << trial;
    }
    EXPECT_GT(done, 200);
    EXPECT_LT(done, 800);
}

}  // namespace
}  // namespace hedr
