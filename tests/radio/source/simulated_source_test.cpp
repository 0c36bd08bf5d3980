#include "radio/source/simulated_source.h"

#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <QTemporaryDir>
#include <atomic>
#include <thread>

#include "core/robot/sensor_csv.h"
#include "core/text/text_file.h"
#include "radio/wire/codec.h"
#include "radio/wire/frame_decoder.h"
#include "radio/wire/frame_encoder.h"
#include "tests/radio/source/source_listener.h"
#include "tests/radio/spoken_drive.h"

namespace hedr {
namespace {

std::vector<Report> reportsIn(const QByteArray& bytes) {
    std::vector<Report> reports;
    FrameDecoder decoder;
    decoder.feed({reinterpret_cast<const std::uint8_t*>(bytes.constData()),
                  static_cast<std::size_t>(bytes.size())},
                 [&](const Frame& frame) {
                     if (auto report = decodeReport(frame)) reports.push_back(*report);
                 });
    return reports;
}

template <class Kind>
std::vector<Kind> allOf(const QByteArray& bytes) {
    std::vector<Kind> found;
    for (const Report& report : reportsIn(bytes)) {
        if (const auto* kind = std::get_if<Kind>(&report)) found.push_back(*kind);
    }
    return found;
}

Result<SimulatedDrive> shortDrive() {
    return SimulatedDrive{spokenVehicle(), {}, straightDrive(3.0)};
}

TEST(SimulatedSource, SpeaksInItsOwnTimeTheBytesOfARobot) {
    SimulatedSource source(SimulatorAddress{"umbmark"}, 10.0, shortDrive);
    SourceListener heard(source);
    source.open();
    ASSERT_TRUE(soon([&] { return heard.opened == 1; }));
    QElapsedTimer timer;
    timer.start();
    ASSERT_TRUE(soon([&] { return heard.errors.size() == 1; }));
    EXPECT_GE(timer.elapsed(), 250) << "3 s at ten times real time";
    EXPECT_EQ(heard.errors[0].code, ErrorCode::kReplayEnded);
    const std::vector<std::uint8_t> said = spoken(straightDrive(3.0));
    EXPECT_EQ(heard.bytes, QByteArray(reinterpret_cast<const char*>(said.data()),
                                      static_cast<qsizetype>(said.size())));
}

TEST(SimulatedSource, AnswersRequestsWithTheNextBytes) {
    SimulatedSource source(SimulatorAddress{"umbmark"}, 1.0, shortDrive);
    SourceListener heard(source);
    source.write("nobody hears this yet");
    source.open();
    ASSERT_TRUE(soon([&] { return heard.opened == 1; }));
    const auto frame = encodeRequest(TimeRequest{1234}, 0);
    const QByteArray question(reinterpret_cast<const char*>(frame.view().data()),
                              static_cast<qsizetype>(frame.view().size()));
    const qsizetype before = heard.bytes.size();
    source.write(question);
    EXPECT_EQ(heard.bytes.size(), before) << "not before the question is sent";
    ASSERT_TRUE(soon([&] { return !allOf<TimeEchoReport>(heard.bytes).empty(); }));
    EXPECT_EQ(allOf<TimeEchoReport>(heard.bytes)[0].token, 1234U);
}

TEST(SimulatedSource, ComputesItsDriveOnAnotherThread) {
    std::atomic<bool> may_go_on{false};
    const auto slow_drive = [&] {
        while (!may_go_on) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return shortDrive();
    };
    SimulatedSource source(SimulatorAddress{"umbmark"}, 1.0, slow_drive);
    SourceListener heard(source);
    QElapsedTimer timer;
    timer.start();
    source.open();
    EXPECT_LT(timer.elapsed(), 100);
    EXPECT_EQ(heard.opened, 0);
    source.close();
    may_go_on = true;
    QTest::qWait(100);
    EXPECT_EQ(heard.opened, 0) << "a drive that comes after the end is for nobody";
    source.open();
    EXPECT_TRUE(soon([&] { return heard.opened == 1; }));
}

TEST(SimulatedSource, MayGoAwayWhileItsDriveIsComputed) {
    std::atomic<bool> may_go_on{false};
    std::atomic<bool> done{false};
    {
        SimulatedSource source(SimulatorAddress{"umbmark"}, 1.0, [&] {
            while (!may_go_on) std::this_thread::sleep_for(std::chrono::milliseconds(1));
            done = true;
            return shortDrive();
        });
        source.open();
    }
    may_go_on = true;
    EXPECT_TRUE(soon([&] { return done.load(); }));
    QTest::qWait(20);
}

TEST(SimulatedSource, DrivesEveryScenarioTheSameWayForTheSameSeed) {
    QByteArray first_bytes[2];
    for (QByteArray& bytes : first_bytes) {
        const auto source = makeByteSource(SimulatorAddress{"umbmark", 3, 1000.0});
        SourceListener heard(*source);
        source->open();
        ASSERT_TRUE(soon([&] { return heard.bytes.size() >= 20000; }, 20000));
        bytes = heard.bytes.left(20000);
    }
    EXPECT_EQ(first_bytes[0], first_bytes[1]);
    EXPECT_FALSE(allOf<HelloReport>(first_bytes[0]).empty());
}

class SourceOfALog : public ::testing::Test {
  protected:
    QString log() const { return folder_.filePath("sensors.csv"); }
    Error errorOfIt() const {
        const auto source = makeByteSource(RecordingAddress{log()});
        SourceListener heard(*source);
        source->open();
        return soon([&] { return !heard.errors.empty(); }) ? heard.errors[0] : Error{};
    }
    QTemporaryDir folder_;
};

TEST_F(SourceOfALog, NeedsTheVehicleBesideIt) {
    EXPECT_EQ(errorOfIt().subject, log().toStdString());
    ASSERT_TRUE(saveSensorLog(log().toStdString(), straightDrive(3.0)));
    const Error without = errorOfIt();
    EXPECT_EQ(without.code, ErrorCode::kFileMissing);
    EXPECT_EQ(without.subject, folder_.filePath("vehicle.toml").toStdString());
    ASSERT_TRUE(writeTextFile(folder_.filePath("vehicle.toml").toStdString(),
                              formatVehicle(spokenVehicle())));
    const auto source = makeByteSource(RecordingAddress{log(), 20.0});
    SourceListener heard(*source);
    source->open();
    ASSERT_TRUE(soon([&] { return !heard.errors.empty(); }));
    EXPECT_EQ(heard.errors[0].code, ErrorCode::kReplayEnded);
    EXPECT_EQ(allOf<SensorReport>(heard.bytes).size(), straightDrive(3.0).size());
}

}  // namespace
}  // namespace hedr
