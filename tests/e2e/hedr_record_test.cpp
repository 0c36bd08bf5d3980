// Recording without a window: what is waited for, what is said, and how it ends.
#include <gtest/gtest.h>

#include <QTcpServer>
#include <QTcpSocket>
#include <csignal>
#include <filesystem>

#include "core/mission/mission_reader.h"
#include "core/mission/mission_writer.h"
#include "radio/robot_line.h"
#include "tests/e2e/tool_fixture.h"
#include "tests/radio/source/source_listener.h"
#include "tests/radio/spoken_drive.h"

namespace hedr {
namespace {

class HedrRecord : public ToolFixture {
  protected:
    void start(const QString& port) {
        recorder_.start(kHedrTool, {"record", "--port", port, "--out", path("m.hedr")});
    }
    bool says(const char* words, int patience_ms = 20000) {
        return soon(
            [&] {
                said_ += recorder_.readAllStandardError();
                return said_.contains(words);
            },
            patience_ms);
    }
    void end(int signal) {
        ASSERT_EQ(::kill(static_cast<pid_t>(recorder_.processId()), signal), 0);
        ASSERT_TRUE(recorder_.waitForFinished(10000));
        EXPECT_EQ(recorder_.exitCode(), 0);
        said_ += recorder_.readAllStandardError();
    }

    QProcess recorder_;
    QByteArray said_;
};

TEST_F(HedrRecord, WaitsForARobotThatConnectsAndEndsWithItsTerminal) {
    QTcpServer free_port;
    ASSERT_TRUE(free_port.listen(QHostAddress::LocalHost));
    const std::uint16_t port = free_port.serverPort();
    free_port.close();
    start(QStringLiteral("tcp://@127.0.0.1:%1").arg(port));
    ASSERT_TRUE(says("Waiting for the robot to connect")) << said_.toStdString();
    QTcpSocket robot;
    robot.connectToHost(QHostAddress::LocalHost, port);
    ASSERT_TRUE(says("Recording")) << said_.toStdString();
    const std::vector<std::uint8_t> bytes = spoken(straightDrive(5.0));
    robot.write(reinterpret_cast<const char*>(bytes.data()), static_cast<qint64>(bytes.size()));
    ASSERT_TRUE(soon([&] { return robot.bytesToWrite() == 0; }));
    QTest::qWait(500);
    end(SIGHUP);
    EXPECT_TRUE(said_.contains(" good frames of test")) << said_.toStdString();
    EXPECT_FALSE(std::filesystem::exists(path("m.hedr-wal").toStdString())) << "it is closed";
}

TEST_F(HedrRecord, SaysThatNothingIsUnderstoodAndThatTheRobotIsHeardAgain) {
    RobotLine line = RobotLine::openPseudoTerminal(path("robot").toStdString()).value();
    start(path("robot"));
    ASSERT_TRUE(says("Recording")) << said_.toStdString();
    QElapsedTimer babbling;
    babbling.start();
    while (!said_.contains("No valid packets") && babbling.elapsed() < 20000) {
        line.send(std::vector<std::uint8_t>(50, 0x55));
        says("No valid packets", 100);
    }
    EXPECT_TRUE(said_.contains("bytes arrive")) << said_.toStdString();
    line.send(spoken(straightDrive(5.0)));
    EXPECT_TRUE(says("The robot is heard again")) << said_.toStdString();
    end(SIGTERM);
    EXPECT_EQ(said_.count("No valid packets"), 1) << said_.toStdString();
}

TEST_F(HedrRecord, PlaysWhatIsLeftOfADamagedMissionToItsEnd) {
    const std::filesystem::path damaged = path("damaged.hedr").toStdString();
    {
        auto mission = MissionWriter::create(damaged, {});
        const std::vector<std::uint8_t> bytes = spoken(straightDrive(60.0));
        ASSERT_TRUE(mission);
        for (std::size_t at = 0; at + 100 <= bytes.size(); at += 100) {
            const auto piece = std::span(bytes).subspan(at, 100);
            ASSERT_TRUE(mission->writeBytes(0.0001 * static_cast<double>(at), piece));
        }
    }
    std::filesystem::resize_file(damaged, std::filesystem::file_size(damaged) - 5000);
    const Outcome outcome =
        run(kHedrTool, {"record", "--port", "file://" + path("damaged.hedr") + "?speed=100",
                        "--out", path("m.hedr")});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err.toStdString();
    EXPECT_TRUE(outcome.err.contains("is damaged")) << outcome.err.toStdString();
    EXPECT_GT(MissionReader::open(path("m.hedr").toStdString()).value().info()->stream_rows, 5U);
}

}  // namespace
}  // namespace hedr
