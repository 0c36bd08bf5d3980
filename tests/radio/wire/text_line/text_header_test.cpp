// What the names and units of a header make of the numbers below it.
#include <gtest/gtest.h>

#include "core/geometry/angle.h"
#include "radio/wire/text_line/text_line_reports.h"
#include "tests/radio/wire/text_line/text_robot.h"

namespace hedr {
namespace {

using test::hear;
using test::HeardText;
using test::kRecognisedRobot;
using test::spread;

constexpr double kDegree = radFromDeg(1.0);

struct Printed {
    const char* header;
    const char* lines;  // three, see spread()
    SensorReport last;  // of the third
    std::uint16_t capabilities;
};

class TextHeader : public testing::TestWithParam<Printed> {};

TEST_P(TextHeader, GivesColumnsAndScale) {
    const HeardText heard =
        hear(GetParam().header + std::string("\r\n") + spread(GetParam().lines));
    EXPECT_TRUE(heard.recognised) << GetParam().header << ": " << heard.refusal;
    ASSERT_EQ(heard.all<HelloReport>().size(), 1u);
    EXPECT_EQ(heard.all<HelloReport>()[0].capabilities,
              GetParam().capabilities | kCapabilityNoGeometry);
    ASSERT_EQ(heard.all<SensorReport>().size(), 1u);
    EXPECT_EQ(heard.all<SensorReport>()[0], GetParam().last);
    EXPECT_EQ(heard.counters.bad_frames, 0u);
}

INSTANTIATE_TEST_SUITE_P(
    Headers, TextHeader,
    testing::Values(
        Printed{"t_s,left_ticks,right_ticks,gyro_z_rad_s",
                "0.%,10,-11,0.5",
                {0.2, WheelTicks{10, -11}, GyroRate{0.5}},
                1},
        Printed{"t_ms;encL;encR;gz [deg/s]",
                "%0;10;11;2",
                {20 * 1e-3, WheelTicks{10, 11}, GyroRate{2 * kDegree}},
                1},
        Printed{"micros\tLeft Encoder\tRight Encoder",
                "%0000\t10\t11",
                {20000 * 1e-6, WheelTicks{10, 11}},
                0},
        Printed{"time, left_mm, right_mm, temp",
                "%.00, 1500, 1600.5, 21.5",
                {2.0, WheelTravel{1500 * 1e-3, 1600.5 * 1e-3}, {}, 21.5},
                4},
        Printed{"time,left,right", "%0,5.00,6.00", {20 * 1e-3, WheelTicks{5, 6}}, 0},
        Printed{"t,left,right", "%0000,5,6", {20000 * 1e-6, WheelTicks{5, 6}}, 0},
        Printed{
            "t_ms,dist_cm,gyro", "%0,12,0.1", {20 * 1e-3, PathTravel{12 * 1e-2}, GyroRate{0.1}}, 1},
        Printed{"t_ms,x_mm,y_mm,heading_deg,state",
                "%0,1000,2000,90,FORWARD",
                {20 * 1e-3, OdometryPose{1.0, 2.0, 90 * kDegree}},
                0},
        Printed{"t_ms,left,right,mag_x,mag_y,mag_z,",
                "%0,1,2,3,4,5,",
                {20 * 1e-3, WheelTicks{1, 2}, {}, {}, MagneticField{3, 4, 5}},
                2},
        Printed{"seq,t_ms,left,right", "7,%0,1,2", {20 * 1e-3, WheelTicks{1, 2}}, 0},
        Printed{"LABEL,Date,t_ms,left,right", "DATA,DATE,%0,1,2", {20 * 1e-3, WheelTicks{1, 2}}, 0},
        Printed{"LABEL,Date,Time,Timer,ms,left,right",
                "DATA,DATE,TIME,TIMER,%0,1,2",
                {20 * 1e-3, WheelTicks{1, 2}},
                0},
        Printed{"# boot",
                "t_ms:%0,left:1,right:2,gz_dps:3",
                {20 * 1e-3, WheelTicks{1, 2}, GyroRate{3 * kDegree}},
                1},
        Printed{"# boot", "t_ms=%0 left=1 right=2 mode=auto", {20 * 1e-3, WheelTicks{1, 2}}, 0},
        Printed{"# boot", "t_ms: %0\tleft: 1\tright: 2", {20 * 1e-3, WheelTicks{1, 2}}, 0}));

TEST(TextHeaderEvent, TellsHowItReadsTheColumns) {
    const auto events = hear(kRecognisedRobot).all<EventReport>();
    ASSERT_EQ(events.size(), 1u);
    EXPECT_EQ(events[0].text,
              "text lines, read as t_s x 0.001, left_ticks, right_ticks, gyro_z_rad_s x 0.017453");
}

TEST(TextHeaderEvent, TellsWhatItTakesATimeWithoutAUnitFor) {
    for (const auto& [lines, told] : {std::pair{"%0,1,2", "t_s x 0.001, "},
                                      {"%0000,1,2", "t_s x 1e-06, "},
                                      {"%.5,1,2", "t_s, "}}) {
        const auto events = hear("time,left,right\n" + spread(lines)).all<EventReport>();
        ASSERT_EQ(events.size(), 1u);
        EXPECT_TRUE(events[0].text.starts_with("text lines, read as " + std::string(told)))
            << events[0].text;
    }
}

}  // namespace
}  // namespace hedr
