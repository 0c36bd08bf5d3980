#include "radio/replay.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include "core/mission/mission_reader.h"

namespace hedr {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kNap{20};

// Wakes up now and then to see whether it shall stop.
void sleepUntil(Clock::time_point end, const StopRequested& stop_requested) {
    while (!stop_requested() && Clock::now() < end) {
        std::this_thread::sleep_until(std::min(end, Clock::now() + kNap));
    }
}

class Pace {
  public:
    Pace(double first_s, double speed) : first_s_(first_s), speed_(speed) {}

    void wait(double time_s, const StopRequested& stop_requested) const {
        const std::chrono::duration<double> due((time_s - first_s_) / speed_);
        sleepUntil(begin_ + std::chrono::duration_cast<Clock::duration>(due), stop_requested);
    }

  private:
    Clock::time_point begin_ = Clock::now();
    double first_s_;
    double speed_;
};

}  // namespace

void replayReports(const std::vector<SensorReport>& reports, SimulatedRobot& robot, RobotLine& line,
                   const ReplayScript& script, const StopRequested& stop_requested) {
    if (reports.empty()) return;
    FaultyRadio radio(script.faults);
    const auto deliver = [&](std::span<const std::uint8_t> bytes) { line.send(bytes); };
    const auto send = [&](std::span<const std::uint8_t> frame) { radio.send(frame, deliver); };
    const double first_s = reports.front().robot_time_s;
    const Pace pace(first_s, script.speed);
    bool to_restart = script.restart_at_s >= 0.0;
    for (const SensorReport& report : reports) {
        pace.wait(report.robot_time_s, stop_requested);
        if (stop_requested()) break;
        if (to_restart && report.robot_time_s - first_s >= script.restart_at_s) {
            to_restart = false;
            robot.restart();
        }
        radio.passTime(report.robot_time_s - first_s, deliver);
        robot.hear(line.receive(), send);
        robot.sense(report, send);
    }
    radio.flush(deliver);
    line.drain();
}

Result<void> replayMission(const std::filesystem::path& mission, RobotLine& line,
                           const ReplayScript& script, const StopRequested& stop_requested) {
    const auto reader = MissionReader::open(mission);
    if (!reader) return tl::make_unexpected(reader.error());
    FaultyRadio radio(script.faults);
    const auto deliver = [&](std::span<const std::uint8_t> bytes) { line.send(bytes); };
    std::optional<Pace> pace;
    double first_s = 0.0;
    auto sent = reader->forEachStreamRow([&](const StreamRow& row) {
        if (!pace) {
            first_s = row.receive_time_s;
            pace.emplace(first_s, script.speed);
        }
        pace->wait(row.receive_time_s, stop_requested);
        radio.passTime(row.receive_time_s - first_s, deliver);
        if (row.kind == StreamKind::kBytes) radio.send(row.data, deliver);
        return !stop_requested();
    });
    radio.flush(deliver);
    line.drain();
    return sent;
}

bool waitForListener(const RobotLine& line, const StopRequested& stop_requested) {
    while (!line.someoneListens() && !stop_requested()) std::this_thread::sleep_for(kNap);
    return line.someoneListens();
}

}  // namespace hedr
