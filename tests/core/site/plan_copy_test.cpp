#include "core/site/plan_copy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/site/placement_export.h"
#include "core/site/raster_file.h"
#include "core/text/text_file.h"
#include "tests/core/text/scratch_folder.h"
#include "tests/core/text/small_disk.h"

namespace hedr {
namespace {

namespace fs = std::filesystem;

constexpr int kWidth_px = 60;
constexpr int kHeight_px = 40;
const PlanPlacement kPlacement{0.05, {{12.0, -7.0}, std::numbers::pi / 6}};
const PlanCrop kCrop{{10.2, 5.0}, {40.0, 24.6}};  // the whole pixels 10..40, 5..25

PlanLevel numberedPixels() {
    std::vector<std::uint8_t> pixels(std::size_t{kWidth_px} * kHeight_px);
    for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = static_cast<std::uint8_t>(i * 7);
    return {kWidth_px, kHeight_px, 1,
            std::make_shared<const std::vector<std::uint8_t>>(std::move(pixels))};
}

// The same in strips, as a large tiled file gives them.
PlanLevel inItsFile(const PlanLevel& level) {
    PlanLevel tiled = level;
    tiled.pixels.reset();
    tiled.read_part = [level](const PlanPart& part) { return readPart(level, part); };
    return tiled;
}

class PlanCopies : public testing::Test {
  protected:
    fs::path file(const char* name) const { return folder_.path() / name; }
    PlanCopy copyOf(const PlanLevel& level, PlanCopyKind kind, const char* name) const {
        return {.plan = {file("plan.png"), {level}, kPlacement}, .kind = kind, .file = file(name)};
    }
    std::size_t filesThere() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()));
    }
    ScratchFolder folder_;
};

TEST_F(PlanCopies, OfACropHaveItsPixelsWhereTheyLie) {
    PlanCopy copy = copyOf(numberedPixels(), PlanCopyKind::kPng, "copy.png");
    copy.crop = kCrop;
    const auto files = writePlanCopy(copy);
    ASSERT_TRUE(files) << files.error().detail;
    EXPECT_EQ(*files, (std::vector{file("copy.png"), file("copy.pgw")}));
    const auto back = loadPlan(file("copy.png"));
    ASSERT_TRUE(back) << back.error().detail;
    EXPECT_EQ(back->levels.front().width_px, 30);
    EXPECT_EQ(back->levels.front().height_px, 20);
    EXPECT_EQ(back->levels.front().pixels->front(),
              numberedPixels().pixels->at(5 * kWidth_px + 10));
    const Point<World> expected = worldFromPlan(kPlacement, kHeight_px) * Point<Plan>{25.0, 15.0};
    EXPECT_LT((back->worldFromPlan() * Point<Plan>{15.0, 10.0} - expected).length(), 1e-9);
}

TEST_F(PlanCopies, OfAFileThatStaysOnItsDiskAreThoseOfItsPixels) {
    for (const auto& crop : {std::optional<PlanCrop>(), std::optional(kCrop)}) {
        for (const PlanLevel& level : {numberedPixels(), inItsFile(numberedPixels())}) {
            const char* name = level.pixels ? "memory.yaml" : "file.yaml";
            PlanCopy copy = copyOf(level, PlanCopyKind::kRosMap, name);
            copy.crop = crop;
            ASSERT_TRUE(writePlanCopy(copy));
        }
        EXPECT_EQ(*readTextFile(file("memory.pgm")), *readTextFile(file("file.pgm")));
    }
}

TEST_F(PlanCopies, AreCanceledAtAnyMomentAndLeaveNothing) {
    for (const PlanCopyKind kind :
         {PlanCopyKind::kGeoTiff, PlanCopyKind::kPng, PlanCopyKind::kRosMap}) {
        PlanCopy copy = copyOf(inItsFile(numberedPixels()), kind, "copy");
        copy.geo_tie = GeoTie{{}, {48.0, 11.0}, 0.0};
        for (int asked = 0;; ++asked) {
            int left = asked;
            const auto canceled = writePlanCopy(copy, [&left](double) { return left-- > 0; });
            if (canceled) break;
            ASSERT_EQ(canceled.error().code, ErrorCode::kCanceled) << asked;
            ASSERT_EQ(filesThere(), 0u) << asked;
        }
        const auto written = writePlanCopy(copy);
        ASSERT_TRUE(written);
        for (const fs::path& each : *written) fs::remove(each);
    }
}

TEST_F(PlanCopies, DoNotReplaceTheImageOrAStranger) {
    ASSERT_TRUE(savePlanImage(numberedPixels(), file("plan.png")));
    const auto itself = writePlanCopy(copyOf(numberedPixels(), PlanCopyKind::kPng, "plan.png"));
    ASSERT_FALSE(itself);
    EXPECT_EQ(itself.error().code, ErrorCode::kFileUnwritable);
    ASSERT_TRUE(writeTextFile(file("copy.pgw"), "of another image"));
    const auto stranger = writePlanCopy(copyOf(numberedPixels(), PlanCopyKind::kPng, "copy.png"));
    ASSERT_FALSE(stranger);
    EXPECT_EQ(stranger.error().subject, file("copy.pgw").string());
    EXPECT_EQ(*readTextFile(file("copy.pgw")), "of another image");
    EXPECT_EQ(filesThere(), 2u);
}

TEST_F(PlanCopies, ReplaceTheirOwnFilesOfBefore) {
    const PlanCopy copy = copyOf(numberedPixels(), PlanCopyKind::kRosMap, "copy.yaml");
    ASSERT_TRUE(writePlanCopy(copy));
    EXPECT_TRUE(writePlanCopy(copy));
}

TEST_F(PlanCopies, SayThatAGeoTiffNeedsATie) {
    const auto untied = writePlanCopy(copyOf(numberedPixels(), PlanCopyKind::kGeoTiff, "copy.tif"));
    ASSERT_FALSE(untied);
    EXPECT_EQ(untied.error().code, ErrorCode::kBadValue);
    EXPECT_EQ(filesThere(), 0u);
}

TEST_F(PlanCopies, LeaveNothingOfAnImageWhoseDescriptionCannotBeWritten) {
    fs::create_directory(file("copy.yaml"));
    const auto failed = writePlanCopy(copyOf(numberedPixels(), PlanCopyKind::kRosMap, "copy.yaml"));
    ASSERT_FALSE(failed);
    EXPECT_EQ(filesThere(), 1u);
}

TEST_F(PlanCopies, LeaveNothingOnADiskThatIsFull) {
    const SmallDisk disk(file("disk"), "size=64k");
    if (!disk.mounted()) GTEST_SKIP() << "mounting a small disk needs more rights";
    std::vector<std::uint8_t> noise(std::size_t{1} << 20);
    std::uint32_t state = 1;
    for (std::uint8_t& value : noise) {
        state = 1664525u * state + 1013904223u;
        value = static_cast<std::uint8_t>(state >> 24);
    }
    const PlanLevel large{1024, 1024, 1,
                          std::make_shared<const std::vector<std::uint8_t>>(std::move(noise))};
    for (const PlanCopyKind kind :
         {PlanCopyKind::kGeoTiff, PlanCopyKind::kPng, PlanCopyKind::kRosMap}) {
        PlanCopy copy = copyOf(large, kind, "disk/copy");
        copy.geo_tie = GeoTie{{}, {48.0, 11.0}, 0.0};
        const auto written = writePlanCopy(copy);
        ASSERT_FALSE(written);
        EXPECT_EQ(written.error().code, ErrorCode::kDiskFull)
            << int(kind) << written.error().detail;
        EXPECT_TRUE(fs::is_empty(file("disk")));
    }
}

}  // namespace
}  // namespace hedr
