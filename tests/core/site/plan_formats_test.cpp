// Every format that a plan comes in, and what is wrong with some files.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <fstream>

#include "core/geometry/angle.h"
#include "core/site/plan.h"
#include "core/text/text_file.h"
#include "tests/core/site/made_images.h"
#include "tests/core/text/scratch_folder.h"

namespace hedr {
namespace {

namespace fs = std::filesystem;

const fs::path kImages = fs::path(HEDR_SOURCE_DIR) / "tests/core/site/images";

class PlanFormats : public testing::Test {
  protected:
    fs::path at(const std::string& name) const { return folder_.path() / name; }
    fs::path write(const std::string& name, const std::string& bytes) const {
        writeBytes(at(name), bytes);
        return at(name);
    }
    fs::path make(const std::string& name, const ImageMaking& making, int channels = 4) const {
        makeImage(at(name), markedPaper(120, 80, channels), making);
        return at(name);
    }

  private:
    ScratchFolder folder_;
};

PlanImage loaded(const fs::path& file, const PlanChoice& choice = {}) {
    auto plan = loadPlan(file, {}, {}, choice);
    if (!plan) ADD_FAILURE() << file << ": " << plan.error().detail;
    return plan.value_or(PlanImage{{}, {{0, 0, 1, nullptr}}});
}

Error errorOf(const fs::path& file, const PlanChoice& choice = {}) {
    const auto plan = loadPlan(file, {}, {}, choice);
    EXPECT_FALSE(plan) << file;
    if (plan) return {};
    EXPECT_LT(plan.error().detail.size(), 200U) << plan.error().detail;
    return plan.error();
}

int greyAt(const PlanLevel& level, int x, int y) {
    const int at = (y * level.width_px + x) * level.channels;
    return (*level.pixels)[static_cast<std::size_t>(at)];
}

// Black in the upper left corner and white elsewhere, as markedPaper makes it.
void expectMarked(const PlanLevel& level, const std::string& what) {
    ASSERT_TRUE(level.pixels) << what;
    const int w = level.width_px;
    const int h = level.height_px;
    EXPECT_LT(greyAt(level, w / 12, h / 8), 60) << what;
    EXPECT_GT(greyAt(level, w - w / 12, h / 8), 200) << what;
    EXPECT_GT(greyAt(level, w / 12, h - h / 8), 200) << what;
    EXPECT_GT(greyAt(level, w / 2, h / 2), 200) << what;
}

TEST_F(PlanFormats, ReadsTheUsualImages) {
    for (const auto& [name, driver] :
         {std::pair{"a.png", "PNG"}, std::pair{"a.jpg", "JPEG"}, std::pair{"a.bmp", "BMP"},
          std::pair{"a.tif", "GTiff"}, std::pair{"a.webp", "WEBP"}}) {
        const PlanImage plan = loaded(make(name, {.driver = driver}));
        EXPECT_EQ(plan.levels[0].width_px, 120) << name;
        expectMarked(plan.levels[0], name);
        EXPECT_EQ(plan.placement, PlanPlacement{}) << name;
        EXPECT_FALSE(plan.geo_tie) << name;
    }
}

TEST_F(PlanFormats, KnowsAnImageWhateverItsNameIs) {
    make("a.png", {.driver = "PNG"});
    fs::rename(at("a.png"), at("a.jpg"));
    expectMarked(loaded(at("a.jpg")).levels[0], "PNG named .jpg");
    write("b.png", pdfText({{120, 80}}));
    expectMarked(loaded(at("b.png")).levels[0], "PDF named .png");
}

TEST_F(PlanFormats, TurnsAPhotoAsItsCameraWasHeld) {
    makeImage(at("a.jpg"), markedPaper(120, 80, 4), {.driver = "JPEG"});
    const std::string upright = bytesOf(at("a.jpg"));
    // Where the block of the upper left corner comes to lie: right, bottom, on its side.
    constexpr std::array<std::array<bool, 3>, 8> kPlaces = {
        {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
    for (int orientation = 1; orientation <= 8; ++orientation) {
        const auto [right, bottom, side] = kPlaces[static_cast<std::size_t>(orientation - 1)];
        write("b.jpg", withExifOrientation(upright, orientation));
        const PlanLevel level = loaded(at("b.jpg")).levels[0];
        ASSERT_EQ(level.width_px, side ? 80 : 120) << orientation;
        ASSERT_EQ(level.height_px, side ? 120 : 80) << orientation;
        EXPECT_LT(greyAt(level, right ? level.width_px - 5 : 4, bottom ? level.height_px - 5 : 4),
                  60)
            << orientation;
        EXPECT_GT(greyAt(level, right ? 4 : level.width_px - 5, bottom ? 4 : level.height_px - 5),
                  200)
            << orientation;
    }
}

TEST_F(PlanFormats, ShowsInksAsColours) {
    PlanLevel inks = markedPaper(64, 64, 4);
    auto bytes = *inks.pixels;
    for (std::size_t i = 0; i < bytes.size(); i += 4) {  // blue, green, red, alpha: Y, M, C, K
        bytes[i] = 0;
        bytes[i + 1] = 0;
        bytes[i + 2] = 255;
        bytes[i + 3] = 51;
    }
    inks.pixels = std::make_shared<const std::vector<std::uint8_t>>(bytes);
    makeImage(at("cmyk.tif"), inks,
              {.options = {"PHOTOMETRIC=CMYK"},
               .band_meanings = {"Cyan", "Magenta", "Yellow", "Black"},
               .alpha = true});
    const PlanLevel level = loaded(at("cmyk.tif")).levels[0];
    ASSERT_EQ(level.channels, 4);
    const std::vector<std::uint8_t> first(level.pixels->begin(), level.pixels->begin() + 4);
    EXPECT_EQ(first, (std::vector<std::uint8_t>{204, 204, 0, 255}));
}

TEST_F(PlanFormats, TakesTheResolutionOfAPageFromThePaperScale) {
    write("a.pdf", pdfText({{720, 360}, {144, 144}}));
    const PlanImage plan = loaded(at("a.pdf"), {.page = 1, .paper_scale = 50.0, .dpi = 100.0});
    EXPECT_EQ(plan.levels[0].width_px, 1000);
    EXPECT_EQ(plan.levels[0].height_px, 500);
    EXPECT_NEAR(plan.placement.resolution_m, 50.0 * 0.0254 / 100.0, 1e-12);
    expectMarked(plan.levels[0], "pdf");
    const PlanImage second = loaded(at("a.pdf"), {.page = 2});
    EXPECT_EQ(second.levels[0].width_px, 300) << "2 inches at 150 dpi";
    EXPECT_NEAR(second.placement.resolution_m, 100.0 * 0.0254 / 150.0, 1e-12);
}

TEST_F(PlanFormats, DescribesThePagesOfAPdf) {
    write("a.pdf", pdfText({{720, 360}, {144, 144}}));
    const auto description = describePlan(at("a.pdf"), {.dpi = 100.0});
    ASSERT_TRUE(description) << description.error().detail;
    EXPECT_EQ(description->format, "PDF");
    ASSERT_EQ(description->pages.size(), 2U);
    EXPECT_EQ(description->pages[0].width_px, 1000);
    EXPECT_EQ(description->pages[1].height_px, 200);
    EXPECT_NEAR(description->pages[0].paper_width_mm, 254.0, 0.1);
}

TEST_F(PlanFormats, SaysWhatIsWrongWithAPdf) {
    write("a.pdf", pdfText({{72, 72}}));
    EXPECT_EQ(errorOf(at("a.pdf"), {.page = 2}).detail, "there is no page 2, the last one is 1");
    EXPECT_EQ(errorOf(at("a.pdf"), {.page = 0}).code, ErrorCode::kBadValue);
    write("none.pdf", pdfText({}));
    EXPECT_EQ(errorOf(at("none.pdf")).code, ErrorCode::kNotAnImage);
    const std::string key(64, '0');
    write("locked.pdf", pdfText({{72, 72}},
                                "/ID [<00> <00>] /Encrypt << /Filter /Standard /V 1 "
                                "/R 2 /P -64 /O <" +
                                    key + "> /U <" + key + "> >>"));
    EXPECT_EQ(errorOf(at("locked.pdf")).detail, "the PDF is protected by a password");
    write("cut.pdf", pdfText({{72, 72}}).substr(0, 60));
    EXPECT_EQ(errorOf(at("cut.pdf")).code, ErrorCode::kNotAnImage);
}

TEST_F(PlanFormats, DrawsAnSvg) {
    write("a.svg",
          "<svg xmlns='http://www.w3.org/2000/svg' width='254mm' height='127mm' "
          "viewBox='0 0 120 80' preserveAspectRatio='none'><rect width='20' height='20'/></svg>");
    const PlanImage plan = loaded(at("a.svg"), {.paper_scale = 200.0, .dpi = 100.0});
    EXPECT_EQ(plan.levels[0].width_px, 1000);
    EXPECT_EQ(plan.levels[0].height_px, 500);
    EXPECT_NEAR(plan.placement.resolution_m, 200.0 * 0.0254 / 100.0, 1e-12);
    expectMarked(plan.levels[0], "svg");
    write("box.svg",
          "<?xml version='1.0'?><svg xmlns='http://www.w3.org/2000/svg' "
          "viewBox='0 0 96 48'><rect width='16' height='12'/></svg>");
    EXPECT_EQ(loaded(at("box.svg")).levels[0].width_px, 150) << "96 units are an inch";
    write("cut.svg", "<svg xmlns='http://www.w3.org/2000/svg' width='10' height='10'><rect");
    EXPECT_EQ(errorOf(at("cut.svg")).code, ErrorCode::kNotAnImage);
    write("none.svg", "<svg xmlns='http://www.w3.org/2000/svg' width='0' height='0'/>");
    EXPECT_EQ(errorOf(at("none.svg")).code, ErrorCode::kNotAnImage);
    write("huge.svg", "<svg xmlns='http://www.w3.org/2000/svg' width='9e6mm' height='9e6mm'/>");
    EXPECT_EQ(errorOf(at("huge.svg"), {.dpi = 150.0}).code, ErrorCode::kImageTooLarge);
}

std::string dxfOf(const std::string& header, const std::string& entities) {
    return "0\nSECTION\n2\nHEADER\n" + header + "0\nENDSEC\n0\nSECTION\n2\nENTITIES\n" + entities +
           "0\nENDSEC\n0\nEOF\n";
}

std::string dxfLine(double x1, double y1, double x2, double y2) {
    std::string text = "0\nLINE\n8\n0\n";
    const std::array<double, 4> values = {x1, y1, x2, y2};
    constexpr std::array<const char*, 4> kCodes = {"10", "20", "11", "21"};
    for (std::size_t i = 0; i < 4; ++i) {
        text += std::string(kCodes[i]) + '\n' + std::to_string(values[i]) + '\n';
    }
    return text;
}

TEST_F(PlanFormats, DrawsTheLinesOfADxfWhereTheyAre) {
    const std::string walls = dxfLine(1000, 2000, 21000, 2000) + dxfLine(1000, 2000, 1000, 12000);
    write("a.dxf", dxfOf("9\n$INSUNITS\n70\n4\n", walls));
    const PlanImage plan = loaded(at("a.dxf"));
    const PlanLevel& level = plan.levels[0];
    EXPECT_EQ(level.channels, 1);
    EXPECT_NEAR(level.width_px * plan.placement.resolution_m, 20.0, 0.2);
    EXPECT_NEAR(level.height_px * plan.placement.resolution_m, 10.0, 0.2);
    const auto plan_from_world = plan.worldFromPlan().inverse();
    const auto ink = [&](Point<World> p) {
        const Point<Plan> at = plan_from_world * p;
        return 255 - greyAt(level, static_cast<int>(at.x), static_cast<int>(at.y));
    };
    EXPECT_GT(ink({10.0, 2.0}), 100) << "millimetres, as the header says";
    EXPECT_GT(ink({1.0, 8.0}), 100);
    EXPECT_EQ(ink({10.0, 8.0}), 0);
    write("b.dxf", dxfOf("", walls));
    EXPECT_EQ(loaded(at("b.dxf")).placement, plan.placement) << "20 km are no building";
    write("none.dxf", dxfOf("", ""));
    EXPECT_EQ(errorOf(at("none.dxf")).code, ErrorCode::kNoData);
    write("letter.dxf", "Dear operator,\n");
    EXPECT_EQ(errorOf(at("letter.dxf")).code, ErrorCode::kNotAnImage);
}

TEST_F(PlanFormats, LaysAGroundOverlayIntoItsBox) {
    make("photo.png", {.driver = "PNG"});
    const auto kml = [&](const std::string& box) {
        return write("a.kml",
                     "<?xml version='1.0'?><kml xmlns='http://www.opengis.net/kml/2.2'>"
                     "<GroundOverlay><Icon><href>photo.png</href></Icon><LatLonBox>" +
                         box + "</LatLonBox></GroundOverlay></kml>");
    };
    // At 60 degrees north a degree of longitude is 55,800 m, one of latitude 111,412 m.
    const PlanImage plan =
        loaded(kml("<north>60.001</north><south>59.999</south>"
                   "<east>10.002</east><west>9.998</west>"));
    const PlanLevel& level = plan.levels[0];
    EXPECT_NEAR(level.width_px * plan.placement.resolution_m, 223.2, 3.0);
    EXPECT_NEAR(level.height_px * plan.placement.resolution_m, 222.8, 3.0);
    expectMarked(level, "kml");
    ASSERT_TRUE(plan.geo_tie);
    EXPECT_NEAR(plan.geo_tie->at.latitude_deg, 60.0, 1e-4);
    EXPECT_NEAR(plan.geo_tie->at.longitude_deg, 10.0, 1e-4);
    EXPECT_NEAR(plan.geo_tie->bearing_of_y_rad, 0.0, 1e-6);
    EXPECT_EQ(errorOf(kml("<north>60</north><south>61</south><east>1</east><west>0</west>")).code,
              ErrorCode::kBadValue);
    EXPECT_EQ(errorOf(kml("<north>nan</north><south>61</south><east>1</east><west>0</west>")).code,
              ErrorCode::kBadValue);
    EXPECT_EQ(errorOf(kml("<north>60</north>")).detail, "south");
    fs::remove(at("photo.png"));
    const Error gone = errorOf(kml("<north>1</north><south>0</south><east>1</east><west>0</west>"));
    EXPECT_EQ(gone.code, ErrorCode::kFileMissing);
    EXPECT_EQ(gone.subject, at("photo.png").string());
}

TEST_F(PlanFormats, AreDescribedWithTheResolutionOfTheirWorldFile) {
    make("a.png", {.driver = "PNG"});
    EXPECT_FALSE(describePlan(at("a.png")).value().resolution_m);
    write("a.pgw", "0.25\n0\n0\n-0.25\n10\n20\n");
    EXPECT_EQ(describePlan(at("a.png")).value().resolution_m, 0.25);
    write("a.pgw", "0.25\nnothing\n");
    EXPECT_TRUE(describePlan(at("a.png"))) << "loading it says what is wrong";
}

// As many programs write them today, and GDAL does not read.
TEST_F(PlanFormats, ReadsABitmapWithANewHeader) {
    make("old.bmp", {.driver = "BMP"});
    const std::string old = bytesOf(at("old.bmp"));
    for (const std::size_t header : {108U, 124U}) {
        std::string bytes = old;
        bytes.insert(14 + 40, header - 40, '\0');
        bytes[14] = static_cast<char>(header);
        const auto offset = static_cast<unsigned char>(bytes[10]) + header - 40;
        ASSERT_LT(offset, 256U);
        bytes[10] = static_cast<char>(offset);
        const PlanImage plan = loaded(write("new.bmp", bytes));
        EXPECT_EQ(*plan.levels[0].pixels, *loaded(at("old.bmp")).levels[0].pixels) << header;
        EXPECT_EQ(describePlan(at("new.bmp")).value().format, "BMP");
        EXPECT_EQ(errorOf(write("cut.bmp", bytes.substr(0, 100))).code, ErrorCode::kNotAnImage);
    }
}

TEST_F(PlanFormats, UnpacksAGroundOverlay) {
    make("photo.png", {.driver = "PNG"});
    const auto pack = [&](const std::string& archive, const std::string& document) {
        makeArchive(at(archive), {{"doc.kml", document},
                                  {"files/photo.png", readTextFile(at("photo.png")).value()}});
        return at(archive);
    };
    const std::string box =
        "<LatLonBox><north>60.001</north><south>59.999</south><east>10.002</east>"
        "<west>9.998</west></LatLonBox></GroundOverlay></kml>";
    const std::string overlay = "<kml><GroundOverlay><Icon><href>";
    const PlanImage plan = loaded(pack("a.kmz", overlay + "files/photo.png</href></Icon>" + box));
    expectMarked(plan.levels[0], "kmz");
    EXPECT_EQ(plan.image_file, at("a.kmz"));
    EXPECT_NEAR(plan.geo_tie.value().at.latitude_deg, 60.0, 1e-4);
    EXPECT_EQ(describePlan(at("a.kmz")).value().format, "KMZ");
    EXPECT_EQ(errorOf(pack("b.kmz", overlay + "gone.png</href></Icon>" + box)).code,
              ErrorCode::kNotAnImage);
    EXPECT_EQ(
        errorOf(pack("c.kmz", overlay + "/vsicurl/http://127.0.0.1/a.png</href></Icon>" + box))
            .code,
        ErrorCode::kNotAnImage);
    EXPECT_EQ(errorOf(pack("d.kmz", std::string(5 << 20, ' '))).code, ErrorCode::kBadFormat);
    EXPECT_EQ(errorOf(write("e.kmz", "PK\x03\x04 and no more")).code, ErrorCode::kNotAnImage);
}

TEST_F(PlanFormats, SaysInOneSentenceWhatCannotBeRead) {
    EXPECT_EQ(errorOf(write("empty.png", "")).code, ErrorCode::kFileEmpty);
    EXPECT_EQ(errorOf(at("gone.png")).code, ErrorCode::kFileMissing);
    EXPECT_EQ(errorOf(at("")).code, ErrorCode::kFileUnreadable);
    ASSERT_EQ(mkfifo(at("pipe.png").c_str(), 0600), 0);
    EXPECT_EQ(errorOf(at("pipe.png")).code, ErrorCode::kFileUnreadable);
    EXPECT_EQ(errorOf(write("letter.jpg", "Dear operator,")).code, ErrorCode::kNotAnImage);
    makeImage(at("whole.png"), markedPaper(900, 600, 4), {.driver = "PNG"});
    const std::string whole = bytesOf(at("whole.png"));
    const Error cut = errorOf(write("cut.png", whole.substr(0, whole.size() / 2)));
    EXPECT_EQ(cut.code, ErrorCode::kNotAnImage);
    EXPECT_TRUE(cut.detail.starts_with("damaged or cut off")) << cut.detail;
}

// GDAL would fill it up with grey.
TEST_F(PlanFormats, RefusesAJpegThatEndsTooEarly) {
    makeImage(at("whole.jpg"), markedPaper(900, 600, 4), {.driver = "JPEG"});
    const std::string whole = bytesOf(at("whole.jpg"));
    const Error cut = errorOf(write("cut.jpg", whole.substr(0, whole.size() * 9 / 10)));
    EXPECT_EQ(cut.code, ErrorCode::kNotAnImage);
    EXPECT_EQ(cut.detail, "damaged or cut off: it ends too early");
}

// The header of a PNG says 50,000 x 50,000 in colour: 10 GB. Nothing is allocated for it.
TEST_F(PlanFormats, RefusesABombBeforeItGoesOff) {
    makeImage(at("a.png"), markedPaper(60, 40, 4), {.driver = "PNG"});
    std::string bomb = bytesOf(at("a.png"));
    for (const std::size_t at : {std::size_t{16}, std::size_t{20}}) {
        bomb.replace(at, 4, std::string("\x00\x00\xC3\x50", 4));
    }
    // The checksum of that header.
    bomb.replace(29, 4, std::string("\xC4\xCD\xAA\x9D", 4));
    const Error error = errorOf(write("bomb.png", bomb));
    EXPECT_TRUE(error.code == ErrorCode::kImageTooLarge) << error.detail;
    EXPECT_EQ(error.detail, "50000 x 50000 pixels");
}

TEST_F(PlanFormats, MakesSmallPicturesForAList) {
    makeImage(at("a.jpg"), markedPaper(1200, 800, 4), {.driver = "JPEG"});
    write("b.jpg", withExifOrientation(bytesOf(at("a.jpg")), 6));
    write("c.pdf", pdfText({{720, 480}}));
    for (const char* name : {"a.jpg", "c.pdf"}) {
        const auto small = planThumbnail(at(name), 96);
        ASSERT_TRUE(small) << name;
        EXPECT_EQ(small->width_px, 96) << name;
        EXPECT_EQ(small->height_px, 64) << name;
        expectMarked(*small, name);
    }
    const auto turned = planThumbnail(at("b.jpg"), 96);
    ASSERT_TRUE(turned);
    EXPECT_EQ(turned->height_px, 96);
    EXPECT_EQ(planThumbnail(kImages / "grey16.png", 96)->width_px, 3) << "is not blown up";
    EXPECT_FALSE(planThumbnail(at("gone.png"), 96));
}

}  // namespace
}  // namespace hedr
