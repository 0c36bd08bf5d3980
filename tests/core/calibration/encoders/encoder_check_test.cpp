#include "core/calibration/encoders/encoder_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/geometry/angle.h"
#include "core/simulation/random.h"
#include "tests/core/calibration/encoders/handled_robot.h"

namespace hedr {
namespace {

using test::checked;
using test::EncoderFaultCase;
using test::EncoderTrouble;
using test::HandledRobot;
using enum EncoderFault;
using enum EncoderSide;

EncoderCheck checkOf(const EncoderTrouble& trouble, std::uint64_t seed = 3) {
    return checked({.name = "", .trouble = trouble}, seed);
}

bool says(const EncoderCheck& check, const std::string& words) {
    return check.calibration.reason.find(words) != std::string::npos;
}

TEST(EncoderCheck, OfAHealthyRobotIsPassed) {
    const EncoderCheck check = checkOf({});
    EXPECT_EQ(check.calibration.verdict, Verdict::kUnchanged);
    EXPECT_TRUE(says(check, "The encoders are right"));
    EXPECT_EQ(check.calibration.progress.share, 1.0);
    EXPECT_TRUE(check.calibration.found.empty());
}

TEST(EncoderCheck, OfAFaultSaysWhatToDo) {
    EXPECT_TRUE(says(checkOf({.swapped = true}), "Exchange the encoders' plugs"));
    EXPECT_TRUE(says(checkOf({.left = -1.0}), "left encoder counts backwards"));
    EXPECT_TRUE(says(checkOf({.right = 0.0}), "Check its plug"));
    EXPECT_TRUE(says(checkOf({.right = 0.5}), "it counts half"));
    for (const EncoderTrouble& trouble :
         {EncoderTrouble{.swapped = true}, EncoderTrouble{.left = -1.0}}) {
        EXPECT_EQ(checkOf(trouble).calibration.verdict, Verdict::kRefused);
    }
}

// A robot with a gyro, whose spin proves what the push found.
EncoderCheck checkWithGyro(const EncoderTrouble& trouble) {
    for (std::uint64_t seed = 1;; ++seed) {
        const EncoderCheck check = checkOf(trouble, seed);
        if (check.tests.spin.has_gyro) return check;
    }
}

TEST(EncoderCheck, FindsTicksPerRevolutionWhereTheFactorIsWhole) {
    const EncoderCheck check = checkWithGyro({.left = 4.0, .right = 4.0});
    ASSERT_EQ(check.calibration.found.size(), 1U);
    const FoundParameter& found = check.calibration.found[0];
    EXPECT_EQ(found.key, "ticks_per_revolution");
    EXPECT_DOUBLE_EQ(found.now.value, 4.0 * *found.was);
    EXPECT_EQ(check.calibration.verdict, Verdict::kAccepted) << check.calibration.reason;
}

TEST(EncoderCheck, FindsTheDiametersWhereItIsNot) {
    const EncoderCheck check = checkWithGyro({.left = 1.3, .right = 1.3});
    ASSERT_EQ(check.calibration.found.size(), 2U);
    for (const FoundParameter& found : check.calibration.found) {
        EXPECT_NEAR(found.now.value, *found.was / 1.3, 0.05 * *found.was);
    }
    EXPECT_EQ(check.calibration.verdict, Verdict::kAccepted) << check.calibration.reason;
}

TEST(EncoderCheck, TellsAWrongTestFromAFault) {
    const auto wrongTest = [](double push_m, double turns) {
        HandledRobot robot(4);
        robot.has_gyro = true;
        robot.push(push_m);
        robot.spin(turns);
        return robot.check().findings.at(0).fault;
    };
    EXPECT_EQ(wrongTest(-1.0, 1.0), kPushedBackwards);
    EXPECT_EQ(wrongTest(1.0, -1.0), kSpunBackwards);
    EXPECT_EQ(wrongTest(1.0, 2.0), kSpunByOtherAngle);
}

// Whoever asked for the other way is not sent the way that he went.
TEST(EncoderCheck, AsksForTheWayThatWasMeant) {
    HandledRobot robot(4);
    robot.has_gyro = true;
    robot.push(1.0);
    robot.spin(1.0);
    const auto advice = [&](double distance_m, double turns) {
        const EncoderCheck check = robot.check({.distance_m = distance_m, .turns = turns});
        return check.findings.empty() ? std::string() : check.findings.front().advice;
    };
    EXPECT_TRUE(advice(-1.0, 1.0).starts_with("Push it backwards"));
    EXPECT_EQ(advice(1.0, -1.0), "Spin it again, clockwise as seen from above.");
}

TEST(EncoderCheck, SaysThatAShortPushShowsNoMissingMagnets) {
    for (const double revolutions : {1.5, 4.0}) {
        HandledRobot robot(4);
        const double distance_m = revolutions * robot.revolution_m();
        robot.push(distance_m);
        robot.spin(1.0);
        EXPECT_EQ(says(robot.check({.distance_m = distance_m}), "not looked for"),
                  revolutions < 2.0);
    }
}

// What the encoders say in something else than a push is no sign of a fault.
TEST(EncoderCheck, TellsADriveFromAPush) {
    HandledRobot driven(4);
    driven.push(60.0);
    driven.spin(1.0);
    const Calibration drive = driven.check().calibration;
    EXPECT_EQ(drive.verdict, Verdict::kRefused);
    EXPECT_NE(drive.reason.find("that was no push by 1 m"), std::string::npos) << drive.reason;
    HandledRobot spun(4);
    spun.has_gyro = true;
    spun.spin(1.0);
    spun.spin(1.0);
    const Calibration spin = spun.check().calibration;
    EXPECT_EQ(spin.verdict, Verdict::kRefused);
    EXPECT_NE(spin.reason.find("while it was pushed"), std::string::npos) << spin.reason;
}

TEST(EncoderCheck, ReadsBothTestsFromOneLog) {
    for (const double gap_s : {0.0, 5.0}) {
        HandledRobot robot(5, {.swapped = true});
        robot.push(1.0);
        robot.spin(1.0);
        SampleSet one;
        for (const SampleSet& set : robot.sets) {
            for (SensorReport report : set.reports) {
                report.robot_time_s += &set == &robot.sets[0] ? 0.0 : gap_s;
                one.reports.push_back(report);
            }
        }
        const EncoderCheck check = checkEncoders(std::vector{one}, robot.believed);
        ASSERT_EQ(check.findings.size(), 1U);
        EXPECT_EQ(check.findings[0].fault, kSwapped);
    }
}

TEST(EncoderCheck, SaysWhatIsNextWhileItGoesOn) {
    HandledRobot robot(6);
    EXPECT_EQ(robot.check().calibration.verdict, Verdict::kRefused);
    robot.push(1.0);
    const EncoderCheck pushed = robot.check();
    EXPECT_EQ(pushed.calibration.verdict, Verdict::kNotProven);
    EXPECT_TRUE(says(pushed, "Now turn it on the spot"));
    EXPECT_EQ(pushed.calibration.progress.share, 0.5);
    const SampleSet push = robot.sets[0];
    for (std::size_t count = 1; count < push.reports.size(); count += 7) {
        SampleSet part;
        part.reports.assign(push.reports.begin(),
                            push.reports.begin() + static_cast<std::ptrdiff_t>(count));
        const EncoderCheck check = checkEncoders(std::vector{part}, robot.believed);
        EXPECT_FALSE(check.calibration.reason.empty());
        EXPECT_EQ(check.calibration.steps.size(), 2U);
    }
}

TEST(EncoderCheck, IsRefusedWhereThereIsNothingToCheck) {
    const auto verdictOf = [](std::vector<SensorReport> reports,
                              const EncoderCheckOptions& options = {}) {
        const EncoderCheck check =
            checkEncoders(std::vector{SampleSet{"", std::move(reports)}}, {}, options);
        EXPECT_FALSE(check.calibration.reason.empty());
        return check.calibration.verdict;
    };
    EXPECT_EQ(verdictOf({}), Verdict::kRefused);
    EXPECT_EQ(verdictOf({{.robot_time_s = 1.0, .gyro = GyroRate{0.1}}}), Verdict::kRefused);
    EXPECT_EQ(verdictOf({{.robot_time_s = 1.0, .odometry = PathTravel{0.1}},
                         {.robot_time_s = 2.0, .odometry = PathTravel{0.2}}}),
              Verdict::kRefused);
    EXPECT_EQ(verdictOf({{.robot_time_s = 1.0, .odometry = WheelTravel{NAN, 0.1}},
                         {.robot_time_s = NAN, .odometry = WheelTravel{0.2, 0.1}}}),
              Verdict::kRefused);
    EXPECT_EQ(verdictOf({}, {.distance_m = 0.0}), Verdict::kRefused);
    std::vector<SensorReport> still;
    for (int i = 0; i < 200; ++i)
        still.push_back({.robot_time_s = 0.05 * i, .odometry = WheelTicks{}});
    EXPECT_EQ(verdictOf(still), Verdict::kNotProven);
}

TEST(EncoderCheck, OfEncodersThatAreSilentInThePush) {
    HandledRobot robot(7);
    robot.push(1.0);
    for (SensorReport& report : robot.sets[0].reports) report.odometry = WheelTicks{};
    robot.spin(1.0);
    const EncoderCheck check = robot.check();
    ASSERT_FALSE(check.findings.empty());
    EXPECT_EQ(check.findings[0].fault, kSilent);
    EXPECT_EQ(check.findings[0].side, kBoth);
}

// Changed for the worse: what it accepts must be nearer to the truth.
TEST(EncoderCheck, NeverAcceptsAWorseRatio) {
    int accepted = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        Random random(1000 + seed);
        const double times = random.uniform() < 0.5 ? random.uniform(0.85, 1.15)
                                                    : std::exp(random.uniform(-2.0, 2.0));
        const EncoderCheck check = checkOf({.left = times,
                                            .right = times,
                                            .wheelbase = random.uniform(0.8, 1.25),
                                            .gyro = random.uniform(0.9, 1.1)},
                                           seed);
        if (check.calibration.verdict != Verdict::kAccepted) continue;
        ++accepted;
        const FoundParameter& found = check.calibration.found[0];
        const double change = found.key == "ticks_per_revolution" ? *found.was / found.now.value
                                                                  : found.now.value / *found.was;
        EXPECT_LT(std::abs(std::log(times * change)), std::abs(std::log(times))) << seed;
    }
    EXPECT_GT(accepted, 50);
}

}  // namespace
}  // namespace hedr
