#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>
#include <sys/mount.h>

#include <algorithm>
#include <fstream>
#include <random>

#include "core/mission/mission_reader.h"
#include "core/mission/mission_writer.h"
#include "tests/core/text/file_content.h"
#include "tests/core/text/scratch_folder.h"
#include "tests/core/text/small_disk.h"

namespace hedr {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;

std::size_t rowCount(const MissionReader& mission) {
    std::size_t count = 0;
    EXPECT_TRUE(mission.forEachStreamRow([&count](const StreamRow&) { return ++count > 0; }));
    return count;
}

class MissionDamage : public testing::Test {
  protected:
    void record(int rows) const {
        auto mission = MissionWriter::create(file_, {});
        ASSERT_TRUE(mission);
        for (int i = 0; i < rows; ++i) ASSERT_TRUE(mission->writeBytes(0.01 * i, Bytes(100, 7)));
    }

    ScratchFolder folder_;
    fs::path file_ = folder_.path() / "drive.hedr";
};

TEST_F(MissionDamage, NeitherReadsNorOverwritesAnotherKindOfFile) {
    const std::string png =
        std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16) + std::string(5000, 'x');
    for (const std::string& bytes : {png, std::string("hello"), std::string(200000, '\0')}) {
        fill(file_, bytes);
        EXPECT_EQ(MissionReader::open(file_).error().code, ErrorCode::kNotAMission);
        EXPECT_EQ(MissionWriter::create(file_, {}).error().code, ErrorCode::kNotAMission);
        EXPECT_EQ(contentOf(file_), bytes);
    }
}

TEST_F(MissionDamage, NeitherReadsNorOverwritesAnotherDatabase) {
    {
        SQLite::Database other(file_.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
        other.exec("CREATE TABLE songs (name TEXT)");
    }
    const std::string before = contentOf(file_);
    EXPECT_EQ(MissionReader::open(file_).error().code, ErrorCode::kNotAMission);
    EXPECT_EQ(MissionWriter::create(file_, {}).error().code, ErrorCode::kNotAMission);
    EXPECT_EQ(contentOf(file_), before);
}

TEST_F(MissionDamage, RefusesTheSchemaOfALaterVersion) {
    record(1);
    {
        SQLite::Database later(file_.string(), SQLite::OPEN_READWRITE);
        later.exec("PRAGMA user_version = 999");
    }
    EXPECT_EQ(MissionReader::open(file_).error().code, ErrorCode::kMissionTooNew);
    EXPECT_EQ(MissionWriter::create(file_, {}).error().code, ErrorCode::kMissionTooNew);
}

TEST_F(MissionDamage, TellsThatATableIsMissing) {
    record(1);
    {
        SQLite::Database broken(file_.string(), SQLite::OPEN_READWRITE);
        broken.exec("DROP TABLE stream");
    }
    const auto mission = MissionReader::open(file_);
    ASSERT_TRUE(mission);
    EXPECT_EQ(mission->info().error().code, ErrorCode::kMissionDamaged);
}

TEST_F(MissionDamage, OfACutFileIsNoCrashAndNeverASilentLoss) {
    record(2000);
    const std::string whole = contentOf(file_);
    for (std::size_t size = 0; size < whole.size(); size += whole.size() / 40) {
        fill(file_, whole.substr(0, size));
        const auto mission = MissionReader::open(file_);
        if (!mission) {
            EXPECT_TRUE(mission.error().code == ErrorCode::kNotAMission ||
                        mission.error().code == ErrorCode::kMissionDamaged)
                << size;
            continue;
        }
        int rows = 0;
        const auto read =
            mission->forEachStreamRow([&rows](const StreamRow&) { return ++rows > 0; });
        EXPECT_TRUE(read) << size;
        EXPECT_TRUE(rows == 2000 || mission->salvaged()) << size;
    }
}

TEST_F(MissionDamage, OfRandomBytesIsNoCrash) {
    record(2000);
    const std::string whole = contentOf(file_);
    std::mt19937 random(1);
    for (int round = 0; round < 40; ++round) {
        std::string damaged = whole;
        for (int i = 0; i < 50; ++i)
            damaged[random() % damaged.size()] = static_cast<char>(random());
        fill(file_, damaged);
        const auto mission = MissionReader::open(file_);
        if (!mission) {
            EXPECT_FALSE(mission.error().subject.empty());
            continue;
        }
        (void)mission->info();
        (void)mission->forEachStreamRow([](const StreamRow&) { return true; });
        (void)mission->estimates("hedr");
        (void)mission->vehicle();
    }
}

TEST_F(MissionDamage, OfTheLogCostsOnlyWhatTheLogHeld) {
    auto mission = MissionWriter::create(file_, {});
    ASSERT_TRUE(mission);
    for (int i = 0; i < 100; ++i) {
        ASSERT_TRUE(mission->writeBytes(i, Bytes(100, 7)));
        ASSERT_TRUE(mission->commit());
    }
    const auto copy = folder_.path() / "copy.hedr";
    fs::copy(file_, copy);
    const std::string log = contentOf(file_.string() + "-wal");
    fill(copy.string() + "-wal", log.substr(0, log.size() / 2 + 100));
    const auto cut = MissionReader::open(copy);
    ASSERT_TRUE(cut);
    EXPECT_GT(rowCount(*cut), 10U);
    EXPECT_LT(rowCount(*cut), 100U);
}

TEST_F(MissionDamage, OfAFullDiskKeepsAllThatWasCommitted) {
    const SmallDisk disk(folder_.path() / "disk", "size=1m");
    if (!disk.mounted()) GTEST_SKIP() << "mounting a small disk needs more rights";
    const auto file = folder_.path() / "disk" / "drive.hedr";
    std::size_t committed = 0;
    {
        auto mission = MissionWriter::create(file, {});
        ASSERT_TRUE(mission);
        Result<void> written;
        for (std::size_t i = 0; written && i < 100000; ++i) {
            written = mission->writeBytes(0.1 * static_cast<double>(i), Bytes(200, 7));
            if (written) written = mission->commit();
            if (written) committed = i + 1;
        }
        ASSERT_FALSE(written);
        EXPECT_EQ(written.error().code, ErrorCode::kDiskFull);
        EXPECT_EQ(written.error().subject, file.string());
        EXPECT_EQ(mission->writeBytes(1e6, Bytes{1}).error().code, ErrorCode::kDiskFull);
        EXPECT_EQ(mission->commitIfDue(1e6).error().code, ErrorCode::kDiskFull);
    }
    const auto mission = MissionReader::open(file);
    ASSERT_TRUE(mission) << mission.error().detail;
    EXPECT_GT(committed, 100U);
    EXPECT_GE(rowCount(*mission), committed);
}

TEST_F(MissionDamage, OfADiskThatIsFullFromTheStartIsOneClearError) {
    const SmallDisk disk(folder_.path() / "disk", "size=16k");
    if (!disk.mounted()) GTEST_SKIP() << "mounting a small disk needs more rights";
    const auto mission = MissionWriter::create(folder_.path() / "disk" / "drive.hedr", {});
    ASSERT_FALSE(mission);
    EXPECT_EQ(mission.error().code, ErrorCode::kDiskFull);
}

TEST_F(MissionDamage, DoesNotComeFromAReadOnlyFolder) {
    record(50);
    const auto folder = folder_.path() / "readonly";
    const SmallDisk disk(folder, "size=1m");
    if (!disk.mounted()) GTEST_SKIP() << "mounting a read-only disk needs more rights";
    fs::copy(file_, folder / "drive.hedr");
    ASSERT_EQ(mount(nullptr, folder.c_str(), nullptr, MS_REMOUNT | MS_RDONLY, nullptr), 0);
    const auto mission = MissionReader::open(folder / "drive.hedr");
    ASSERT_TRUE(mission) << mission.error().detail;
    EXPECT_EQ(rowCount(*mission), 50U);
    EXPECT_EQ(MissionWriter::create(folder / "drive.hedr", {}).error().code,
              ErrorCode::kFileUnwritable);
}

// SQLite reads the rest of a page that was cut off as zeros, and the middle when it gets there.
TEST_F(MissionDamage, InTheLastPageOrInTheMiddleIsToldWhenItIsOpened) {
    record(3000);
    const std::string whole = contentOf(file_);
    ASSERT_FALSE(MissionReader::open(file_).value().salvaged());
    std::string scribbled = whole;
    scribbled.replace(whole.size() / 2, 8000, std::string(8000, '\x5A'));
    for (const std::string& damaged : {whole.substr(0, whole.size() - 100), scribbled}) {
        fill(file_, damaged);
        const auto mission = MissionReader::open(file_);
        ASSERT_TRUE(mission);
        ASSERT_TRUE(mission->salvaged());
        EXPECT_GT(mission->salvaged()->stream_rows, 2800U);
        EXPECT_GT(mission->salvaged()->stream_rows_missing + mission->salvaged()->pages_missing,
                  0U);
        EXPECT_EQ(contentOf(file_), damaged);
    }
}

TEST_F(MissionDamage, IsNotWhatReadingLeavesBeside) {
    record(10);
    { EXPECT_TRUE(MissionReader::open(file_)); }
    for (const char* ending : {"-wal", "-shm"})
        EXPECT_FALSE(fs::exists(fs::path(file_) += ending)) << ending;
}

}  // namespace
}  // namespace hedr
