#include "radio/source/recording_source.h"

#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>

#include "core/mission/mission_writer.h"
#include "tests/radio/source/source_listener.h"

namespace hedr {
namespace {

class RecordingSourceOfAMission : public ::testing::Test {
  protected:
    QString file() const { return folder_.filePath("m.hedr"); }
    MissionWriter record() const {
        return MissionWriter::create(
                   file().toStdString(),
                   {.start = std::chrono::system_clock::now(), .program_version = "test"})
            .value();
    }
    static void bytes(MissionWriter& mission, double time_s, const std::string& text) {
        ASSERT_TRUE(mission.writeBytes(
            time_s, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}));
    }

    QTemporaryDir folder_;
};

TEST_F(RecordingSourceOfAMission, GivesItsBytesAtTheirTimesAndSaysWhereTheRadioWasGone) {
    {
        MissionWriter mission = record();
        ASSERT_TRUE(mission.writeStreamMark(100.0, StreamKind::kPortOpened));
        bytes(mission, 100.0, "one");
        ASSERT_TRUE(mission.writeStreamMark(100.2, StreamKind::kSent));
        bytes(mission, 100.5, "two");
        ASSERT_TRUE(mission.writeStreamMark(100.6, StreamKind::kPortLost));
        ASSERT_TRUE(mission.writeStreamMark(101.0, StreamKind::kPortOpened));
        bytes(mission, 101.0, "three");
        ASSERT_TRUE(mission.writeStreamMark(101.1, StreamKind::kPortLost));
    }
    RecordingSource source({file(), 2.0});
    SourceListener heard(source);
    QElapsedTimer timer;
    timer.start();
    source.open();
    ASSERT_TRUE(soon([&] { return heard.bytes == "one"; }));
    EXPECT_EQ(heard.opened, 1);
    ASSERT_TRUE(soon([&] { return heard.bytes == "onetwo"; }));
    EXPECT_GE(timer.elapsed(), 250);
    ASSERT_TRUE(soon([&] { return heard.errors.size() == 1; }));
    EXPECT_EQ(heard.errors[0].code, ErrorCode::kReplayGap);
    ASSERT_TRUE(soon([&] { return heard.opened == 2; }));
    ASSERT_TRUE(soon([&] { return heard.errors.size() == 3; }));
    EXPECT_EQ(heard.bytes, "onetwothree");
    EXPECT_EQ(heard.errors[2].code, ErrorCode::kReplayEnded);
    EXPECT_EQ(heard.errors[2].detail, "the recording is at its end");
    EXPECT_GE(timer.elapsed(), 550);
}

TEST_F(RecordingSourceOfAMission, StartsFromTheBeginningWhenItIsOpenedAgain) {
    {
        MissionWriter mission = record();
        bytes(mission, 0.0, "one");
        bytes(mission, 1000.0, "never");
    }
    RecordingSource source({file()});
    SourceListener heard(source);
    source.open();
    ASSERT_TRUE(soon([&] { return heard.bytes == "one"; }));
    EXPECT_EQ(heard.opened, 1) << "bytes without a mark that the port was opened";
    source.open();
    ASSERT_TRUE(soon([&] { return heard.bytes == "oneone"; }));
    source.close();
    QTest::qWait(50);
    EXPECT_TRUE(heard.errors.empty());
}

TEST_F(RecordingSourceOfAMission, MayBeClosedByWhoeverHearsIt) {
    {
        MissionWriter mission = record();
        bytes(mission, 0.0, "one");
        bytes(mission, 0.0, "two");
    }
    RecordingSource source({file()});
    SourceListener heard(source);
    QObject::connect(&source, &ByteSource::bytesReceived, &source, [&] { source.close(); });
    source.open();
    ASSERT_TRUE(soon([&] { return heard.bytes == "one"; }));
    QTest::qWait(50);
    EXPECT_EQ(heard.bytes, "one");
    EXPECT_TRUE(heard.errors.empty());
}

TEST_F(RecordingSourceOfAMission, SaysOnceWhatIsWrongWithTheFile) {
    QFile no_mission(folder_.filePath("other.hedr"));
    ASSERT_TRUE(no_mission.open(QIODevice::WriteOnly));
    no_mission.write("something else, and long enough to be looked at");
    no_mission.close();
    for (const auto& [name, code] : {std::pair{file(), ErrorCode::kFileMissing},
                                     {no_mission.fileName(), ErrorCode::kNotAMission}}) {
        RecordingSource source({name});
        SourceListener heard(source);
        source.open();
        QTest::qWait(50);
        ASSERT_EQ(heard.errors.size(), 1U);
        EXPECT_EQ(heard.errors[0].code, code);
        EXPECT_EQ(heard.errors[0].subject, name.toStdString());
    }
}

}  // namespace
}  // namespace hedr
