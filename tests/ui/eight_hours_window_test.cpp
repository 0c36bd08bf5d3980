// A working day of a robot at 100 Hz in the operator's window, accelerated.
#include <gtest/gtest.h>

#include <QApplication>
#include <algorithm>
#include <iostream>

#include "radio/receiver.h"
#include "tests/radio/long_drive.h"
#include "tests/radio/resident_memory.h"
#include "tests/radio/spoken_drive.h"
#include "tests/ui/scene.h"
#include "ui/main_window.h"

namespace hedr {
namespace {

template <class Work>
double millisecondsOf(Work work) {
    const auto begin = ReceiveClock::now();
    work();
    return std::chrono::duration<double, std::milli>(ReceiveClock::now() - begin).count();
}

struct Day {
    std::vector<double> passes_ms;  // through the event loop; what the operator does waits as long
    double grown_megabytes = 0.0;
    double trails_megabytes = 0.0;
};

double trailMegabytes(const Fleet& fleet) {
    double bytes = 0.0;
    for (const LiveTrail& trail : fleet.chosen().model.trails())
        bytes += static_cast<double>(trail.track.memoryBytes());
    return bytes / 1e6;
}

// What the radio thread would say of one second.
LiveBatch second(Receiver& receiver, SimulatedRobot& robot, LongDrive& drive) {
    for (int i = 0; i < 100; ++i) {
        robot.sense(drive.next(),
                    [&](std::span<const std::uint8_t> frame) { receiver.feed(frame); });
    }
    LiveBatch batch;
    batch.port = PortState::kOpen;
    batch.tracks = receiver.takePoints();
    batch.statuses = receiver.statuses();
    batch.link = receiver.health();
    batch.last_byte = batch.last_frame = ReceiveClock::now();
    batch.link_samples.push_back({.receive_time_s = batch.tracks.front().points.back().t_s});
    return batch;
}

Day driveFor(double hours) {
    MainWindow window;
    window.setPlan(test::samplePlan());
    window.resize(1600, 1000);
    window.show();
    Receiver receiver({});
    SimulatedRobot robot(spokenVehicle(), {});
    LongDrive drive;
    Day day;
    const double before_megabytes = residentMegabytes();
    for (int i = 0; i < static_cast<int>(3600.0 * hours); ++i) {
        const LiveBatch batch = second(receiver, robot, drive);
        day.passes_ms.push_back(millisecondsOf([&] { window.applyBatch(batch); }));
        // The day hurries, frames do not: now and then it waits for one.
        const bool waits = i % 30 == 0;
        const auto until = ReceiveClock::now() + std::chrono::milliseconds(waits ? 20 : 0);
        do {
            day.passes_ms.push_back(millisecondsOf([] { QApplication::processEvents(); }));
        } while (ReceiveClock::now() < until);
    }
    day.grown_megabytes = residentMegabytes() - before_megabytes;
    day.trails_megabytes = trailMegabytes(window.fleet());
    return day;
}

TEST(EightHoursInTheWindow, AnEighthOfAnHourIsNoWork) {
    const Day day = driveFor(0.125);
    EXPECT_GT(day.trails_megabytes, 1.0);
}

// The figures: --gtest_also_run_disabled_tests --gtest_filter='EightHoursInTheWindow.DISABLED*'
TEST(EightHoursInTheWindow, DISABLED_StayResponsive) {
    const Day day = driveFor(8.0);
    const double longest_ms = *std::max_element(day.passes_ms.begin(), day.passes_ms.end());
    const auto frames = std::ranges::count_if(day.passes_ms, [](double ms) { return ms > 0.5; });
    std::cout << "longest pass through the event loop " << longest_ms << " ms, " << frames
              << " of more than half a millisecond; memory grew by " << day.grown_megabytes
              << " MB, trails " << day.trails_megabytes << " MB\n";
    EXPECT_LE(longest_ms, 33.0);
    EXPECT_LE(day.grown_megabytes, 1.2 * day.trails_megabytes + 60.0);
}

}  // namespace
}  // namespace hedr
