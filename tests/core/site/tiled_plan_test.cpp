// Large files that are made for being read in parts stay in the file.
#include <gtest/gtest.h>

#include <cmath>
#include <thread>

#include "core/site/plan.h"
#include "tests/core/site/made_images.h"
#include "tests/core/text/scratch_folder.h"

namespace hedr {
namespace {

namespace fs = std::filesystem;

constexpr int kSide_px = 4100;

// A ramp to the right and downwards, so that every place shows where it is.
PlanLevel ramp() {
    const auto pixels = std::make_shared<std::vector<std::uint8_t>>();
    for (int y = 0; y < kSide_px; ++y) {
        for (int x = 0; x < kSide_px; ++x) {
            pixels->push_back(static_cast<std::uint8_t>((x + y) * 255 / (2 * kSide_px)));
        }
    }
    return {kSide_px, kSide_px, 1, pixels};
}

int wanted(double full_x, double full_y) {
    return static_cast<int>((full_x + full_y) * 255 / (2 * kSide_px));
}

class TiledPlan : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        folder_ = std::make_unique<ScratchFolder>();
        makeImage(folder_->path() / "a.tif", ramp(),
                  {.options = {"TILED=YES", "COMPRESS=LZW"}, .overviews = {2, 4, 8}});
    }
    static void TearDownTestSuite() { folder_.reset(); }
    static fs::path file() { return folder_->path() / "a.tif"; }

    static std::unique_ptr<ScratchFolder> folder_;
};

std::unique_ptr<ScratchFolder> TiledPlan::folder_;

TEST_F(TiledPlan, HoldsOnlyItsCoarseLevels) {
    const auto plan = loadPlan(file());
    ASSERT_TRUE(plan) << plan.error().detail;
    std::vector<std::pair<int, bool>> levels;
    for (const PlanLevel& level : plan->levels) {
        levels.emplace_back(level.width_px, level.pixels != nullptr);
    }
    EXPECT_EQ(levels, (std::vector<std::pair<int, bool>>{
                          {4100, false}, {2050, false}, {1025, true}, {513, true}, {257, true}}));
}

TEST_F(TiledPlan, GivesTheSamePlaceFromEveryLevel) {
    const auto plan = loadPlan(file());
    ASSERT_TRUE(plan);
    double factor = 1.0;
    for (const PlanLevel& level : plan->levels) {
        const PlanPart part{level.width_px / 2 + 3, level.height_px / 3, 40, 30};
        const auto pixels = readPart(level, part);
        ASSERT_TRUE(pixels) << level.width_px << ": " << pixels.error().detail;
        ASSERT_EQ(pixels->width_px, 40);
        ASSERT_EQ(pixels->pixels->size(), 1200U);
        EXPECT_NEAR(pixels->pixels->front(),
                    wanted(factor * (part.left_px + 0.5), factor * (part.top_px + 0.5)), 1)
            << level.width_px;
        EXPECT_NEAR(pixels->pixels->back(),
                    wanted(factor * (part.left_px + 39.5), factor * (part.top_px + 29.5)), 2)
            << level.width_px;
        factor *= 2.0;
    }
}

TEST_F(TiledPlan, RefusesPartsBesideALevel) {
    const auto plan = loadPlan(file());
    ASSERT_TRUE(plan);
    for (const PlanLevel& level : {plan->levels.front(), plan->levels.back()}) {
        for (const PlanPart& part :
             {PlanPart{-1, 0, 5, 5}, PlanPart{0, 0, 0, 5}, PlanPart{level.width_px - 2, 0, 5, 5},
              PlanPart{2'000'000'000, 0, 2'000'000'000, 5}}) {
            EXPECT_FALSE(readPart(level, part));
        }
    }
}

TEST_F(TiledPlan, IsReadByManyThreadsAtOnce) {
    const auto plan = loadPlan(file());
    ASSERT_TRUE(plan);
    std::vector<std::thread> threads;
    std::vector<int> wrong(4, 0);
    for (std::size_t t = 0; t < wrong.size(); ++t) {
        threads.emplace_back([&, t, image = *plan] {
            for (int i = 0; i < 20; ++i) {
                const PlanPart part{(i * 397 + static_cast<int>(t) * 811) % 4000, i * 150, 90, 60};
                const auto pixels = readPart(image.levels.front(), part);
                const bool good = pixels && std::abs(pixels->pixels->front() -
                                                     wanted(part.left_px, part.top_px)) <= 1;
                wrong[t] += good ? 0 : 1;
            }
        });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(wrong, std::vector<int>(4, 0));
}

// Deleted, it stays open. Cut off, its parts are errors and its coarse levels stay.
TEST_F(TiledPlan, SurvivesThatItsFileIsCutOffWhileItIsOpen) {
    const fs::path copy = folder_->path() / "copy.tif";
    fs::copy_file(file(), copy);
    const auto plan = loadPlan(copy);
    ASSERT_TRUE(plan);
    fs::resize_file(copy, 1000);
    const auto part = readPart(plan->levels.front(), {3000, 3000, 500, 500});
    ASSERT_FALSE(part);
    EXPECT_EQ(part.error().code, ErrorCode::kNotAnImage);
    EXPECT_TRUE(readWhole(plan->levels.back()));
    fs::remove(copy);
    EXPECT_FALSE(readPart(plan->levels.front(), {3000, 3000, 500, 500}));
}

TEST_F(TiledPlan, GivesAPreviewOfAJpegWithTheSameFrame) {
    const fs::path jpeg = folder_->path() / "a.jpg";
    makeImage(jpeg, ramp(), {.driver = "JPEG"});
    int previews = 0;
    const auto plan = loadPlan(jpeg, {}, [&](const PlanImage& preview) {
        ++previews;
        ASSERT_EQ(preview.levels.size(), 5U);
        EXPECT_EQ(preview.levels[0].width_px, kSide_px);
        EXPECT_FALSE(readWhole(preview.levels[0]));
        const auto coarse = readWhole(preview.levels[2]);
        ASSERT_TRUE(coarse);
        EXPECT_EQ(coarse->width_px, 1025);
        EXPECT_NEAR(coarse->pixels->at(1025 * 512 + 512), wanted(2050.0, 2050.0), 3);
    });
    ASSERT_TRUE(plan);
    EXPECT_EQ(previews, 1);
    EXPECT_TRUE(plan->levels[0].pixels);
}

}  // namespace
}  // namespace hedr
