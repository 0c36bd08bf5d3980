#include "core/site/placement_file.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fstream>

#include "core/geometry/angle.h"
#include "tests/core/text/scratch_folder.h"

namespace hedr {
namespace {

namespace fs = std::filesystem;

fs::path written(const std::string& name, const std::string& text) {
    static const ScratchFolder folder;
    std::ofstream(folder.path() / name) << text;
    return folder.path() / name;
}

Result<PlacementFile> toml(const std::string& text) {
    return loadPlacement(written("plan.toml", text));
}
Result<PlacementFile> yaml(const std::string& text) {
    return loadPlacement(written("map.yaml", text));
}

TEST(Placement, ReadsOurOwnFormat) {
    const auto file = toml(
        "image = \"first floor.png\"\nresolution_m = 0.02\n"
        "origin_x_m = -3\norigin_y_m = 4.5\nrotation_deg = 90.0\n");
    ASSERT_TRUE(file) << file.error().detail;
    EXPECT_EQ(file->image_file.filename(), "first floor.png");
    EXPECT_TRUE(file->image_file.is_absolute());
    EXPECT_EQ(file->placement, (PlanPlacement{0.02, {{-3.0, 4.5}, radFromDeg(90.0)}}));
}

TEST(Placement, LiesAtTheOriginWhereNothingElseIsSaid) {
    const auto file = toml("image = \"a.png\"\nresolution_m = 1\n");
    ASSERT_TRUE(file);
    EXPECT_EQ(file->placement, (PlanPlacement{1.0, {}}));
}

TEST(Placement, ReadsARosMap) {
    const auto file = yaml(
        "%YAML 1.1\n---\n# a map\nimage: map.pgm  # beside this file\nresolution: 0.1\n"
        "origin:  [-26.00000, -11.0, 0.5]\r\nnegate: 0\noccupied_thresh: 0.65\n\n");
    ASSERT_TRUE(file) << file.error().detail;
    EXPECT_EQ(file->image_file.filename(), "map.pgm");
    EXPECT_EQ(file->placement, (PlanPlacement{0.1, {{-26.0, -11.0}, 0.5}}));
}

TEST(Placement, TakesAQuotedAndAnAbsoluteImageName) {
    const auto file = yaml("image: \"/maps/a b.pgm\"\nresolution: 0.1\norigin: [0, 0., 0]\n");
    ASSERT_TRUE(file);
    EXPECT_EQ(file->image_file, "/maps/a b.pgm");
}

void expectError(const Result<PlacementFile>& result, ErrorCode code, const std::string& place,
                 const std::string& key) {
    ASSERT_FALSE(result) << place;
    EXPECT_EQ(result.error().code, code) << result.error().detail;
    EXPECT_TRUE(result.error().subject.ends_with(place)) << result.error().subject;
    EXPECT_NE(result.error().detail.find(key), std::string::npos) << result.error().detail;
}

TEST(Placement, NamesTheKeyThatIsMissing) {
    expectError(toml("resolution_m = 1\n"), ErrorCode::kMissingKey, "plan.toml", "image");
    expectError(toml("image = \"a\"\n"), ErrorCode::kMissingKey, "plan.toml", "resolution_m");
    expectError(yaml("resolution: 1\n"), ErrorCode::kMissingKey, "map.yaml", "image");
    expectError(yaml("image: a\nresolution: 1\n"), ErrorCode::kMissingKey, "map.yaml", "origin");
}

TEST(Placement, NamesLineAndKeyOfABadValue) {
    constexpr auto kBad = ErrorCode::kBadValue;
    expectError(toml("image = \"a\"\nresolution_m = 0\n"), kBad, "plan.toml:2",
                "resolution_m is 0");
    expectError(toml("image = \"a\"\nresolution_m = \"x\"\n"), kBad, "plan.toml:2", "resolution_m");
    expectError(toml("image = 3\nresolution_m = 1\n"), kBad, "plan.toml:1", "image");
    expectError(toml("image = \"a\"\nresolution_m = 1\nrotation_deg = nan\n"), kBad, "plan.toml:3",
                "rotation_deg");
    expectError(toml("image = \"a\"\nresolution_m = 1\nrotation = 3\n"), kBad, "plan.toml:3",
                "unknown key rotation");
    expectError(yaml("image: a\nresolution: -0.1\norigin: [0, 0, 0]\n"), kBad, "map.yaml:2",
                "resolution is -0.1");
    expectError(yaml("image: a\nresolution: 1\norigin: [0, 0]\n"), kBad, "map.yaml:3", "origin");
    expectError(yaml("image: a\nresolution: 1\norigin: here\n"), kBad, "map.yaml:3", "origin");
}

TEST(Placement, NamesTheLineThatIsNoTomlOrYaml) {
    expectError(toml("image = \"a\"\nresolution_m = = 1\n"), ErrorCode::kBadFormat, "plan.toml:2",
                "");
    expectError(yaml("image: a\nwhat is this\n"), ErrorCode::kBadFormat, "map.yaml:2", "");
}

TEST(Placement, RefusesAKeyOfAHundredThousandLevels) {
    std::string deep = "a";
    for (int i = 0; i < 100000; ++i) deep += ".a";
    expectError(toml(deep + " = 1\n"), ErrorCode::kBadFormat, "plan.toml", "16384 at most");
}

TEST(Placement, SaysThatTheFileIsMissing) {
    expectError(loadPlacement("/no/plan.toml"), ErrorCode::kFileMissing, "/no/plan.toml", "");
}

RC_GTEST_PROP(Placement, ReadsBackWhatItWrote, (double x, double y)) {
    const auto resolution = 1e-3 * *rc::gen::inRange(1, 100000);
    const auto degrees = *rc::gen::inRange(-180, 181);
    const PlacementFile file{"plan \"1\".png", {resolution, {{x, y}, radFromDeg(degrees)}}};
    const fs::path path = written("round_trip.toml", "");
    RC_ASSERT(savePlacement(file, path).has_value());
    const auto again = loadPlacement(path);
    RC_ASSERT(again.has_value());
    RC_ASSERT(again->image_file.filename() == file.image_file);
    RC_ASSERT(again->placement.resolution_m == resolution);
    RC_ASSERT(again->placement.origin.position == file.placement.origin.position);
    RC_ASSERT(std::abs(again->placement.origin.heading_rad - radFromDeg(degrees)) < 1e-12);
}

RC_GTEST_PROP(Placement, NeverCrashesOnAnyText, (const std::string& text)) {
    static_cast<void>(toml(text));
    static_cast<void>(yaml(text));
    static_cast<void>(yaml("image: a\nresolution: " + text));
}

}  // namespace
}  // namespace hedr
