#include "core/calibration/history/surface_profile.h"

#include <gtest/gtest.h>

#include <fstream>

#include "core/robot/vehicle.h"
#include "core/text/text_file.h"
#include "tests/core/text/scratch_folder.h"

namespace hedr {
namespace {

HistoryEntry entryOf(std::string name, CalibrationRecord record) {
    return {std::move(name), {}, std::move(record)};
}

CalibrationRecord accepted(std::string surface, double wheelbase_m) {
    CalibrationRecord record{
        .procedure = "wheels", .surface = std::move(surface), .verdict = Verdict::kAccepted};
    record.found = {{"wheelbase_m", 0.4, {wheelbase_m, 0.001}},
                    {"gyro_bias_rad_s", 0.0, {0.01, 0.001}}};
    return record;
}

TEST(SurfaceProfiles, HaveTheLatestNumbersOfEachFloor) {
    CalibrationRecord with_widths = accepted("carpet", 0.45);
    with_widths.track_widths = {{0.3, {0.45, 0.01}, 8}};
    const auto profiles =
        surfaceProfiles({entryOf("a", with_widths), entryOf("b", accepted("tiles", 0.41)),
                         entryOf("c", accepted(" carpet ", 0.46))});
    ASSERT_EQ(profiles.size(), 2U);
    EXPECT_EQ(profiles[0].surface, "tiles");
    EXPECT_EQ(profiles[1].surface, "carpet");
    ASSERT_EQ(profiles[1].numbers.size(), 1U) << "a gyro does not depend on the floor";
    EXPECT_EQ(profiles[1].numbers[0].value, 0.46);
    EXPECT_TRUE(profiles[1].numbers[0].margin);
    EXPECT_EQ(profiles[1].numbers[0].entry, "c");
    EXPECT_EQ(profiles[1].track_widths, with_widths.track_widths);
}

TEST(SurfaceProfiles, HaveTheOldNumberWhereItHeld) {
    CalibrationRecord unchanged = accepted("tiles", 0.41);
    unchanged.verdict = Verdict::kUnchanged;
    CalibrationRecord stays = accepted("carpet", 0.41);
    stays.found[0].stays = true;
    const auto profiles = surfaceProfiles({entryOf("a", unchanged), entryOf("b", stays)});
    ASSERT_EQ(profiles.size(), 2U);
    EXPECT_EQ(profiles[0].numbers[0].value, 0.4);
    EXPECT_EQ(profiles[1].numbers[0].value, 0.4);
    EXPECT_FALSE(profiles[1].numbers[0].margin) << "the new value's is not the old one's";
}

TEST(SurfaceProfiles, TakeADifferentSpellingForTheSameFloor) {
    EXPECT_TRUE(isSameSurface(" Floor  2", "floor 2"));
    EXPECT_TRUE(isSameSurface("Fußboden \"neu\"", "fußboden \"neu\""));
    EXPECT_FALSE(isSameSurface("floor 2", "floor2"));
    const auto profiles = surfaceProfiles(
        {entryOf("a", accepted("Carpet", 0.45)), entryOf("b", accepted("carpet", 0.46))});
    ASSERT_EQ(profiles.size(), 1U);
    EXPECT_EQ(profiles[0].surface, "carpet");
    EXPECT_EQ(profiles[0].numbers[0].value, 0.46);
}

// Straight runs tell nothing of a wheelbase, but its wheels have another size now.
TEST(SurfaceProfiles, LetAWheelbaseFollowItsWheels) {
    CalibrationRecord runs = accepted("carpet", 0.404);
    runs.found[0].follows = true;  // was 0.4 m elsewhere
    const auto profiles =
        surfaceProfiles({entryOf("a", accepted("carpet", 0.5)), entryOf("b", runs)});
    ASSERT_EQ(profiles.size(), 1U);
    EXPECT_NEAR(profiles[0].numbers[0].value, 0.505, 1e-12);
    EXPECT_EQ(profiles[0].numbers[0].entry, "a");
    const auto alone = surfaceProfiles({entryOf("b", runs)});
    EXPECT_EQ(alone.at(0).numbers[0].value, 0.404);
    EXPECT_FALSE(alone.at(0).numbers[0].margin);
}

TEST(SurfaceProfiles, AreNotCalibratedByBeingUsed) {
    CalibrationRecord used = accepted("carpet", 0.45);
    used.procedure = "restore";
    used.found.clear();
    const auto profiles =
        surfaceProfiles({entryOf("a", accepted("carpet", 0.45)),
                         entryOf("b", accepted("tiles", 0.41)), entryOf("c", used)});
    ASSERT_EQ(profiles.size(), 2U);
    EXPECT_EQ(profiles[1].surface, "tiles");
}

TEST(SurfaceProfiles, AreNotMadeOfWhatWasNotProven) {
    CalibrationRecord not_proven = accepted("tiles", 0.41);
    not_proven.verdict = Verdict::kNotProven;
    CalibrationRecord refused = accepted("tiles", 0.5);
    refused.verdict = Verdict::kRefused;
    const HistoryEntry damaged{"c", {}, fail(ErrorCode::kBadFormat, "c", "")};
    EXPECT_TRUE(surfaceProfiles({entryOf("a", not_proven), entryOf("b", refused), damaged,
                                 entryOf("d", accepted("", 0.5))})
                    .empty());
}

TEST(SurfaceProfiles, GiveTheVehicleFileTheirNumbersAndKeepWhatItHad) {
    const ScratchFolder folder;
    const auto file = folder.path() / "robot.toml";
    std::ofstream(file) << "# ours\n" << formatVehicle({});
    const std::string before = readTextFile(file).value();
    const auto profiles = surfaceProfiles({entryOf("a", accepted("carpet", 0.45))});
    ASSERT_TRUE(useSurface(file, profiles.at(0), "2026-11-29T10:00:00Z", "Ada"));
    EXPECT_EQ(loadVehicle(file)->geometry.wheelbase_m, 0.45);
    EXPECT_TRUE(readTextFile(file)->starts_with("# ours\n"));
    const auto kept = historyEntry(historyFolderOf(file), "restore");
    ASSERT_TRUE(kept && kept->record);
    EXPECT_EQ(kept->record->vehicle_before, before);
    EXPECT_EQ(kept->record->surface, "carpet");
    EXPECT_FALSE(useSurface(folder.path() / "none.toml", profiles.at(0), "now", ""));
}

TEST(SurfaceProfiles, LieBesideTheWheelbasesOfThisFloor) {
    CalibrationRecord carpet = accepted("carpet", 0.45);
    carpet.track_widths = {{0.3, {0.45, 0.01}, 8}, {0.6, {0.47, 0.01}, 8}};
    const auto profiles = surfaceProfiles({entryOf("a", carpet)});
    Calibration calibration;
    showSurfaces(calibration, profiles, "tiles");
    EXPECT_TRUE(calibration.plots.empty());
    calibration.plots = {{std::string(kTrackWidthPlot)}, {"Drift"}};
    showSurfaces(calibration, profiles, "carpet");
    EXPECT_TRUE(calibration.plots[0].series.empty());
    showSurfaces(calibration, profiles, "tiles");
    ASSERT_EQ(calibration.plots[0].series.size(), 1U);
    EXPECT_EQ(calibration.plots[0].series[0].name, "On carpet");
    EXPECT_EQ(calibration.plots[0].series[0].y, (std::vector{0.45, 0.47}));
    EXPECT_TRUE(calibration.plots[1].series.empty());
}

}  // namespace
}  // namespace hedr
