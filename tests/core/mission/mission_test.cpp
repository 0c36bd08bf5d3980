#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <fstream>
#include <random>

#include "core/mission/mission_reader.h"
#include "core/mission/mission_writer.h"
#include "tests/core/text/scratch_folder.h"

namespace hedr {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;
using namespace std::chrono_literals;

const MissionHeader kHeader = {std::chrono::sys_days{std::chrono::year{2024} / 5 / 17} + 9h + 30min,
                               "1.2.3"};

struct StoredRow {
    double receive_time_s;
    StreamKind kind;
    Bytes data;
    friend bool operator==(const StoredRow&, const StoredRow&) = default;
};

std::vector<StoredRow> rowsOf(const MissionReader& mission) {
    std::vector<StoredRow> rows;
    const auto done = mission.forEachStreamRow([&rows](const StreamRow& row) {
        rows.push_back({row.receive_time_s, row.kind, {row.data.begin(), row.data.end()}});
        return true;
    });
    EXPECT_TRUE(done);
    return rows;
}

class Mission : public testing::Test {
  protected:
    MissionWriter writer(const MissionHeader& header = kHeader) {
        auto writer = MissionWriter::create(file_, header);
        EXPECT_TRUE(writer) << writer.error().subject << ": " << writer.error().detail;
        return std::move(*writer);
    }
    MissionReader reader() const {
        auto reader = MissionReader::open(file_);
        EXPECT_TRUE(reader) << reader.error().subject << ": " << reader.error().detail;
        return std::move(*reader);
    }
    void fill(const std::string& bytes) const { std::ofstream(file_, std::ios::binary) << bytes; }

    ScratchFolder folder_;
    fs::path file_ = folder_.path() / "drive.hedr";
};

TEST_F(Mission, KeepsBytesMarksAndTheirTimesInOrder) {
    const std::vector<StoredRow> rows = {{0.0, StreamKind::kPortOpened, {}},
                                         {0.1, StreamKind::kBytes, {0, 255, 7}},
                                         {1.0 / 3.0, StreamKind::kBytes, {1}},
                                         {0.5, StreamKind::kPortLost, {}}};
    {
        auto mission = writer();
        for (const StoredRow& row : rows) {
            const auto written = row.kind == StreamKind::kBytes
                                     ? mission.writeBytes(row.receive_time_s, row.data)
                                     : mission.writeStreamMark(row.receive_time_s, row.kind);
            ASSERT_TRUE(written);
        }
    }
    EXPECT_EQ(rowsOf(reader()), rows);
}

TEST_F(Mission, KeepsALongStreamOfAnyBytesBitForBit) {
    std::mt19937 random(1);
    std::vector<StoredRow> rows;
    for (int i = 0; i < 3000; ++i) {
        Bytes bytes(random() % 300);
        for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random());
        rows.push_back({i / 70.0, StreamKind::kBytes, bytes});
    }
    {
        auto mission = writer();
        for (const StoredRow& row : rows) {
            ASSERT_TRUE(mission.writeBytes(row.receive_time_s, row.data));
            ASSERT_TRUE(mission.commitIfDue(row.receive_time_s));
        }
    }
    EXPECT_EQ(rowsOf(reader()), rows);
}

TEST_F(Mission, KeepsEstimatesToTheLastBit) {
    std::vector<TrackPoint> points;
    for (int i = 0; i < 1000; ++i)
        points.push_back({i / 3.0, {{i / 7.0, -i / 11.0}, i / 13.0}, 1e-5 / (i + 1)});
    {
        auto mission = writer();
        for (std::size_t i = 0; i < points.size(); i += 10) {
            ASSERT_TRUE(mission.writeEstimates("hedr", std::span(points).subspan(i, 10)));
            ASSERT_TRUE(mission.writeEstimates("odometry", std::span(points).subspan(i, 1)));
            ASSERT_TRUE(mission.commitIfDue(points[i].t_s));
        }
    }
    const auto mission = reader();
    EXPECT_EQ(*mission.tracks(), (std::vector<std::string>{"hedr", "odometry"}));
    EXPECT_EQ(*mission.estimates("hedr"), points);
    EXPECT_EQ(mission.estimates("odometry")->size(), 100U);
    EXPECT_TRUE(mission.estimates("gyro")->empty());
}

TEST_F(Mission, KeepsVehiclePlanAndEvents) {
    Vehicle vehicle;
    vehicle.name = "robot \"7\"";
    vehicle.geometry.wheelbase_m = 1.0 / 3.0;
    const MissionPlan plan = {"/plans/floor 1.png", {0.1 / 3.0, {{1.5, -2.5}, 1.0 / 7.0}}, "abc"};
    {
        auto mission = writer();
        ASSERT_TRUE(mission.writeVehicle(Vehicle{}));
        ASSERT_TRUE(mission.writeVehicle(vehicle));
        ASSERT_TRUE(mission.writePlan(plan));
        ASSERT_TRUE(mission.writeEvent(2.5, "note", "door on the left"));
    }
    const auto mission = reader();
    EXPECT_EQ(*mission.vehicle(), vehicle);
    EXPECT_EQ(*mission.plan(), plan);
    EXPECT_EQ(*mission.events(), (std::vector<MissionEvent>{{2.5, "note", "door on the left"}}));
}

TEST_F(Mission, HasNoVehicleAndNoPlanWhereNoneWasWritten) {
    writer();
    const auto mission = reader();
    EXPECT_EQ(*mission.vehicle(), std::nullopt);
    EXPECT_EQ(*mission.plan(), std::nullopt);
    EXPECT_TRUE(rowsOf(mission).empty());
}

TEST_F(Mission, TellsWhatItHolds) {
    {
        auto mission = writer();
        ASSERT_TRUE(mission.writeBytes(1.0, Bytes{1, 2, 3}));
        ASSERT_TRUE(mission.writeBytes(61.5, Bytes{4}));
        ASSERT_TRUE(mission.writeEvent(60.0, "mark", ""));
        ASSERT_TRUE(mission.writeEstimates("hedr", std::vector<TrackPoint>(7)));
        ASSERT_TRUE(mission.commit());
        EXPECT_GT(mission.bytesOnDisk(), 0U);
    }
    const auto info = reader().info();
    ASSERT_TRUE(info);
    EXPECT_EQ(info->start_utc, "2024-05-17T09:30:00Z");
    EXPECT_EQ(info->duration_s, 61.5);
    EXPECT_EQ(info->bytes, fs::file_size(file_));
    EXPECT_EQ(info->stream_rows, 2U);
    EXPECT_EQ(info->events, 1U);
    ASSERT_EQ(info->tracks.size(), 1U);
    EXPECT_EQ(info->tracks[0], (std::pair<std::string, std::uint64_t>("hedr", 7)));
    EXPECT_EQ(info->program_version, "1.2.3");
    EXPECT_EQ(info->schema, 3);
}

TEST_F(Mission, IsOneFileAfterItWasClosed) {
    ASSERT_TRUE(writer().writeBytes(0.0, Bytes{1}));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), {}), 1);
}

TEST_F(Mission, GoesOnWithTheTimeSinceItsFirstStart) {
    ASSERT_TRUE(writer().writeBytes(10.0, Bytes{1}));
    MissionHeader later = kHeader;
    later.start += 100s;
    ASSERT_TRUE(writer(later).writeBytes(1.0, Bytes{2}));
    const auto rows = rowsOf(reader());
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[0], (StoredRow{10.0, StreamKind::kBytes, {1}}));
    EXPECT_EQ(rows[1], (StoredRow{101.0, StreamKind::kBytes, {2}}));
    EXPECT_EQ(reader().info()->start_utc, "2024-05-17T09:30:00Z");
}

TEST_F(Mission, NeverGoesBackInTimeWhereTheWallClockDid) {
    ASSERT_TRUE(writer().writeBytes(10.0, Bytes{1}));
    MissionHeader earlier = kHeader;
    earlier.start -= 1h;
    ASSERT_TRUE(writer(earlier).writeBytes(1.0, Bytes{2}));
    EXPECT_EQ(rowsOf(reader())[1].receive_time_s, 11.0);
}

TEST_F(Mission, IsReadWhileItIsRecorded) {
    auto mission = writer();
    ASSERT_TRUE(mission.writeBytes(0.0, Bytes{1}));
    ASSERT_TRUE(mission.commit());
    ASSERT_TRUE(mission.writeBytes(0.1, Bytes{2}));
    EXPECT_EQ(rowsOf(reader()).size(), 1U);
    ASSERT_TRUE(mission.commit());
    EXPECT_EQ(rowsOf(reader()).size(), 2U);
}

TEST_F(Mission, CommitsHalfASecondAfterTheLastCommit) {
    auto mission = writer();
    ASSERT_TRUE(mission.writeBytes(0.4, Bytes{1}));
    ASSERT_TRUE(mission.commitIfDue(0.49));
    EXPECT_TRUE(rowsOf(reader()).empty());
    ASSERT_TRUE(mission.commitIfDue(0.5));
    EXPECT_EQ(rowsOf(reader()).size(), 1U);
}

TEST_F(Mission, LetsTheVisitorStop) {
    {
        auto mission = writer();
        for (int i = 0; i < 10; ++i) ASSERT_TRUE(mission.writeBytes(i, Bytes{1}));
    }
    int visited = 0;
    ASSERT_TRUE(reader().forEachStreamRow([&visited](const StreamRow&) { return ++visited < 3; }));
    EXPECT_EQ(visited, 3);
}

TEST_F(Mission, RefusesASecondWriterAndRecordsOn) {
    auto first = writer();
    const auto second = MissionWriter::create(file_, kHeader);
    ASSERT_FALSE(second);
    EXPECT_EQ(second.error().code, ErrorCode::kMissionBusy);
    EXPECT_EQ(second.error().subject, file_.string());
    ASSERT_TRUE(first.writeBytes(0.0, Bytes{1}));
    ASSERT_TRUE(first.commit());
    EXPECT_EQ(rowsOf(reader()).size(), 1U);
}

TEST_F(Mission, CanBeMovedWhileItIsOpen) {
    auto first = writer();
    ASSERT_TRUE(first.writeBytes(0.0, Bytes{1}));
    MissionWriter second = std::move(first);
    ASSERT_TRUE(second.writeBytes(1.0, Bytes{2}));
    ASSERT_TRUE(second.commit());
    EXPECT_EQ(rowsOf(reader()).size(), 2U);
}

TEST_F(Mission, TakesAnEmptyFileAsANewMission) {
    fill("");
    EXPECT_EQ(MissionReader::open(file_).error().code, ErrorCode::kNotAMission);
    ASSERT_TRUE(writer().writeBytes(0.0, Bytes{1}));
    EXPECT_EQ(rowsOf(reader()).size(), 1U);
}

TEST_F(Mission, OpensWithACharacterThatAUriWouldRead) {
    file_ = folder_.path() / "50% of #1? done.hedr";
    ASSERT_TRUE(writer().writeBytes(0.0, Bytes{1}));
    EXPECT_EQ(rowsOf(reader()).size(), 1U);
}

TEST_F(Mission, TellsMissingFilesAndFolders) {
    EXPECT_EQ(MissionReader::open(file_).error().code, ErrorCode::kFileMissing);
    EXPECT_EQ(MissionReader::open(folder_.path()).error().code, ErrorCode::kFileUnreadable);
    EXPECT_EQ(MissionWriter::create(folder_.path(), kHeader).error().code,
              ErrorCode::kFileUnwritable);
    const auto nowhere = MissionWriter::create(folder_.path() / "none" / "drive.hedr", kHeader);
    EXPECT_EQ(nowhere.error().code, ErrorCode::kFileUnwritable);
    EXPECT_EQ(nowhere.error().subject, (folder_.path() / "none" / "drive.hedr").string());
}

// A crash while a mission begins must not leave a file that is none.
TEST(MissionWriter, LeavesNothingButTheMissionBesideIt) {
    const ScratchFolder folder;
    const auto file = folder.path() / "drive.hedr";
    ASSERT_TRUE(MissionWriter::create(file, {}));
    const std::filesystem::directory_iterator files(folder.path());
    EXPECT_EQ(std::distance(begin(files), end(files)), 1);
    EXPECT_TRUE(MissionReader::open(file)->info());
}

}  // namespace
}  // namespace hedr
