#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/mission/mission_reader.h"
#include "core/mission/mission_writer.h"
#include "tests/core/site/random_site.h"
#include "tests/core/text/scratch_folder.h"

namespace hedr {
namespace {

namespace fs = std::filesystem;

const Site kSite{.floors = {{.name = "Ground floor", .plans = {{.image_file = "/a/b.png"}}}},
                 .direction_rad = 0.25};

MissionWriter writerOf(const fs::path& file) {
    auto writer = MissionWriter::create(file, {});
    EXPECT_TRUE(writer) << writer.error().subject << ": " << writer.error().detail;
    return std::move(*writer);
}

Result<std::optional<Site>> siteIn(const fs::path& file) {
    return MissionReader::open(file).and_then([](const MissionReader& r) { return r.site(); });
}

int rowsOf(const fs::path& file) {
    SQLite::Database database(file.string());
    return database.execAndGet("SELECT count(*) FROM site");
}

// As the first version of this program has left it.
void makeOfSchema1(const fs::path& file) {
    writerOf(file);
    SQLite::Database database(file.string(), SQLite::OPEN_READWRITE);
    database.exec("DROP TABLE site");
    database.exec("DROP TABLE link");
    database.exec("DROP TABLE rejected");
    database.exec("PRAGMA user_version = 1");
}

class MissionSite : public testing::Test {
  protected:
    ScratchFolder folder_;
    fs::path file_ = folder_.path() / "drive.hedr";
};

TEST_F(MissionSite, IsTheOneThatWasWrittenLast) {
    {
        auto mission = writerOf(file_);
        ASSERT_TRUE(mission.writeSite(1.0, Site{}));
        ASSERT_TRUE(mission.writeSite(2.0, kSite));
    }
    EXPECT_EQ(*siteIn(file_), kSite);
    EXPECT_EQ(rowsOf(file_), 2);
}

TEST_F(MissionSite, IsNotThereWhereNoneWasWritten) {
    writerOf(file_);
    EXPECT_EQ(*siteIn(file_), std::nullopt);
}

TEST_F(MissionSite, TakesARowOnlyWhenItChanges) {
    for (int recording = 0; recording < 2; ++recording) {
        auto mission = writerOf(file_);
        ASSERT_TRUE(mission.writeSite(1.0, kSite));
        ASSERT_TRUE(mission.writeSite(2.0, kSite));
    }
    EXPECT_EQ(rowsOf(file_), 1);
}

TEST_F(MissionSite, MovesWithItsImagesAndTheMission) {
    Site site = kSite;
    site.floors[0].plans[0].image_file = folder_.path() / "plans/0.png";
    {
        auto mission = writerOf(file_);
        ASSERT_TRUE(mission.writeSite(0.0, site));
    }
    const fs::path moved = folder_.path() / "moved";
    fs::create_directory(moved);
    fs::rename(file_, moved / "drive.hedr");
    EXPECT_EQ((*siteIn(moved / "drive.hedr"))->floors[0].plans[0].image_file,
              moved / "plans/0.png");
}

TEST_F(MissionSite, IsNotAskedOfAnOlderMission) {
    makeOfSchema1(file_);
    EXPECT_EQ(*siteIn(file_), std::nullopt);
    EXPECT_EQ(MissionReader::open(file_)->info()->schema, 1);
}

TEST_F(MissionSite, ComesIntoAnOlderMissionThatGoesOn) {
    makeOfSchema1(file_);
    {
        auto mission = writerOf(file_);
        ASSERT_TRUE(mission.writeSite(1.0, kSite));
    }
    EXPECT_EQ(*siteIn(file_), kSite);
    EXPECT_EQ(MissionReader::open(file_)->info()->schema, 3);
}

TEST_F(MissionSite, ThatCannotBeReadIsNamedAsDamage) {
    {
        auto mission = writerOf(file_);
        ASSERT_TRUE(mission.writeSite(1.0, kSite));
    }
    {
        SQLite::Database database(file_.string(), SQLite::OPEN_READWRITE);
        database.exec("UPDATE site SET toml = 'site = 7'");
    }
    const auto site = siteIn(file_);
    ASSERT_FALSE(site);
    EXPECT_EQ(site.error().code, ErrorCode::kMissionDamaged);
    EXPECT_NE(site.error().detail.find("(site):1"), std::string::npos) << site.error().detail;
}

}  // namespace
}  // namespace hedr
