#include "core/site/plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "core/geometry/angle.h"
#include "tests/core/text/scratch_folder.h"

namespace hedr {
namespace {

namespace fs = std::filesystem;

const fs::path kData = fs::path(HEDR_SOURCE_DIR) / "../shared/data";

fs::path emptyFolder(const std::string& name) {
    static const ScratchFolder scratch;
    const fs::path folder = scratch.path() / name;
    fs::remove_all(folder);
    fs::create_directories(folder);
    return folder;
}

void write(const fs::path& file, const std::string& text) { std::ofstream(file) << text; }

// 4 x 2 pixels.
const std::string kSmallPgm = "P5\n4 2\n255\nabcdefgh";

TEST(LoadPlan, TakesThePlacementBesideAnImage) {
    const fs::path folder = emptyFolder("beside");
    write(folder / "map.pgm", kSmallPgm);
    write(folder / "map.yaml", "image: map.pgm\nresolution: 0.5\norigin: [1, 2, 0]\n");
    const auto plan = loadPlan(folder / "map.pgm");
    ASSERT_TRUE(plan) << plan.error().detail;
    EXPECT_EQ(plan->placement.resolution_m, 0.5);
    EXPECT_EQ(plan->placement.origin.position, (Point<World>{1.0, 2.0}));
    EXPECT_FALSE(plan->placement_is_guess);
}

TEST(LoadPlan, PassesOverAPlacementOfAnotherImage) {
    const fs::path folder = emptyFolder("other");
    write(folder / "map.pgm", kSmallPgm);
    write(folder / "map.toml", "image = \"other.pgm\"\nresolution_m = 0.5\n");
    const auto plan = loadPlan(folder / "map.pgm");
    ASSERT_TRUE(plan);
    EXPECT_EQ(plan->placement, PlanPlacement{});
    EXPECT_TRUE(plan->placement_is_guess);
}

TEST(LoadPlan, FindsTheImageThatAPlacementNames) {
    const fs::path folder = emptyFolder("named");
    fs::create_directories(folder / "pictures");
    write(folder / "pictures/a.pgm", kSmallPgm);
    write(folder / "plan.toml", "image = \"pictures/a.pgm\"\nresolution_m = 2\n");
    const auto plan = loadPlan(folder / "plan.toml");
    ASSERT_TRUE(plan) << plan.error().detail;
    EXPECT_EQ(plan->image_file, folder / "pictures/a.pgm");
    EXPECT_EQ(plan->levels.front().width_px, 4);
}

TEST(LoadPlan, NamesBothFilesWhenTheNamedImageIsMissing) {
    const fs::path folder = emptyFolder("missing");
    write(folder / "map.yaml", "image: gone.pgm\nresolution: 0.5\norigin: [1, 2, 0]\n");
    const auto plan = loadPlan(folder / "map.yaml");
    ASSERT_FALSE(plan);
    EXPECT_EQ(plan.error().code, ErrorCode::kFileMissing);
    EXPECT_EQ(plan.error().subject, (folder / "gone.pgm").string());
    EXPECT_NE(plan.error().detail.find("map.yaml"), std::string::npos);
}

TEST(LoadPlan, LoadsOnePixel) {
    const fs::path folder = emptyFolder("one");
    write(folder / "one.pgm", "P5\n1 1\n255\nx");
    const auto plan = loadPlan(folder / "one.pgm");
    ASSERT_TRUE(plan);
    EXPECT_EQ(plan->levels.size(), 1U);
    EXPECT_EQ(plan->levels.front().pixels->front(), 'x');
}

TEST(LoadPlan, StopsWhenItIsCanceled) {
    const fs::path folder = emptyFolder("cancel");
    write(folder / "map.pgm", kSmallPgm);
    for (const double until : {0.0, 0.95}) {
        const auto plan = loadPlan(folder / "map.pgm", [&](double done) { return done < until; });
        ASSERT_FALSE(plan);
        EXPECT_EQ(plan.error().code, ErrorCode::kCanceled);
    }
}

TEST(LoadPlan, SaysWhyAnImageIsNone) {
    const fs::path folder = emptyFolder("letter");
    write(folder / "plan.png", "Dear operator,");
    const auto plan = loadPlan(folder / "plan.png");
    ASSERT_FALSE(plan);
    EXPECT_EQ(plan.error().code, ErrorCode::kNotAnImage);
    EXPECT_EQ(plan.error().subject, (folder / "plan.png").string());
    EXPECT_FALSE(plan.error().detail.empty());
}

void expectNear(Point<World> found, Point<World> wanted) {
    EXPECT_NEAR(found.x, wanted.x, 1e-12);
    EXPECT_NEAR(found.y, wanted.y, 1e-12);
}

TEST(PlanImage, HasItsOriginInTheLowerLeftCorner) {
    PlanImage plan{{}, {{4, 2, 1, {}}}, {0.5, {{10.0, 20.0}, 0.0}}};
    expectNear(plan.worldFromPlan() * Point<Plan>{0.0, 2.0}, {10.0, 20.0});
    expectNear(plan.worldFromPlan() * Point<Plan>{4.0, 0.0}, {12.0, 21.0});
    plan.placement.origin.heading_rad = radFromDeg(90.0);
    expectNear(plan.worldFromPlan() * Point<Plan>{0.0, 2.0}, {10.0, 20.0});
    expectNear(plan.worldFromPlan() * Point<Plan>{4.0, 0.0}, {9.0, 22.0});
}

TEST(LoadPlan, LoadsEveryRealMap) {
    if (!fs::exists(kData)) GTEST_SKIP() << "the recordings are not at " << kData;
    int maps = 0;
    for (const auto& entry : fs::recursive_directory_iterator(kData)) {
        if (entry.path().filename() != "map.yaml") continue;
        const auto plan = loadPlan(entry.path());
        ASSERT_TRUE(plan) << entry.path() << ' ' << plan.error().detail;
        EXPECT_EQ(plan->levels.front().channels, 1) << entry.path();
        EXPECT_GT(plan->levels.front().width_px, 50) << entry.path();
        ++maps;
    }
    EXPECT_GE(maps, 10);
}

TEST(LoadPlan, LoadsEveryRealFloorPlanAndAerialPhoto) {
    if (!fs::exists(kData)) GTEST_SKIP() << "the recordings are not at " << kData;
    constexpr std::array kPictures = {".png", ".jpg", ".tif", ".tiff"};
    for (const char* folder : {"maps/floor_plans", "maps/aerial"}) {
        for (const auto& entry : fs::directory_iterator(kData / folder)) {
            if (std::ranges::find(kPictures, entry.path().extension()) == kPictures.end()) continue;
            const auto plan = loadPlan(entry.path());
            ASSERT_TRUE(plan) << entry.path() << ' ' << plan.error().detail;
        }
    }
}

}  // namespace
}  // namespace hedr
