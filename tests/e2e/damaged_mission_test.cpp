// A mission file that was cut: by a disk that failed, a copy that was not finished.
#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <QtTest/QTest>
#include <nlohmann/json.hpp>

#include "core/mission/mission_reader.h"
#include "radio/live_link.h"
#include "radio/recomputation.h"
#include "tests/core/text/file_content.h"
#include "tests/e2e/program.h"
#include "tests/e2e/talking_robot.h"

namespace hedr {
namespace {

namespace fs = std::filesystem;

class DamagedMission : public testing::Test {
  protected:
    DamagedMission() {
        record(mission_, 60.0);
        fs::resize_file(mission_, fs::file_size(mission_) * 6 / 10 + 77);
        content_ = contentOf(mission_);
    }

    // A robot's drive; notes the last batch, and the damage that any of them told.
    void record(const fs::path& file, double seconds) {
        const QString port = folder_.filePath("robot");
        const TalkingRobot robot(port, seconds, {.speed = 20.0});
        LiveLink link(
            {.vehicle = {},
             .mission = file,
             .header = {.start = std::chrono::system_clock::now(), .program_version = "test"}});
        QObject::connect(&link, &LiveLink::batchReady, [this](const LiveBatch& batch) {
            last_ = batch;
            if (!batch.warnings.empty()) damage_ = batch.warnings.front();
        });
        link.open(SerialAddress{port});
        EXPECT_TRUE(QTest::qWaitFor([&] { return robot.done(); }, 20000));
        link.close();
    }

    static std::uint64_t streamRows(const fs::path& file) {
        const auto reader = MissionReader::open(file);
        return reader ? reader->info().value().stream_rows : 0;
    }

    QTemporaryDir folder_;
    fs::path mission_ = folder_.filePath("m.hedr").toStdString();
    std::string content_;
    LiveBatch last_;
    std::optional<Error> damage_;
};

TEST_F(DamagedMission, IsReadAsFarAsItGoesByEveryCommand) {
    const QString file = QString::fromStdString(mission_.string());
    for (const QStringList& arguments :
         {QStringList{"info", file}, QStringList{"info", file, "--json"},
          QStringList{"fuse", file, "--estimator", "hedr", "--out", folder_.filePath("t.csv")}}) {
        const Outcome outcome = run(kHedrTool, arguments);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err.toStdString();
        for (const char* word : {"hedr: ", "is damaged", "recovered", "missing: "})
            EXPECT_TRUE(outcome.err.contains(word)) << outcome.err.toStdString();
    }
    const Outcome info = run(kHedrTool, {"info", file, "--json"});
    const auto object = nlohmann::json::parse(info.out.toStdString());
    EXPECT_GT(object.at("stream_rows").get<int>(), 10);
    EXPECT_TRUE(object.at("damage").get<std::string>().starts_with("recovered"));
    EXPECT_EQ(contentOf(mission_), content_);
}

TEST_F(DamagedMission, GoesOnInAnotherFile) {
    const std::uint64_t left = streamRows(mission_);
    ASSERT_GT(left, 10U);
    record(mission_, 20.0);
    ASSERT_TRUE(damage_);
    EXPECT_EQ(damage_->code, ErrorCode::kMissionMoved);
    EXPECT_FALSE(last_.recorder.error);
    const fs::path beside = folder_.filePath("m.recovered.hedr").toStdString();
    EXPECT_EQ(last_.recorder.file, beside.string());
    EXPECT_EQ(contentOf(mission_), content_);
    const auto reader = MissionReader::open(beside);
    ASSERT_TRUE(reader);
    EXPECT_FALSE(reader->salvaged());
    EXPECT_GT(reader->info().value().stream_rows, left + 10);
    EXPECT_TRUE(recomputeTrack(beside, "hedr", {}));
}

TEST_F(DamagedMission, GoesOnInTheSameFileTheNextTime) {
    const fs::path beside = folder_.filePath("m.recovered.hedr").toStdString();
    record(mission_, 20.0);
    const std::uint64_t before = streamRows(beside);
    record(mission_, 20.0);
    EXPECT_GT(streamRows(beside), before + 10);
    EXPECT_EQ(last_.recorder.file, beside.string());
    EXPECT_FALSE(fs::exists(folder_.filePath("m.recovered-2.hedr").toStdString()));
}

TEST_F(DamagedMission, DoesNotGoOnInAnotherMissionsFile) {
    const fs::path others = folder_.filePath("m.recovered.hedr").toStdString();
    QTest::qWait(20);  // it began at another moment
    record(others, 10.0);
    const std::string content = contentOf(others);
    record(mission_, 20.0);
    EXPECT_EQ(contentOf(others), content);
    EXPECT_GT(streamRows(folder_.filePath("m.recovered-2.hedr").toStdString()), 10U);
}

}  // namespace
}  // namespace hedr
