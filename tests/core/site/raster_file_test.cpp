#include "core/site/raster_file.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "tests/core/site/read_raster.h"
#include "tests/core/text/scratch_folder.h"

namespace hedr {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;

const fs::path kImages = fs::path(HEDR_SOURCE_DIR) / "tests/core/site/images";
const fs::path kFloorPlans = fs::path(HEDR_SOURCE_DIR) / "../shared/data/maps/floor_plans";

fs::path scratch(const std::string& name) {
    static const ScratchFolder folder;
    return folder.path() / name;
}

std::string bytesOf(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

PlanLevel image(const std::string& name) {
    auto result = readRaster(kImages / name);
    if (!result) ADD_FAILURE() << name << ": " << result.error().detail;
    return result.value_or(PlanLevel{0, 0, 1, std::make_shared<Bytes>()});
}

Bytes pixels(const std::string& name) { return *image(name).pixels; }

TEST(ReadRaster, KeepsGreyAsOneByteWhateverItsDepth) {
    EXPECT_EQ(pixels("grey16.png"), (Bytes{0, 128, 255}));
    EXPECT_EQ(pixels("grey4.png"), (Bytes{0, 85, 170, 255}));
    EXPECT_EQ(pixels("grey_palette.png"), (Bytes{0, 85, 170, 255}));
    for (const char* bits : {"bits.png", "bits.tif", "bits_fax.tif"}) {
        EXPECT_EQ(pixels(bits), (Bytes{255, 0, 255, 0, 0, 255, 0, 255})) << bits;
        EXPECT_EQ(image(bits).channels, 1) << bits;
    }
}

TEST(ReadRaster, TurnsColourIntoBlueGreenRedAlpha) {
    EXPECT_EQ(pixels("colour_palette.png"), (Bytes{0, 0, 255, 255, 0, 255, 0, 255,  //
                                                   255, 0, 0, 255, 255, 255, 255, 255}));
    EXPECT_EQ(pixels("colour16.png"), (Bytes{30, 200, 10, 255, 30, 200, 10, 255}));
    const Bytes bitmap = pixels("colour.bmp");
    EXPECT_EQ(Bytes(bitmap.begin(), bitmap.begin() + 4), (Bytes{30, 20, 10, 255}));
    for (const char* jpeg : {"colour.jpg", "cmyk.jpg"}) {
        const Bytes found = pixels(jpeg);
        EXPECT_NEAR(found[0], 50, 3) << jpeg;
        EXPECT_NEAR(found[1], 100, 3) << jpeg;
        EXPECT_NEAR(found[2], 200, 3) << jpeg;
    }
}

TEST(ReadRaster, LaysWhatIsTransparentOnWhite) {
    EXPECT_EQ(pixels("alpha.png"), (Bytes{0, 0, 255, 255, 255, 128, 128, 255,  //
                                          0, 0, 0, 255, 255, 255, 255, 255}));
    EXPECT_EQ(pixels("grey_alpha.png"), (Bytes{127, 191}));
    EXPECT_EQ(pixels("palette_transparent.png"), (Bytes{0, 0, 0, 255, 255, 255, 255, 255}));
}

TEST(ReadRaster, ReportsProgressUpToTheEnd) {
    double last = -1.0;
    ASSERT_TRUE(readRaster(kImages / "colour.bmp", [&](double share) {
        EXPECT_GE(share, last);
        last = share;
        return true;
    }));
    EXPECT_EQ(last, 1.0);
}

TEST(ReadRaster, StopsWhenItIsCanceled) {
    const auto result = readRaster(kImages / "colour.bmp", [](double) { return false; });
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::kCanceled);
}

TEST(ReadRaster, NamesTheFileThatIsMissing) {
    const auto result = readRaster("/no/such/plan.png");
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::kFileMissing);
    EXPECT_EQ(result.error().subject, "/no/such/plan.png");
}

TEST(ReadRaster, RefusesAFolder) {
    const auto result = readRaster(kImages);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::kFileUnreadable);
}

TEST(ReadRaster, RefusesWhatIsNoImageAndSaysNothingOnTheTerminal) {
    std::ofstream(scratch("letter.png")) << "Dear operator,\n";
    std::ofstream(scratch("empty.png"));
    testing::internal::CaptureStderr();
    const auto letter = readRaster(scratch("letter.png"));
    ASSERT_FALSE(letter);
    EXPECT_EQ(letter.error().code, ErrorCode::kNotAnImage);
    EXPECT_EQ(letter.error().detail, "not a known image format");
    const auto empty = readRaster(scratch("empty.png"));
    ASSERT_FALSE(empty);
    EXPECT_EQ(empty.error().code, ErrorCode::kFileEmpty);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(ReadRaster, RefusesMorePixelsThanMemoryTakes) {
    std::ofstream(scratch("huge.pgm")) << "P5\n60000 60000\n255\n";
    const auto result = readRaster(scratch("huge.pgm"));
    ASSERT_FALSE(result);
    EXPECT_TRUE(result.error().code == ErrorCode::kImageTooLarge ||
                result.error().code == ErrorCode::kNotAnImage);
}

// Many lengths of a few formats: an error or an image of the full size, never a crash.
TEST(ReadRaster, SurvivesFilesThatAreCutAnywhere) {
    testing::internal::CaptureStderr();
    for (const char* name :
         {"alpha.png", "grey4.png", "colour.jpg", "bits_fax.tif", "colour.bmp"}) {
        const std::string whole = bytesOf(kImages / name);
        const fs::path cut = scratch(std::string("cut_") + name);
        for (std::size_t size = 1; size < whole.size(); size += 3) {
            std::ofstream(cut, std::ios::binary).write(whole.data(), static_cast<long>(size));
            const auto result = readRaster(cut);
            if (result) {
                EXPECT_EQ(result->pixels->size(),
                          static_cast<std::size_t>(result->width_px * result->height_px *
                                                   result->channels));
            } else {
                EXPECT_EQ(result.error().code, ErrorCode::kNotAnImage) << name << ' ' << size;
            }
        }
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(ReadRaster, SurvivesRealPicturesThatAreCut) {
    if (!fs::exists(kFloorPlans)) GTEST_SKIP() << "the recordings are not at " << kFloorPlans;
    for (const char* name : {"plan1.png", "plan6_photo_of_hand_drawing.jpg"}) {
        const std::string whole = bytesOf(kFloorPlans / name);
        for (const double share : {0.02, 0.5, 0.98}) {
            const auto size = static_cast<long>(share * static_cast<double>(whole.size()));
            const fs::path cut = scratch(std::string("cut_") + name);
            std::ofstream(cut, std::ios::binary).write(whole.data(), size);
            const auto result = readRaster(cut);
            if (!result) {
                EXPECT_EQ(result.error().code, ErrorCode::kNotAnImage);
            }
        }
    }
}

TEST(SavePlanImage, WritesWhatReadRasterReads) {
    const auto grey = std::make_shared<const Bytes>(Bytes{0, 10, 20, 30, 40, 255});
    const auto colour = std::make_shared<const Bytes>(Bytes{1, 2, 3, 255, 200, 100, 50, 255});
    ASSERT_TRUE(savePlanImage({3, 2, 1, grey}, scratch("grey.png")));
    ASSERT_TRUE(savePlanImage({1, 2, 4, colour}, scratch("colour.png")));
    const auto grey_again = readRaster(scratch("grey.png"));
    ASSERT_TRUE(grey_again);
    EXPECT_EQ(grey_again->width_px, 3);
    EXPECT_EQ(*grey_again->pixels, *grey);
    EXPECT_EQ(*readRaster(scratch("colour.png"))->pixels, *colour);
}

TEST(SavePlanImage, SaysWhereItCannotWrite) {
    const auto result =
        savePlanImage({1, 1, 1, std::make_shared<const Bytes>(1)}, "/no/such/folder/plan.png");
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::kFileUnwritable);
    EXPECT_EQ(result.error().subject, "/no/such/folder/plan.png");
}

}  // namespace
}  // namespace hedr
