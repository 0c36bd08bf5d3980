#include "core/site/site_file.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fstream>
#include <limits>

#include "core/text/text_file.h"
#include "tests/core/site/random_site.h"
#include "tests/core/text/scratch_folder.h"

namespace hedr {
namespace {

namespace fs = std::filesystem;

// The example of docs/site_file.md, whose every key is used.
std::string example() {
    const auto page = readTextFile(fs::path(HEDR_SOURCE_DIR) / "docs/site_file.md");
    const std::string text = page.value_or("");
    const std::size_t begin = text.find("```toml\n") + 8;
    return text.substr(begin, text.find("```", begin) - begin);
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return text.replace(at, what.size(), by);
}

RC_GTEST_PROP(SiteFile, GivesBackEverySiteToTheLastBit, ()) {
    const Site site = randomSite();
    const auto back = parseSite(siteText(site, "/sites/a"), "x", "/sites/a");
    RC_ASSERT(back.has_value());
    RC_ASSERT(*back == site);
}

TEST(SiteFile, ReadsTheExampleOfTheDocument) {
    const auto site = parseSite(example(), "x", "/plans");
    ASSERT_TRUE(site) << site.error().subject << ' ' << site.error().detail;
    ASSERT_EQ(site->floors.size(), 2U);
    ASSERT_EQ(site->floors[0].plans.size(), 3U);
    EXPECT_EQ(site->floors[0].plans[0].image_file, "/plans/aerial.jpg");
    EXPECT_FALSE(site->floors[0].plans[0].inverted_at_night);
    EXPECT_TRUE(site->floors[0].plans[1].crop);
    const PlacingPoints& placed_by = site->floors[0].plans[1].placed_by;
    ASSERT_EQ(placed_by.points.size(), 3U);
    EXPECT_EQ(placed_by.points[1], (ControlPoint{"lift", {1400.0, 990.0}, {70.0, 0.2}}));
    EXPECT_TRUE(placed_by.keep_rotation && !placed_by.keep_scale);
    EXPECT_EQ(site->floors[0].plans[2].page, 2);
    ASSERT_TRUE(site->floors[0].plans[2].straightened);
    EXPECT_EQ(site->floors[0].plans[2].straightened->quad.corners[3], (Point<Plan>{61.0, 1431.0}));
    ASSERT_EQ(site->floors[0].wall_strokes.size(), 2U);
    EXPECT_EQ(site->floors[0].wall_strokes[1].pen, WallPen::kEraser);
    EXPECT_TRUE(site->direction_rad);
    ASSERT_TRUE(site->geo_tie);
    EXPECT_EQ(site->geo_tie->at, (LatLon{42.2939, -83.7133}));
}

TEST(SiteFile, NamesImagesRelativeToItselfWhereTheyLieBelowIt) {
    const ScratchFolder folder;
    const fs::path file = folder.path() / "a.site.toml";
    Site site{.floors = {{.name = "0"}}};
    site.floors[0].plans = {{.image_file = folder.path() / "plans/0.png"},
                            {.image_file = folder.path().parent_path() / "elsewhere.png"}};
    ASSERT_TRUE(writeSite(site, file));
    const std::string text = *readTextFile(file);
    EXPECT_NE(text.find("image = \"plans/0.png\""), std::string::npos) << text;
    EXPECT_NE(text.find("image = \"/"), std::string::npos) << text;
    EXPECT_EQ(*readSite(file), site);

    const fs::path moved = folder.path() / "moved";
    fs::create_directory(moved);
    fs::rename(file, moved / "a.site.toml");
    EXPECT_EQ(readSite(moved / "a.site.toml")->floors[0].plans[0].image_file,
              moved / "plans/0.png");
}

TEST(SiteFile, TakesAnImageGivenRelativeToTheWorkingFolder) {
    const ScratchFolder folder;
    const Site site{.floors = {{.name = "0", .plans = {{.image_file = "b.png"}}}}};
    ASSERT_TRUE(writeSite(site, folder.path() / "a.site.toml"));
    EXPECT_EQ(readSite(folder.path() / "a.site.toml")->floors[0].plans[0].image_file,
              fs::current_path() / "b.png");
}

struct Bad {
    const char* in_example;
    const char* instead;
    ErrorCode code;
    const char* says;
};

// The line of the text at which two texts begin to differ.
std::size_t firstOtherLine(const std::string& a, const std::string& b) {
    std::size_t line = 1;
    for (std::size_t i = 0; i < a.size() && a[i] == b[i]; ++i) line += a[i] == '\n' ? 1 : 0;
    return line;
}

TEST(SiteFile, SaysWhatIsWrongAndInWhichLine) {
    constexpr auto kBad = ErrorCode::kBadValue;
    for (const Bad& bad :
         {Bad{"site = 1", "site = 2", kBad, "site must be 1"},
          Bad{"site = 1", "site = \"1\"", kBad, "site must be a whole number"},
          Bad{"direction_rad = 0.12", "direction_rad = nan", kBad, "direction_rad must be"},
          Bad{"direction_rad = 0.12", "direction = 0.12", kBad, "unknown key direction"},
          Bad{"latitude_deg = 42", "latitude_deg = 142", kBad, "latitude_deg must be from -90"},
          Bad{"longitude_deg = -83", "longitude_deg = -283", kBad, "longitude_deg must be"},
          Bad{"name = \"Ground floor\"", "name = 0", kBad, "name must be a text"},
          Bad{"image = \"aerial.jpg\"", "image = \"\"", kBad, "image must be the name"},
          Bad{"resolution_m = 0.1", "resolution_m = 0", kBad, "resolution_m must be positive"},
          Bad{"opacity = 0.6", "opacity = 1.6", kBad, "opacity must be from 0 to 1"},
          Bad{"visible = true", "visible = 1", kBad, "visible must be true or false"},
          Bad{"sha256 = \"9f", "sha256 = \"9g", kBad, "sha256 must have 64"},
          Bad{"crop_px = [12.0, 8.5,", "crop_px = [8.5,", kBad, "crop_px must be a list of 4"},
          Bad{"crop_px = [12.0", "crop_px = [99999.0", kBad, "crop_px must be [left"},
          Bad{"points_m = [[0.6, 0.1], ", "points_m = [", kBad, "points_m must hold as many"},
          Bad{"\"lift\"", "7", kBad, "point_names must be a list of texts"},
          Bad{"page = 2", "page = 0", kBad, "page must be from 1"},
          Bad{"straightened_px = [102.0, ", "straightened_px = [", kBad, "must be a list of 8"},
          Bad{"straightened_aspect = 1", "straightened_aspect = -1", kBad, "must be positive"},
          Bad{"pen = \"eraser\"", "pen = \"brush\"", kBad, "pen must be"},
          Bad{"width_m = 0.2", "width_m = -0.2", kBad, "width_m must be positive"},
          Bad{"[4.0, 1.5]", "[4.0]", kBad, "points_m must hold points"},
          Bad{"[4.0, 1.5]", "[4.0, inf]", kBad, "points_m must hold points"},
          Bad{"[geo_tie]", "[geo.tie]", kBad, "unknown key geo"},
          Bad{"[geo_tie]", "[+geo_tie]", ErrorCode::kBadFormat, "key"},
          Bad{"site = 1", "site = ", ErrorCode::kBadFormat, ""},
          Bad{"site = 1", "a.b.c.d = 1", ErrorCode::kBadFormat, "too deep"}}) {
        const std::string text = replaced(example(), bad.in_example, bad.instead);
        const auto site = parseSite(text, "x", "");
        ASSERT_FALSE(site) << bad.instead;
        EXPECT_EQ(site.error().code, bad.code) << bad.instead;
        EXPECT_EQ(site.error().subject, "x:" + std::to_string(firstOtherLine(example(), text)))
            << bad.instead;
        EXPECT_NE(site.error().detail.find(bad.says), std::string::npos) << site.error().detail;
    }
}

TEST(SiteFile, NamesTheKeyThatIsMissingAndItsTable) {
    for (const auto& [text, line, key] :
         {std::tuple{"", "x", "site"}, std::tuple{"site = 1\n[[floor]]\n", "x:2", "name"},
          std::tuple{"site = 1\n[geo_tie]\nlatitude_deg = 1\n", "x:2", "longitude_deg"},
          std::tuple{"site=1\n[[floor]]\nname=\"\"\n[[floor.plan]]\nimage=\"a\"", "x:4",
                     "resolution_m"},
          std::tuple{"site=1\n[[floor]]\nname=\"\"\n[[floor.stroke]]\npen=\"wall\"\nwidth_m=1",
                     "x:4", "points_m"}}) {
        const auto site = parseSite(text, "x", "");
        ASSERT_FALSE(site) << text;
        EXPECT_EQ(site.error().code, ErrorCode::kMissingKey) << text;
        EXPECT_NE(site.error().subject.find(line), std::string::npos) << site.error().subject;
        EXPECT_EQ(site.error().detail, key);
    }
}

TEST(SiteFile, IsNotReplacedByWhatCouldNotBeRead) {
    const ScratchFolder folder;
    const fs::path file = folder.path() / "a.site.toml";
    const Site good{.floors = {{.name = "0"}}};
    ASSERT_TRUE(writeSite(good, file));
    Site bad = good;
    bad.direction_rad = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(writeSite(bad, file).error().code, ErrorCode::kBadValue);
    bad = good;
    bad.floors[0].name = "\xFF";
    EXPECT_EQ(writeSite(bad, file).error().code, ErrorCode::kBadFormat);
    EXPECT_EQ(*readSite(file), good);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
}

TEST(SiteFile, OfAnyDepthIsRefusedWithoutACrash) {
    std::string keys = "site = 1\na";
    for (int i = 0; i < 200000; ++i) keys += ".a";
    EXPECT_EQ(parseSite(keys + " = 1", "x", "").error().code, ErrorCode::kBadFormat);
    std::string lists = "site = 1\na = ";
    for (int i = 0; i < 200000; ++i) lists += "[\n{a.a=";
    EXPECT_EQ(parseSite(lists, "x", "").error().code, ErrorCode::kBadFormat);
    EXPECT_EQ(parseSite(std::string(std::size_t{17} << 20, '\n'), "x", "").error().code,
              ErrorCode::kBadFormat);
}

TEST(SiteFile, TellsThatThereIsNone) {
    EXPECT_EQ(readSite("/no/such.site.toml").error().code, ErrorCode::kFileMissing);
}

}  // namespace
}  // namespace hedr
