// The example sketches on a pretended Arduino: what they print is decoded, and gives the drive that
// its encoders made.
#include <gtest/gtest.h>

#include <cmath>

#include "core/geometry/angle.h"
#include "core/robot/motion.h"
#include "radio/wire/codec.h"
#include "radio/wire/frame_decoder.h"
#include "tests/radio/firmware/arduino_host/Arduino.h"
#include "tests/radio/firmware/arduino_host/sketches.h"
#include "tests/radio/wire/text_line/text_robot.h"

namespace hedr {
namespace {

Vehicle sketchVehicle() {
    Vehicle vehicle;
    vehicle.geometry = {0.065, 0.065, 0.15, 360.0};
    return vehicle;
}

constexpr double kSpeed_m_s = 0.2;
constexpr double kTurnSpeed_m_s = 0.15 / 2 * 64 * radFromDeg(0.48828);  // 64 counts of the gyro

// Wheel speeds at a time: stands 6 s, 2 m straight, a quarter turn to the left, 1 m straight,
// stands.
std::pair<double, double> wheelSpeeds(double t_s) {
    const double turn_s = 90.0 / (64 * 0.48828);
    if (t_s < 6.0) return {0.0, 0.0};
    if (t_s < 16.0) return {kSpeed_m_s, kSpeed_m_s};
    if (t_s < 16.0 + turn_s) return {-kTurnSpeed_m_s, kTurnSpeed_m_s};
    if (t_s < 21.0 + turn_s) return {kSpeed_m_s, kSpeed_m_s};
    return {0.0, 0.0};
}

// A wheel with its encoder on two pins.
struct Encoder {
    std::uint8_t pin_a;
    std::uint8_t pin_b;
    double travel_m = 0.0;
    std::int64_t ticks = 0;

    void turn(double by_m) {
        travel_m += by_m;
        const auto now = static_cast<std::int64_t>(std::floor(travel_m / (kPi * 0.065) * 360.0));
        while (ticks != now) {
            const int step = now > ticks ? 1 : -1;
            arduinoHost().pins[pin_b] = step > 0 ? 1 : 0;
            arduinoHost().on_rise[pin_a]();
            ticks += step;
        }
    }
};

struct Driven {
    std::string printed;
    std::int64_t left = 0;
    std::int64_t right = 0;
};

Driven drive(void (*setup)(), void (*loop)(), std::span<const std::uint8_t> request = {}) {
    arduinoHost() = {};
    arduinoHost().received.assign(request.begin(), request.end());
    arduinoHost().pins[A0] = 512;
    setup();
    Encoder left{.pin_a = 2, .pin_b = 4};
    Encoder right{.pin_a = 3, .pin_b = 5};
    constexpr double kStep_s = 1e-3;
    for (int i = 0; i < 26000; ++i) {
        const auto [v_left, v_right] = wheelSpeeds(kStep_s * i);
        left.turn(v_left * kStep_s);
        right.turn(v_right * kStep_s);
        arduinoHost().pins[A0] = v_left < 0.0 ? 512 + 64 : 512;
        arduinoHost().time_us += 1000;
        loop();
    }
    EXPECT_TRUE(arduinoHost().interrupts_on);
    return {arduinoHost().printed, left.ticks, right.ticks};
}

// Dead reckoning over what was heard: its wheels' way, its gyro's heading.
Pose<World> reckon(const std::vector<SensorReport>& sensors) {
    MotionBuilder motions(sketchVehicle());
    Pose<World> pose{};
    for (const SensorReport& each : sensors) {
        const auto motion = motions.add(each);
        if (!motion) continue;
        const double turn = motion->gyro_turn_rad.value_or(0.0);
        const double middle = pose.heading_rad + 0.5 * turn;
        pose.position.x += motion->distance_m * std::cos(middle);
        pose.position.y += motion->distance_m * std::sin(middle);
        pose.heading_rad += turn;
    }
    EXPECT_EQ(motions.brokenSamples(), 0u);
    EXPECT_EQ(motions.restarts(), 0u);
    return pose;
}

void expectTheDrive(const Pose<World>& pose) {
    EXPECT_NEAR(pose.position.x, 2.0, 0.02);
    EXPECT_NEAR(pose.position.y, 1.0, 0.02);
    EXPECT_NEAR(degFromRad(pose.heading_rad), 90.0, 1.0);
}

TEST(ExampleSketches, ThatPrintsLinesGivesTheDriveItMade) {
    const Driven driven = drive(text_sketch::setup, text_sketch::loop);
    const test::HeardText heard = test::hear(driven.printed);
    EXPECT_TRUE(heard.recognised);
    EXPECT_EQ(heard.counters.bad_frames, 0u);
    const auto sensors = heard.all<SensorReport>();
    ASSERT_EQ(sensors.size(), 1298u);  // 26 s of 50 lines, without the two that came first
    EXPECT_EQ(sensors.back().odometry, Odometry(WheelTicks{driven.left, driven.right}));
    expectTheDrive(reckon(sensors));
}

TEST(ExampleSketches, ThatSpeaksTheProtocolGivesTheDriveItMade) {
    const Driven driven = drive(hedr_sketch::setup, hedr_sketch::loop);
    std::vector<SensorReport> sensors;
    std::vector<PoseReport> poses;
    int hellos = 0;
    FrameDecoder decoder;
    decoder.feed(test::bytesOf(driven.printed), [&](const Frame& frame) {
        const auto report = decodeReport(frame);
        ASSERT_TRUE(report);
        if (const auto* s = std::get_if<SensorReport>(&*report)) sensors.push_back(*s);
        if (const auto* p = std::get_if<PoseReport>(&*report)) poses.push_back(*p);
        hellos += std::holds_alternative<HelloReport>(*report) ? 1 : 0;
    });
    EXPECT_EQ(decoder.counters().bad_frames, 0u);
    EXPECT_EQ(hellos, 26);
    ASSERT_EQ(sensors.size(), 1300u);
    EXPECT_EQ(sensors.back().odometry, Odometry(WheelTicks{driven.left, driven.right}));
    expectTheDrive(reckon(sensors));
    ASSERT_EQ(poses.size(), 650u);
    expectTheDrive(poses.back().pose);
}

TEST(ExampleSketches, ThatSpeaksTheProtocolAnswersRequests) {
    const FrameBytes request = encodeRequest(TimeRequest{.token = 0xDEADBEEF}, 1);
    const Driven driven = drive(hedr_sketch::setup, hedr_sketch::loop, request.view());
    std::vector<std::uint32_t> tokens;
    FrameDecoder decoder;
    decoder.feed(test::bytesOf(driven.printed), [&](const Frame& frame) {
        const auto report = decodeReport(frame);
        if (const auto* echo = report ? std::get_if<TimeEchoReport>(&*report) : nullptr) {
            tokens.push_back(echo->token);
        }
    });
    EXPECT_EQ(tokens, std::vector<std::uint32_t>{0xDEADBEEF});
}

}  // namespace
}  // namespace hedr
