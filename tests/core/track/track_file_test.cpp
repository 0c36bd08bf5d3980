#include "core/track/track_file.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "core/geometry/angle.h"
#include "tests/core/text/scratch_folder.h"

namespace hedr {
namespace {

const std::filesystem::path kRecordings = HEDR_SOURCE_DIR "/../shared/data";

class TrackFile : public testing::Test {
  protected:
    Result<std::vector<TrackPoint>> load(const std::string& text) {
        std::ofstream(file_, std::ios::binary) << text;
        return loadTrack(file_);
    }
    std::vector<TrackPoint> trackOf(const std::string& text) {
        const auto track = load(text);
        EXPECT_TRUE(track) << track.error().subject << ": " << track.error().detail;
        return track.value_or(std::vector<TrackPoint>{});
    }

    ScratchFolder folder_;
    std::filesystem::path file_ = folder_.path() / "track.csv";
};

TEST_F(TrackFile, ReadsTheFourColumnsAndSkipsOthers) {
    const auto track = trackOf("t_s,x_m,y_m,heading_rad,var_x_m2\n1,2,3,0.5,7\n");
    EXPECT_EQ(track, (std::vector<TrackPoint>{{1.0, {{2.0, 3.0}, 0.5}, 0.0}}));
}

TEST_F(TrackFile, ReadsTheGyroBiasWhereThereIsOne) {
    const auto track =
        trackOf("t_s,x_m,y_m,heading_rad,gyro_bias_rad_s\n1,2,3,0.5,1e-3\n2,2,3,0,\n");
    EXPECT_EQ(track[0].gyro_bias_rad_s, 1e-3);
    EXPECT_EQ(track[1].gyro_bias_rad_s, 0.0);
}

TEST_F(TrackFile, KeepsVariancesAndTheirAbsence) {
    const std::vector<TrackPoint> track{{1.0, {{2.0, 3.0}, 0.5}, 0.0, {0.5F, -0.25F, 2.0F, 0.125F}},
                                        {2.0, {{2.0, 3.0}, 0.5}, 1e-3}};
    ASSERT_TRUE(saveTrack(file_, track));
    EXPECT_EQ(loadTrack(file_).value(), track);
}

TEST_F(TrackFile, LeavesAHeadingThatIsNotThereUnknown) {
    EXPECT_TRUE(std::isnan(trackOf("t_s,x_m,y_m\n1,2,3\n")[0].pose.heading_rad));
    EXPECT_TRUE(std::isnan(trackOf("t_s,x_m,y_m,heading_rad\n1,2,3,nan\n")[0].pose.heading_rad));
}

TEST_F(TrackFile, UnwrapsHeadingsAlongTheTrack) {
    const auto track = trackOf("t_s,x_m,y_m,heading_rad\n0,0,0,3\n1,0,0,nan\n2,0,0,-3\n3,0,0,3\n");
    EXPECT_EQ(track[0].pose.heading_rad, 3.0);
    EXPECT_NEAR(track[2].pose.heading_rad, 2.0 * kPi - 3.0, 1e-12);
    EXPECT_EQ(track[3].pose.heading_rad, 3.0);
}

TEST_F(TrackFile, ReadsTum) {
    const auto track =
        trackOf("# t x y z qx qy qz qw\n1.5 2 -3 0 0 0 0.479425538604203 0.877582561890373\n");
    ASSERT_EQ(track.size(), 1U);
    EXPECT_EQ(track[0].t_s, 1.5);
    EXPECT_EQ(track[0].pose.position, (Point<World>{2.0, -3.0}));
    EXPECT_NEAR(track[0].pose.heading_rad, 1.0, 1e-12);
}

TEST_F(TrackFile, ReadsTumThatIsPartedByTabsAndPadded) {
    EXPECT_EQ(trackOf("  1\t2   3 0 0 0 0 1 \r\n\n2 2 3 0 0 0 0 1")[0].pose.position,
              (Point<World>{2.0, 3.0}));
}

TEST_F(TrackFile, ReadsBothFormatsBehindAByteOrderMarkAndComments) {
    const std::vector<TrackPoint> expected{{1.0, {{2.0, 3.0}, 0.0}, 0.0}};
    for (const std::string before : {"", "# made by hand, on Monday\n\n#\n"}) {
        for (const std::string mark : {"", "\xEF\xBB\xBF"}) {
            EXPECT_EQ(trackOf(mark + before + "1 2 3 0 0 0 0 1\n"), expected);
            EXPECT_EQ(trackOf(mark + before + "t_s,x_m,y_m,heading_rad\n# far\n1,2,3,0\n"),
                      expected);
        }
    }
}

TEST_F(TrackFile, TakesAQuaternionOfAnyLength) {
    EXPECT_NEAR(trackOf("0 0 0 0 0 0 3 3\n")[0].pose.heading_rad, kPi / 2.0, 1e-12);
}

TEST_F(TrackFile, NamesLineAndColumnOfABadField) {
    const auto csv = load("t_s,x_m,y_m,heading_rad\n1,2,3,4\n1,2,north,4\n");
    EXPECT_EQ(csv.error().code, ErrorCode::kBadFormat);
    EXPECT_EQ(csv.error().subject, file_.string() + ":3");
    EXPECT_EQ(csv.error().detail, "y_m is \"north\", must be a number");
    const auto tum = load("1 2 3 0 0 0 0 1\n1 2 3 0 0 0 1\n");
    EXPECT_EQ(tum.error().code, ErrorCode::kBadFormat);
    EXPECT_EQ(tum.error().subject, file_.string() + ":2");
}

TEST_F(TrackFile, TellsWhatIsMissing) {
    EXPECT_EQ(loadTrack(folder_.path() / "none.csv").error().code, ErrorCode::kFileMissing);
    EXPECT_EQ(load("").error().code, ErrorCode::kFileEmpty);
    EXPECT_EQ(load("# nothing\n").error().code, ErrorCode::kFileEmpty);
    EXPECT_EQ(load("t_s,x_m,y_m,heading_rad\n").error().code, ErrorCode::kFileEmpty);
    EXPECT_EQ(load("t_s,x_m,heading_rad\n1,2,3\n").error().detail, "y_m");
}

std::vector<TrackPoint> anyTrack() {
    std::vector<TrackPoint> track;
    const int count = *rc::gen::inRange(1, 30);
    double heading = *rc::gen::inRange(-300, 300) / 100.0;
    for (int i = 0; i < count; ++i) {
        const auto number = [] { return *rc::gen::inRange(-1000000, 1000000) / 7.0; };
        heading += *rc::gen::inRange(-300, 300) / 100.0;
        track.push_back({i / 7.0, {{number(), number()}, heading}, number() * 1e-9});
    }
    return track;
}

RC_GTEST_FIXTURE_PROP(TrackFile, WritesCsvThatReadsBackToTheLastBit, ()) {
    const auto track = anyTrack();
    RC_ASSERT(saveTrack(file_, track).has_value());
    const auto read = loadTrack(file_);
    RC_ASSERT(read.has_value());
    RC_ASSERT(*read == track);
}

RC_GTEST_FIXTURE_PROP(TrackFile, WritesTumThatReadsBackButForFullTurns, ()) {
    const auto track = anyTrack();
    const auto file = folder_.path() / "track.tum";
    RC_ASSERT(saveTrack(file, track).has_value());
    const auto read = loadTrack(file);
    RC_ASSERT(read.has_value());
    RC_ASSERT(read->size() == track.size());
    const double turns = read->front().pose.heading_rad - track.front().pose.heading_rad;
    RC_ASSERT(std::abs(wrapAngle(turns)) < 1e-9);
    for (std::size_t i = 0; i < track.size(); ++i) {
        RC_ASSERT((*read)[i].t_s == track[i].t_s);
        RC_ASSERT((*read)[i].pose.position == track[i].pose.position);
        RC_ASSERT(std::abs((*read)[i].pose.heading_rad - track[i].pose.heading_rad - turns) < 1e-9);
    }
}

TEST_F(TrackFile, KeepsAnUnknownHeadingUnknownInBothFormats) {
    const std::vector<TrackPoint> track = {{0.0, {{1.0, 2.0}, std::nan("")}, 0.0}};
    for (const char* name : {"t.csv", "t.tum", "t.txt"}) {
        ASSERT_TRUE(saveTrack(folder_.path() / name, track));
        const auto read = loadTrack(folder_.path() / name);
        ASSERT_TRUE(read);
        EXPECT_TRUE(std::isnan(read->front().pose.heading_rad)) << name;
    }
}

TEST_F(TrackFile, ReadsEveryRecordedTruth) {
    if (!std::filesystem::exists(kRecordings)) GTEST_SKIP() << kRecordings << " is not here";
    int count = 0;
    for (const auto& folder : std::filesystem::directory_iterator(kRecordings)) {
        const auto file = folder.path() / "truth.csv";
        if (!std::filesystem::exists(file)) continue;
        const auto track = loadTrack(file);
        ASSERT_TRUE(track) << track.error().subject << ": " << track.error().detail;
        ++count;
    }
    EXPECT_GT(count, 10);
}

}  // namespace
}  // namespace hedr
