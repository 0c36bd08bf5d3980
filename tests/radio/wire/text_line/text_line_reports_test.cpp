#include "radio/wire/text_line/text_line_reports.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <random>

#include "core/geometry/angle.h"
#include "tests/radio/spoken_drive.h"
#include "tests/radio/wire/text_line/text_robot.h"

namespace hedr {
namespace {

using test::hear;
using test::HeardText;
using test::kRecognisedRobot;
using test::spread;

constexpr double kDegree = radFromDeg(1.0);

TEST(TextLineReports, MakesAnAngleOfAnImusHeading) {
    std::string text = "t_ms,yaw_deg\n";
    for (int i = 0; i < 50; ++i) {  // 20 degrees a step, printed from -180 to 180
        text += std::to_string(20 * i) + "," + std::to_string((20 * i + 180) % 360 - 180) + "\n";
    }
    const auto sensors = hear(text).all<SensorReport>();
    ASSERT_EQ(sensors.size(), 48u);
    const auto first = std::get<GyroAngle>(sensors.front().gyro).urad;
    const auto last = std::get<GyroAngle>(sensors.back().gyro).urad;
    EXPECT_NEAR(static_cast<std::int32_t>(last - first), 1e6 * 47 * 20 * kDegree, 1.0);
}

TEST(TextLineReports, ReportsThePoseThatTheRobotPrints) {
    const HeardText heard = hear(
        "t_ms,x_cm,y_cm,theta_deg,gyro_dps\n0,0,0,0,0\n20,1,2,3,0\n"
        "40,100,200,90,4\n");
    ASSERT_EQ(heard.all<PoseReport>().size(), 1u);
    const PoseReport pose = heard.all<PoseReport>()[0];
    EXPECT_EQ(pose.pose, (Pose<World>{{1.0, 2.0}, 90 * kDegree}));
    EXPECT_EQ(pose.robot_time_s, 0.04);
    EXPECT_EQ(pose.yaw_rate_rad_s, 4 * kDegree);
}

TEST(TextLineReports, SaysOnceASecondWhoItIsAndTheBattery) {
    std::string text = "t_ms,left,right,vbat_mv\n";
    for (int i = 0; i < 252; ++i) text += std::to_string(20 * i) + ",1,1,7400\n";
    const HeardText heard = hear(text);
    EXPECT_EQ(heard.all<HelloReport>().size(), 5u);
    ASSERT_EQ(heard.all<StatusReport>().size(), 5u);
    EXPECT_DOUBLE_EQ(heard.all<StatusReport>()[0].battery_v, 7.4);
    EXPECT_EQ(heard.all<SensorReport>().size(), 250u);
}

class NoRobot : public testing::TestWithParam<const char*> {};

TEST_P(NoRobot, IsNotRecognised) {
    std::string text;
    for (int i = 0; i < 20; ++i) text += spread(GetParam());
    const HeardText heard = hear(text);
    EXPECT_FALSE(heard.recognised) << GetParam();
    EXPECT_TRUE(heard.reports.empty());
    EXPECT_EQ(heard.counters.good_frames, 0u);
}

INSTANTIATE_TEST_SUITE_P(
    Lines, NoRobot,
    testing::Values("Hello world",
                    "$GPRMC,12351%,A,4807.038,N,01131.000,E,022.4,084.4,230394,003.1,W", "12,3%,4",
                    "t_ms,left,right", "x:1%, y:2", "Temp: 2%", "speed=%", "ready: %",
                    "[%] boot ok", "left:1%,right:2",
                    "ets Jan  8 2013,rst cause:%, boot mode:(3,6)", "nan,nan,nan",
                    "{\"t\":%,\"left\":1}", "1%\t2\t3", "LABEL,left,right"));

TEST(TextLineReports, NeedsThreeLinesThatAgree) {
    EXPECT_FALSE(hear("t_ms,left,right\n0,1,1\n20,1,1\n").recognised);
    EXPECT_TRUE(hear("t_ms,left,right\n0,1,1\n20,1,1\n40,1,1\n").recognised);
    EXPECT_FALSE(hear("t_ms,left,right\n0,1,1\n20,1,1\n40,1\n60,1,1\n").recognised);
    EXPECT_FALSE(hear("t_ms,left,right\n0,1,1\n20,1,1\n20,1,1\n20,1,1\n").recognised);
}

TEST(TextLineReports, WithoutTimeRefusesAndSaysWhy) {
    const std::string text = "left,right,gyro\n" + spread("%,1,0.1") + spread("3,1,0.1");
    const HeardText heard = hear(text);
    EXPECT_FALSE(heard.recognised);
    EXPECT_EQ(heard.refusal.substr(0, 23), "the lines hold no time:");
    const HeardText nameless = hear(spread("%,2,3"));
    EXPECT_EQ(nameless.refusal.substr(0, 36), "the lines hold numbers, but no heade");
    EXPECT_EQ(hear(kRecognisedRobot).refusal, "");
}

TEST(TextLineReports, CountsLinesForTimeWhereTheVehicleKnowsTheirRate) {
    const HeardText heard = hear("left,right,gyro\n1,1,0\n2,2,0\n3,3,0\nx,4,0\n\x01\n5,5,0\n",
                                 TextLineFormat{.rate_hz = 50.0});
    const auto sensors = heard.all<SensorReport>();
    ASSERT_EQ(sensors.size(), 2u);
    EXPECT_DOUBLE_EQ(sensors[0].robot_time_s, 0.06);
    EXPECT_DOUBLE_EQ(sensors[1].robot_time_s, 0.12);  // the bad lines took their time too
    EXPECT_EQ(sensors[1].odometry, Odometry(WheelTicks{5, 5}));
    EXPECT_EQ(heard.counters.bad_frames, 2u);
}

TEST(TextLineReports, TakesColumnsOfTheVehicleBeforeThoseOfAHeader) {
    const TextLineFormat format{.columns = {"t_us", "right_ticks", "left_ticks", "-"}};
    for (const char* header : {"", "t_ms,left,right,gyro\n", "Zeit,rechts,links,Unfug\n"}) {
        const auto sensors = hear(header + spread("%0000,1,2,abc"), format).all<SensorReport>();
        ASSERT_EQ(sensors.size(), 1u) << header;
        EXPECT_DOUBLE_EQ(sensors[0].robot_time_s, 0.02);
        EXPECT_EQ(sensors[0].odometry, Odometry(WheelTicks{2, 1}));
    }
}

class BadLine : public testing::TestWithParam<const char*> {};

TEST_P(BadLine, IsCountedAndHarmless) {
    const HeardText heard = hear(kRecognisedRobot + GetParam() + "\n80,4,4,0\n");
    EXPECT_EQ(heard.counters.bad_frames, 1u);
    const auto sensors = heard.all<SensorReport>();
    ASSERT_EQ(sensors.size(), 2u);
    EXPECT_EQ(sensors[1].odometry, Odometry(WheelTicks{4, 4}));
    EXPECT_EQ(heard.all<HelloReport>().size(), 1u);
}

INSTANTIATE_TEST_SUITE_P(Lines, BadLine,
                         testing::Values("60,3,3", "60,3,3,0,0", "60,nan,3,0", "60,3,3,nan",
                                         "60,3,3,inf", "60,3,3,ovf", "60,0x10,3,0", "60,3.5,3,0",
                                         "60,3,3,1e999", "60,99999999999999999999,3,0", "60,,3,0",
                                         "nan,3,3,0", "6 0,3,3,0", "60,3,3,0;60,3,3,0", "\x01",
                                         "60,3\x7F,3,0", "!!\xFF\xFE!!", "\xFFxyz", "9999999,3,3,0",
                                         "6x0,3x,3x,0x", "t_ms:60,left:x,right:3"));

TEST(TextLineReports, PassesWordsOnOnlyAfterRecognition) {
    const HeardText heard =
        hear("Robot ready\n" + kRecognisedRobot +
             "# battery low\nobstacle at 5, turning\nMSG,hello you\nBEEP\n60,3,3,0\n");
    const auto events = heard.all<EventReport>();
    ASSERT_EQ(events.size(), 4u);
    EXPECT_EQ(events[1], (EventReport{0.04, "battery low"}));
    EXPECT_EQ(events[2].text, "obstacle at 5, turning");
    EXPECT_EQ(events[3].text, "hello you");
    EXPECT_EQ(heard.counters.bad_frames, 0u);
    EXPECT_EQ(heard.counters.good_frames, 8u);     // the boot message and the header are not
    EXPECT_EQ(heard.counters.unknown_frames, 2u);  // among them
}

TEST(TextLineReports, KeepsHostileWordsShortAndPlain) {
    const HeardText heard =
        hear(kRecognisedRobot + "#" + std::string(500, 'w') + "\n# a\u202Eb\tc\n");
    const auto events = heard.all<EventReport>();
    ASSERT_EQ(events.size(), 3u);
    EXPECT_EQ(events[1].text, std::string(120, 'w'));
    EXPECT_EQ(events[2].text, "ab c");
}

TEST(TextLineReports, JoinsTheWrapOfMicros) {
    std::string text = "t_us,left,right\n";
    for (const char* time : {"4294900000", "4294920000", "4294940000", "4294960000", "12704"}) {
        text += std::string(time) + ",1,1\n";
    }
    const auto sensors = hear(text).all<SensorReport>();
    ASSERT_EQ(sensors.size(), 3u);
    EXPECT_NEAR(sensors[2].robot_time_s - sensors[1].robot_time_s, 0.02, 1e-9);
    EXPECT_EQ(hear(text).all<HelloReport>().back().boot_id, 1u);
}

TEST(TextLineReports, TellsARestartByTheHeader) {
    const HeardText heard = hear(kRecognisedRobot + "60,3,3,0\n" + kRecognisedRobot);
    const auto hellos = heard.all<HelloReport>();
    ASSERT_EQ(hellos.size(), 2u);
    EXPECT_EQ(hellos[1].boot_id, hellos[0].boot_id + 1);
    EXPECT_EQ(heard.all<SensorReport>().size(), 5u);
    EXPECT_EQ(heard.counters.bad_frames, 0u);
}

TEST(TextLineReports, TellsARestartByTheClockAloneAtTheCostOfOneLine) {
    const HeardText heard = hear(
        "t_ms,left,right\n1960,0,0\n1980,0,0\n2000,1,1\n2020,3,3\n0,0,0\n"
        "20,0,0\n40,0,0\n");
    EXPECT_EQ(heard.all<HelloReport>().back().boot_id, 2u);
    EXPECT_EQ(heard.all<SensorReport>().size(), 4u);
    EXPECT_EQ(heard.counters.bad_frames, 1u);
}

TEST(TextLineReports, TakesAHeaderThatIsRepeatedForNoRestart) {
    const HeardText heard = hear(kRecognisedRobot +
                                 "t_ms,left_ticks,right_ticks,gyro_dps\n60,3,3,0\n"
                                 "t_ms,lef#_ticks,right_ticks,gyro_dps\n80,4,4,0\n");
    EXPECT_EQ(heard.all<HelloReport>().size(), 1u);
    const auto sensors = heard.all<SensorReport>();
    ASSERT_EQ(sensors.size(), 3u);
    EXPECT_EQ(sensors[2].odometry, Odometry(WheelTicks{4, 4}));  // the damaged one changed nothing
}

TEST(TextLineReports, StartsAgainWithAnotherHeader) {
    const HeardText heard = hear(kRecognisedRobot + "t_s,dist_m\n1,0\n2,1\n3,2\n4,3\n");
    const auto sensors = heard.all<SensorReport>();
    ASSERT_EQ(sensors.size(), 3u);
    EXPECT_EQ(sensors[2], (SensorReport{4.0, PathTravel{3.0}}));
}

TEST(TextLineReports, GivesTheSameWhereverTheBytesAreCut) {
    const std::string text = "Robot ready\r\n" + kRecognisedRobot +
                             "60,3,3\r\n# gr\u00FCn\r\n\r\n80,4,4,1\r\n" + std::string(600, 'x') +
                             "\n" + kRecognisedRobot;
    const HeardText whole = hear(text);
    EXPECT_EQ(whole.counters.bytes, text.size());
    for (std::size_t piece = 1; piece < 40; ++piece) EXPECT_EQ(hear(text, {}, piece), whole);
}

TEST(TextLineReports, TakesNeitherAMegabyteOfNoiseNorAnotherLanguageForARobot) {
    std::mt19937 random(3);
    std::string noise(1000000, ' ');
    for (char& c : noise) c = static_cast<char>(random() % 256);
    std::string letters(1000000, ' ');
    for (char& c : letters) c = "tleftright_ms0123456789,;:=.- \n"[random() % 32];
    const auto frames = spoken(straightDrive(60.0));
    for (const std::string& heard_text :
         {noise, letters, std::string(frames.begin(), frames.end())}) {
        for (const auto& format :
             {TextLineFormat{},
              TextLineFormat{.columns = {"t_ms", "left_ticks", "right_ticks", "gz"}}}) {
            const HeardText heard = hear(heard_text, format);
            EXPECT_FALSE(heard.recognised);
            EXPECT_TRUE(heard.reports.empty());
        }
    }
}

RC_GTEST_PROP(TextLineReports, NeverTakesNoiseForARobot, ()) {
    const auto bytes = *rc::gen::container<std::string>(rc::gen::arbitrary<char>());
    const HeardText heard = hear(bytes + "\n");
    RC_ASSERT(!heard.recognised);
    RC_ASSERT(heard.reports.empty());
    RC_ASSERT(hear(bytes + "\n", {}, 1) == heard);
}

RC_GTEST_PROP(TextLineReports, BearsWhateverFollowsARobot, ()) {
    const auto text = *rc::gen::container<std::string>(
        rc::gen::elementOf(std::string("0123456789.,;:=-+e \t\n\n\n#tlrxDATAnif_sm\xC3\xBC\xFF")));
    const HeardText heard = hear(kRecognisedRobot + text + "\n");
    RC_ASSERT(heard.recognised);
    for (const SensorReport& sensors : heard.all<SensorReport>()) {
        RC_ASSERT(std::isfinite(sensors.robot_time_s));
    }
    for (const EventReport& event : heard.all<EventReport>()) RC_ASSERT(event.text.size() <= 120u);
    RC_ASSERT(hear(kRecognisedRobot + text + "\n", {}, 3) == heard);
}

}  // namespace
}  // namespace hedr
