#include "app/demo_robot.h"

#include <utility>

#include "core/simulation/scenario.h"
#include "radio/replay.h"

namespace hedr {

namespace {

constexpr std::uint64_t kSeed = 7;
constexpr double kSpeed = 10.0;  // a quarter of an hour in one and a half minutes

}  // namespace

Result<std::unique_ptr<DemoRobot>> DemoRobot::start() {
    std::unique_ptr<DemoRobot> demo(new DemoRobot);
    const auto scenario = scenarioByName("packbot-corridors");
    if (!scenario) return tl::make_unexpected(scenario.error());
    SimulatedMission mission = simulate(*scenario, kSeed);
    mission.vehicle.name = "simulated, 10 × as fast";
    const auto written = writeMission(mission, demo->folder_.path().toStdString());
    if (!written) return tl::make_unexpected(written.error());
    auto line = RobotLine::openPseudoTerminal(demo->port().toStdString());
    if (!line) return tl::make_unexpected(line.error());

    const std::atomic<bool>& stop = demo->stop_;
    demo->thread_ =
        std::thread([line = std::move(*line), mission = std::move(mission), &stop]() mutable {
            const auto stopped = [&stop] { return stop.load(); };
            SimulatedRobot robot(mission.vehicle, mission.start);
            if (!waitForListener(line, stopped)) return;
            replayReports(mission.sensors, robot, line, {.speed = kSpeed}, stopped);
        });
    return demo;
}

DemoRobot::~DemoRobot() {
    stop_ = true;
    if (thread_.joinable()) thread_.join();
}

}  // namespace hedr
