#include "radio/wire/mavlink/mavlink_clock.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hedr {
namespace {

constexpr std::uint64_t kNoon_us = 1'767'268'800'000'000;  // of the first of January 2026

TEST(MavlinkClock, CountsSecondsSinceBoot) {
    MavlinkClock clock;
    EXPECT_DOUBLE_EQ(clock.ofBoot_s(1, 12345), 12.345);
    EXPECT_DOUBLE_EQ(clock.ofMicroseconds_s(1, 12'346'789), 12.346789);
    EXPECT_DOUBLE_EQ(clock.latest_s(), 12.346789);
}

TEST(MavlinkClock, GoesOnWhereMillisecondsWrap) {
    MavlinkClock clock;
    EXPECT_DOUBLE_EQ(clock.ofBoot_s(1, 0xFFFFFFFF), 4294967.295);
    EXPECT_DOUBLE_EQ(clock.ofBoot_s(1, 9), 4294967.305);
    EXPECT_DOUBLE_EQ(clock.ofBoot_s(1, 0xFFFFFFF0), 4294967.280);  // overtaken
    EXPECT_DOUBLE_EQ(clock.ofMicroseconds_s(1, 4'294'967'306'000), 4294967.306);
    EXPECT_FALSE(clock.restarted(1));
}

TEST(MavlinkClock, LaysTheUnixClockOnTheBootClock) {
    MavlinkClock clock;
    (void)clock.ofBoot_s(1, 5000);
    EXPECT_DOUBLE_EQ(clock.ofMicroseconds_s(1, kNoon_us), 5.0);
    EXPECT_DOUBLE_EQ(clock.ofMicroseconds_s(1, kNoon_us + 250'001), 5.250001);
    EXPECT_DOUBLE_EQ(clock.ofBoot_s(1, 5300), 5.3);
}

TEST(MavlinkClock, CountsAUnixClockFromZero) {
    MavlinkClock clock;
    EXPECT_DOUBLE_EQ(clock.ofMicroseconds_s(1, kNoon_us), 0.0);
    EXPECT_DOUBLE_EQ(clock.ofMicroseconds_s(1, kNoon_us + 1), 1e-6);
    EXPECT_DOUBLE_EQ(clock.ofBoot_s(1, 77000), 1e-6);
    EXPECT_DOUBLE_EQ(clock.ofBoot_s(1, 78000), 1.000001);
}

TEST(MavlinkClock, KeepsTheBootsOfComponentsApart) {
    MavlinkClock clock;
    (void)clock.ofBoot_s(1, 100'000);
    EXPECT_DOUBLE_EQ(clock.ofBoot_s(191, 40'000), 100.0);
    EXPECT_DOUBLE_EQ(clock.ofBoot_s(1, 100'100), 100.1);
    EXPECT_DOUBLE_EQ(clock.ofBoot_s(191, 40'200), 100.2);
    EXPECT_FALSE(clock.restarted(1) || clock.restarted(191));
}

TEST(MavlinkClock, TellsARestartFromAnOvertaking) {
    MavlinkClock clock;
    (void)clock.ofBoot_s(1, 100'000);
    EXPECT_DOUBLE_EQ(clock.ofBoot_s(1, 98'000), 98.0);
    EXPECT_FALSE(clock.restarted(1));
    (void)clock.ofBoot_s(1, 500);
    EXPECT_TRUE(clock.restarted(1));
    EXPECT_FALSE(clock.restarted(2));
}

TEST(MavlinkClock, StandsAnyStampAndAnyNumberOfClocks) {
    MavlinkClock clock;
    for (unsigned i = 0; i < 256; ++i) {
        (void)clock.ofBoot_s(static_cast<std::uint8_t>(i), i * 0x10101010U);
        (void)clock.ofMicroseconds_s(static_cast<std::uint8_t>(i), ~std::uint64_t{0} << (i % 64));
    }
    EXPECT_GE(clock.latest_s(), 0.0);
}

// Each step back is laid on the latest time, so that it grows without end.
TEST(MavlinkClock, StandsStampsThatLeapToAndFro) {
    MavlinkClock clock;
    (void)clock.ofBoot_s(1, 0);
    for (int i = 0; i < 100; ++i) {
        const double late_s = clock.ofMicroseconds_s(2, ~std::uint64_t{0});
        EXPECT_LE(std::abs(late_s), 1.2e12);
        (void)clock.ofMicroseconds_s(2, std::uint64_t{1} << 50);
        (void)clock.ofMicroseconds_s(2, 999'999'999'999'999);
        EXPECT_LE(std::abs(clock.ofBoot_s(2, 0)), 1.2e12);
    }
}

}  // namespace
}  // namespace hedr
