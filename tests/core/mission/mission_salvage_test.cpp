#include "core/mission/mission_salvage.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iostream>
#include <map>

#include "core/mission/mission_reader.h"
#include "core/mission/mission_writer.h"
#include "core/simulation/random.h"
#include "tests/core/text/file_content.h"
#include "tests/core/text/scratch_folder.h"

namespace hedr {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;

// What the row with that number holds, told again.
Bytes dataOf(std::uint64_t row, std::size_t most) {
    Random random(row);
    Bytes bytes(static_cast<std::size_t>(random.uniform() * static_cast<double>(most)));
    for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random.uniform() * 256.0);
    return bytes;
}

// Pages of the stream and how many rows each holds, as SQLite itself says.
std::map<std::uint64_t, std::uint64_t> streamLeaves(const fs::path& file) {
    std::map<std::uint64_t, std::uint64_t> leaves;
    SQLite::Database database(file.string(), SQLite::OPEN_READONLY);
    SQLite::Statement pages(database,
                            "SELECT pageno, ncell FROM dbstat WHERE name = 'stream' AND "
                            "pagetype = 'leaf'");
    while (pages.executeStep())
        leaves[static_cast<std::uint64_t>(pages.getColumn(0).getInt64())] =
            static_cast<std::uint64_t>(pages.getColumn(1).getInt64());
    return leaves;
}

class MissionSalvage : public testing::Test {
  protected:
    // As it lies on the disk while it is recorded, its log in the file beside it.
    void record(std::uint64_t rows, std::size_t longest_row) const {
        auto mission = MissionWriter::create(file_, {.start = {}, .program_version = "test"});
        ASSERT_TRUE(mission);
        ASSERT_TRUE(mission->writeVehicle({}));
        for (std::uint64_t i = 1; i <= rows; ++i) {
            const double t_s = 0.02 * static_cast<double>(i);
            ASSERT_TRUE(mission->writeBytes(t_s, dataOf(i, longest_row)));
            if (i % 50 != 0) continue;
            ASSERT_TRUE(mission->writeLinkSample({.receive_time_s = t_s}));
            ASSERT_TRUE(mission->writeEvent(t_s, "note", "at " + std::to_string(i)));
            const TrackPoint point{t_s};
            ASSERT_TRUE(mission->writeEstimates("hedr", std::span(&point, 1)));
            if (i % 1000 != 0) continue;
            ASSERT_TRUE(mission->commit());
        }
        ASSERT_TRUE(mission->commit());
        fs::copy(file_, recorded_);
        fs::copy(file_.string() + "-wal", recorded_.string() + "-wal");
    }

    // The rows that a salvage of `damaged` gives, each of which must be as it was written.
    std::uint64_t salvagedRows(const fs::path& damaged, std::size_t longest_row) const {
        fs::remove(out_);
        const auto report = salvageMission(damaged, out_);
        EXPECT_TRUE(report) << report.error().detail;
        const auto mission = MissionReader::open(out_);
        EXPECT_TRUE(mission);
        if (!report || !mission) return 0;
        EXPECT_TRUE(mission->info());
        EXPECT_TRUE(mission->vehicle());
        std::uint64_t rows = 0;
        const auto read = mission->forEachStreamRow([&](const StreamRow& row) {
            const auto number = static_cast<std::uint64_t>(std::llround(row.receive_time_s / 0.02));
            EXPECT_EQ(Bytes(row.data.begin(), row.data.end()), dataOf(number, longest_row));
            return ++rows > 0;
        });
        EXPECT_TRUE(read);
        EXPECT_EQ(report->stream_rows, rows);
        return rows;
    }

    // The rows that come by opening the damaged file as any other, which stays as it is.
    static std::uint64_t openedRows(const fs::path& damaged) {
        const std::string content = contentOf(damaged);
        const auto mission = MissionReader::open(damaged);
        EXPECT_TRUE(mission) << mission.error().detail;
        if (!mission) return 0;
        EXPECT_TRUE(mission->salvaged());
        std::uint64_t rows = 0;
        EXPECT_TRUE(mission->forEachStreamRow([&](const StreamRow&) { return ++rows > 0; }));
        EXPECT_EQ(contentOf(damaged), content);
        return rows;
    }

    // The least and the mean share of the rows before the damage that come back.
    std::pair<double, double> cutAtRandom(int seeds, std::size_t longest_row) const {
        const std::string whole = contentOf(recorded_);
        fs::remove(recorded_.string() + "-wal");
        const auto leaves = streamLeaves(recorded_);
        double least = 1.0;
        double sum = 0.0;
        for (int seed = 1; seed <= seeds; ++seed) {
            Random random(static_cast<std::uint64_t>(seed));
            const auto cut = static_cast<std::uint64_t>(
                random.uniform(100.0, static_cast<double>(whole.size())));
            const fs::path damaged = folder_.path() / "cut.hedr";
            fill(damaged, whole.substr(0, cut));
            std::uint64_t before = 0;
            for (const auto& [page, rows] : leaves) before += page * 4096 <= cut ? rows : 0;
            const std::uint64_t found = salvagedRows(damaged, longest_row);
            EXPECT_EQ(openedRows(damaged), found);
            const double share =
                before == 0 ? 1.0 : static_cast<double>(found) / static_cast<double>(before);
            least = std::min(least, share);
            sum += std::min(share, 1.0);
        }
        return {least, sum / seeds};
    }

    ScratchFolder folder_;
    fs::path file_ = folder_.path() / "drive.hedr";
    fs::path recorded_ = folder_.path() / "recorded.hedr";
    fs::path out_ = folder_.path() / "out.hedr";
};

constexpr std::size_t kUsualRow_bytes = 140;

TEST_F(MissionSalvage, OfACutFileWithoutItsLogGivesAllThatLiesBeforeTheCut) {
    record(60000, kUsualRow_bytes);
    const auto [least, mean] = cutAtRandom(5, kUsualRow_bytes);
    EXPECT_GE(least, 0.99);
}

// The figure of 200 cuts: --gtest_also_run_disabled_tests --gtest_filter='*TwoHundredCuts'
TEST_F(MissionSalvage, DISABLED_OfTwoHundredCuts) {
    record(60000, kUsualRow_bytes);
    const auto [least, mean] = cutAtRandom(200, kUsualRow_bytes);
    std::cout << "rows before the damage that came back: least " << 100.0 * least << " %, mean "
              << 100.0 * mean << " %\n";
    EXPECT_GE(least, 0.99);
}

TEST_F(MissionSalvage, FollowsRowsThatFillSeveralPages) {
    constexpr std::size_t kLongRow_bytes = 20000;
    record(1500, kLongRow_bytes);
    EXPECT_EQ(salvagedRows(recorded_, kLongRow_bytes), 1500U) << "with the log";
}

TEST_F(MissionSalvage, TakesAlsoWhatOnlyTheLogHolds) {
    record(1000, kUsualRow_bytes);
    const auto report = salvageMission(recorded_, out_);
    ASSERT_TRUE(report);
    EXPECT_EQ(report->stream_rows, 1000U);
    EXPECT_EQ(report->other_rows, 1U + 20U + 20U + 1U) << "vehicle, link, event, estimates";
    EXPECT_NEAR(report->recovered_s, 20.0, 1e-9);
    EXPECT_TRUE(report->start_known);
    const auto mission = MissionReader::open(out_);
    ASSERT_TRUE(mission);
    EXPECT_EQ(mission->estimates("hedr").value().size(), 20U);
    EXPECT_EQ(mission->events().value().back().text, "at 1000");
    EXPECT_EQ(mission->linkSamples().value().size(), 20U);
}

TEST_F(MissionSalvage, SaysPlainlyWhatIsMissing) {
    record(60000, kUsualRow_bytes);
    fs::remove(recorded_.string() + "-wal");
    std::string bytes = contentOf(recorded_);
    const std::size_t pages = bytes.size() / 4096;
    bytes.resize(4096 * (pages / 2));
    for (std::size_t page = 100; page < 110; ++page) bytes.replace(page * 4096, 4096, 4096, '\0');
    fill(recorded_, bytes);
    const auto mission = MissionReader::open(recorded_);
    ASSERT_TRUE(mission);
    ASSERT_TRUE(mission->salvaged());
    const auto report = salvageMission(recorded_, out_);
    ASSERT_TRUE(report);
    EXPECT_EQ(describe(*mission->salvaged()), describe(*report));
    EXPECT_EQ(report->pages, pages);
    EXPECT_EQ(report->pages_missing, pages - pages / 2);
    EXPECT_GT(report->stream_rows_missing, 200U);
    EXPECT_LT(report->stream_rows_missing, 1000U);
    EXPECT_LT(report->recovered_s, report->duration_s);
    const std::string said = describe(*report);
    for (const char* word : {"recovered", "of at least", "missing:", "pages at its end"})
        EXPECT_NE(said.find(word), std::string::npos) << said;
}

// Numbers of frames after a hole would be about other frames.
TEST_F(MissionSalvage, KeepsWhatWasNotBelievedWhereNoFrameIsMissing) {
    {
        auto mission = MissionWriter::create(file_, {.start = {}, .program_version = "test"});
        ASSERT_TRUE(mission);
        ASSERT_TRUE(mission->writeRejected({7, 2}));
        for (std::uint64_t i = 1; i <= 3000; ++i)
            ASSERT_TRUE(mission->writeBytes(0.02 * static_cast<double>(i), dataOf(i, 140)));
    }
    const auto rejected_in = [&] {
        fs::remove(out_);
        const auto report = salvageMission(file_, out_);
        EXPECT_TRUE(report);
        const auto mission = MissionReader::open(out_);
        EXPECT_TRUE(mission);
        return std::pair(mission->rejected().value().size(), report->rejected_missing);
    };
    EXPECT_EQ(rejected_in(), std::pair(std::size_t{1}, false));
    std::string bytes = contentOf(file_);
    bytes.replace(bytes.size() / 2 / 4096 * 4096, 4096, 4096, '\0');
    fill(file_, bytes);
    EXPECT_EQ(rejected_in(), std::pair(std::size_t{0}, true));
}

TEST_F(MissionSalvage, OfRandomBytesIsNoCrashAndLeavesTheDamagedFileAlone) {
    record(20000, kUsualRow_bytes);
    fs::remove(recorded_.string() + "-wal");
    const std::string whole = contentOf(recorded_);
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        Random random(seed);
        std::string damaged = whole;
        for (int i = 0; i < 2000; ++i) {
            const double place = random.uniform(100.0, static_cast<double>(whole.size()));
            damaged[static_cast<std::size_t>(place)] = static_cast<char>(random.uniform() * 256.0);
        }
        fill(recorded_, damaged);
        fs::remove(out_);
        EXPECT_TRUE(salvageMission(recorded_, out_)) << seed;
        EXPECT_EQ(contentOf(recorded_), damaged);
    }
}

TEST_F(MissionSalvage, NeitherTakesAnotherKindOfFileNorOverwritesOne) {
    EXPECT_EQ(salvageMission(file_, out_).error().code, ErrorCode::kFileMissing);
    for (const std::string& bytes : {std::string(), std::string("hello"), std::string(9000, 'x')}) {
        fill(file_, bytes);
        EXPECT_EQ(salvageMission(file_, out_).error().code, ErrorCode::kNotAMission);
        EXPECT_FALSE(fs::exists(out_));
    }
    EXPECT_EQ(salvageMission(file_, file_).error().code, ErrorCode::kFileExists);
}

}  // namespace
}  // namespace hedr
