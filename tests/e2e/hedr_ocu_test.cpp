// hedr-ocu as a process of its own, its robot on a pseudo-terminal.
#include <gtest/gtest.h>
#include <signal.h>

#include <QFile>
#include <QImage>
#include <QRandomGenerator>
#include <QTemporaryDir>
#include <QtTest/QTest>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>

#include "core/mission/mission_reader.h"
#include "radio/recomputation.h"
#include "radio/replay.h"
#include "tests/e2e/program.h"
#include "tests/radio/spoken_drive.h"

namespace hedr {
namespace {

using Clock = std::chrono::steady_clock;

// Drives on, and remembers when it had said how many bytes.
class CountingRobot {
  public:
    explicit CountingRobot(const QString& port)
        : line_(RobotLine::openPseudoTerminal(port.toStdString()).value()),
          thread_([this] { talk(); }) {}
    ~CountingRobot() {
        stop_ = true;
        thread_.join();
    }

    std::uint64_t bytesSaidBefore(Clock::time_point moment) {
        const std::lock_guard lock(mutex_);
        std::uint64_t bytes = 0;
        for (const auto& [time, total] : said_) {
            if (time <= moment) bytes = total;
        }
        return bytes;
    }

    // How long before `moment` it said the first of what is not among its first `bytes`.
    double unheardBefore_s(Clock::time_point moment, std::uint64_t bytes) {
        const std::lock_guard lock(mutex_);
        for (const auto& [time, total] : said_) {
            if (total > bytes)
                return std::max(0.0, std::chrono::duration<double>(moment - time).count());
        }
        return 0.0;
    }

  private:
    void talk() {
        const auto reports = straightDrive(600.0);
        SimulatedRobot robot(spokenVehicle(), {});
        const auto stopped = [this] { return stop_.load(); };
        if (!waitForListener(line_, stopped)) return;
        std::uint64_t total = 0;
        const auto send = [&](std::span<const std::uint8_t> frame) {
            if (!line_.someoneListens()) return;
            line_.send(frame);
            total += frame.size();
        };
        for (const SensorReport& report : reports) {
            if (stop_) return;
            robot.sense(report, send);
            const std::lock_guard lock(mutex_);
            said_.emplace_back(Clock::now(), total);
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
    }

    RobotLine line_;
    std::mutex mutex_;
    std::vector<std::pair<Clock::time_point, std::uint64_t>> said_;
    std::atomic<bool> stop_{false};
    std::thread thread_;
};

std::uint64_t recordedBytes(const std::filesystem::path& mission) {
    const auto reader = MissionReader::open(mission);
    if (!reader) return 0;
    std::uint64_t bytes = 0;
    (void)reader->forEachStreamRow([&](const StreamRow& row) {
        if (row.kind == StreamKind::kBytes) bytes += row.data.size();
        return true;
    });
    return bytes;
}

void killAtAnyMoment(int rounds) {
    double longest_s = 0.0;
    for (int round = 0; round < rounds; ++round) {
        const QTemporaryDir folder;
        const QString port = folder.filePath("robot");
        const std::filesystem::path mission = folder.filePath("m.hedr").toStdString();
        CountingRobot robot(port);
        QProcess ocu;
        ocu.start(kHedrOcu, {"--port", port, "--out", folder.filePath("m.hedr")});
        ASSERT_TRUE(ocu.waitForStarted());
        ASSERT_TRUE(QTest::qWaitFor([&] { return std::filesystem::exists(mission); }, 20000));
        QTest::qWait(QRandomGenerator::global()->bounded(2400));
        const auto killed = Clock::now();
        ::kill(static_cast<pid_t>(ocu.processId()), SIGKILL);
        ASSERT_TRUE(ocu.waitForFinished(5000));
        const std::uint64_t recorded = recordedBytes(mission);
        longest_s = std::max(longest_s, robot.unheardBefore_s(killed, recorded));
        EXPECT_GE(recorded, robot.bytesSaidBefore(killed - std::chrono::seconds(1)))
            << "round " << round;
        EXPECT_EQ(run(kHedrTool, {"info", QString::fromStdString(mission.string())}).exit_code, 0);
    }
    std::cout << "killed " << rounds << " times: at most " << longest_s << " s lost\n";
}

TEST(HedrOcu, KilledAtAnyMomentLosesAtMostASecond) { killAtAnyMoment(20); }

TEST(HedrOcu, DISABLED_KilledTwoHundredTimesLosesAtMostASecond) { killAtAnyMoment(200); }

TEST(HedrOcu, LeavesAScreenshotAndAMission) {
    const QTemporaryDir folder;
    CountingRobot robot(folder.filePath("robot"));
    const Outcome outcome =
        run(kHedrOcu,
            {"--port", folder.filePath("robot"), "--out", folder.filePath("m.hedr"), "--screenshot",
             folder.filePath("shot.png"), "--after", "3", "--exit-after", "4"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err.toStdString();
    EXPECT_FALSE(QImage(folder.filePath("shot.png")).isNull());
    const auto track = recomputeTrack(folder.filePath("m.hedr").toStdString(), "hedr", {});
    ASSERT_TRUE(track);
    EXPECT_TRUE(track->as_live);
}

TEST(HedrOcu, EndsAfterItsScreenshotUnlessToldWhen) {
    const QTemporaryDir folder;
    const Outcome outcome =
        run(kHedrOcu, {"--screenshot", folder.filePath("shot.png"), "--after", "0.2"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err.toStdString();
    EXPECT_FALSE(QImage(folder.filePath("shot.png")).isNull());
}

TEST(HedrOcu, EndsWithOneWhereTheScreenshotCannotBeWritten) {
    const Outcome outcome = run(
        kHedrOcu, {"--screenshot", "/nowhere/picture.png", "--after", "0.1", "--exit-after", "1"});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_TRUE(outcome.err.contains("/nowhere/picture.png")) << outcome.err.toStdString();
}

TEST(HedrOcu, SaysWhatIsWrongWithAPlanAndGoesOn) {
    const QTemporaryDir folder;
    QFile plan(folder.filePath("plan.png"));
    ASSERT_TRUE(plan.open(QIODevice::WriteOnly));
    plan.write("this is not a picture");
    plan.close();
    const Outcome outcome = run(kHedrOcu, {"--plan", plan.fileName(), "--exit-after", "2"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_TRUE(outcome.err.contains("plan.png")) << outcome.err.toStdString();
}

TEST(HedrOcu, EndsWithOneForABadVehicle) {
    const Outcome outcome = run(kHedrOcu, {"--vehicle", "/nowhere/v.toml", "--exit-after", "1"});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_TRUE(outcome.err.contains("/nowhere/v.toml")) << outcome.err.toStdString();
}

TEST(HedrOcu, NeedsNoScreenForHelpAndSaysThatAWindowDoes) {
    QProcessEnvironment bare = QProcessEnvironment::systemEnvironment();
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}) bare.remove(name);
    const QTemporaryDir folder;
    for (const auto& [arguments, exit_code] :
         {std::pair{QStringList{"--help"}, 0},
          {QStringList{}, 1},
          {{"--exit-after", "1"}, 0},
          {{"--screenshot", folder.filePath("shot.png"), "--after", "0.1"}, 0}}) {
        QProcess ocu;
        ocu.setProcessEnvironment(bare);
        ocu.start(kHedrOcu, arguments);
        ASSERT_TRUE(ocu.waitForFinished(20000));
        EXPECT_EQ(ocu.exitCode(), exit_code) << arguments.join(' ').toStdString();
    }
}

struct Recording {
    const char* name;
    double speed;
    double limit_m;
};

void PrintTo(const Recording& recording, std::ostream* out) { *out << recording.name; }

class HedrOcuWithRealRobot : public ::testing::TestWithParam<Recording> {
  protected:
    static double rms_m(const QString& track, const QString& truth) {
        const Outcome judged =
            run(kHedrTool, {"evaluate", track, "--truth", truth, "--align", "start", "--json"});
        return nlohmann::json::parse(judged.out.toStdString()).at("ape_rmse_m");
    }
};

// The recorded drive over the serial code path; recorded, computed again, and compared with the
// log.
TEST_P(HedrOcuWithRealRobot, FollowsItWithinTheBound) {
    const QString data =
        QStringLiteral(HEDR_SOURCE_DIR "/../shared/data/") + QString(GetParam().name) + "/";
    if (!QFile::exists(data + "sensors.csv")) {
        GTEST_SKIP() << "the recording " << GetParam().name << " is not on this machine";
    }
    const QTemporaryDir folder;
    const QString mission = folder.filePath("m.hedr");
    QProcess robot;
    robot.start(kHedrTool,
                {"replay", data + "sensors.csv", "--vehicle", data + "vehicle.toml", "--pty",
                 folder.filePath("robot"), "--speed", QString::number(GetParam().speed)});
    ASSERT_TRUE(QTest::qWaitFor([&] { return QFile::exists(folder.filePath("robot")); }, 10000));
    QProcess ocu;
    ocu.start(kHedrOcu, {"--port", folder.filePath("robot"), "--out", mission});
    ASSERT_TRUE(robot.waitForFinished(200000));
    ocu.terminate();
    ASSERT_TRUE(ocu.waitForFinished(10000));

    const Outcome fused = run(
        kHedrTool, {"fuse", mission, "--estimator", "hedr", "--out", folder.filePath("live.csv")});
    EXPECT_TRUE(fused.out.contains("bit for bit")) << fused.out.toStdString();
    run(kHedrTool, {"fuse", data + "sensors.csv", "--vehicle", data + "vehicle.toml", "--estimator",
                    "hedr", "--out", folder.filePath("direct.csv")});
    const double live_m = rms_m(folder.filePath("live.csv"), data + "truth.csv");
    const double direct_m = rms_m(folder.filePath("direct.csv"), data + "truth.csv");
    std::cout << GetParam().name << ": hedr live " << live_m << " m rms, from the log " << direct_m
              << " m rms\n";
    EXPECT_LE(live_m, GetParam().limit_m);
    EXPECT_NEAR(live_m, direct_m, 0.05 * direct_m);
}

INSTANTIATE_TEST_SUITE_P(Real, HedrOcuWithRealRobot,
                         ::testing::Values(Recording{"tuc_corridor", 100.0, 4.0},
                                           Recording{"wean_1", 20.0, 0.7}),
                         [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace hedr
