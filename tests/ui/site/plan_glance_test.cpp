#include "ui/site/plan_glance.h"

#include "tests/ui/site/plan_files.h"

namespace hedr {
namespace {

TEST(PlanGlance, ShowsASmallPictureAndSaysHowLargeTheFileIs) {
    const test::PlanFiles files;
    const PlanGlance glance = glanceAt({.file = files.addImage("floor.png", {800, 600})}, 100);
    EXPECT_EQ(glance.picture.size(), QSize(100, 75));
    EXPECT_TRUE(glance.words.startsWith("800 × 600 px, PNG")) << glance.words.toStdString();
    EXPECT_FALSE(glance.error);
    // The outer wall, dark on white, is where it was drawn.
    EXPECT_LT(qGray(glance.picture.pixel(5, 30)), 180);
    EXPECT_GT(qGray(glance.picture.pixel(50, 20)), 240);
}

TEST(PlanGlance, ShowsTheFirstImageOfASite) {
    const test::PlanFiles files;
    files.addImage("floor.png", {800, 600});
    const QString site = files.addText("campus.site.toml",
                                       "site = 1\n[[floor]]\nname = \"Ground\"\n[[floor.plan]]\n"
                                       "image = \"floor.png\"\nresolution_m = 0.05\n");
    const PlanGlance glance = glanceAt({.file = site}, 100);
    EXPECT_EQ(glance.words, "Site, floors: 1, images: 1");
    EXPECT_EQ(glance.picture.size(), QSize(100, 75));
    EXPECT_FALSE(glance.error);
}

TEST(PlanGlance, SaysInOneSentenceWhyAFileIsNoPlan) {
    const test::PlanFiles files;
    const PlanGlance glance = glanceAt({.file = files.addText("notes.png", "not a picture")}, 100);
    EXPECT_TRUE(glance.picture.isNull());
    EXPECT_EQ(glance.error, ErrorCode::kNotAnImage);
    EXPECT_TRUE(glance.words.contains("notes.png")) << glance.words.toStdString();
    EXPECT_FALSE(glance.words.contains('\n'));
}

TEST(PlanGlance, ShowsASmallImageAsLargeAsItIs) {
    const test::PlanFiles files;
    EXPECT_EQ(glanceAt({.file = files.addImage("dot.png", {40, 30})}, 100).picture.size(),
              QSize(40, 30));
}

TEST(PlanGlance, NamesThePagesOfAPdfByTheirPaper) {
    const test::PlanFiles files;
    const QString pdf = files.addPdf("floors.pdf", {QPageSize::A3, QPageSize::A4});
    EXPECT_EQ(pagesToChooseFrom(pdf), (std::vector<QString>{"A3", "A4"}));
    const PlanGlance first = glanceAt({.file = pdf}, 200);
    const PlanGlance second = glanceAt({.file = pdf, .choice = {.page = 2}}, 200);
    EXPECT_EQ(first.words, "PDF, 2 pages");
    EXPECT_EQ(first.picture.height(), 200);
    EXPECT_EQ(second.picture.height(), 200);
    EXPECT_NE(first.picture, second.picture);
}

TEST(PlanGlance, SaysTheScaleThatAFileBesideThePlanTells) {
    const test::PlanFiles files;
    const QString plan = files.addImage("floor.png", {800, 600});
    EXPECT_EQ(glanceAt({.file = plan}, 100).words, "800 × 600 px, PNG");
    files.addText("floor.toml", "image = \"floor.png\"\nresolution_m = 0.02\n");
    EXPECT_EQ(glanceAt({.file = plan}, 100).words, "800 × 600 px, PNG, 0.02 m per pixel");
}

TEST(PlanGlance, OffersNoPagesOfAnImage) {
    const test::PlanFiles files;
    EXPECT_TRUE(pagesToChooseFrom(files.addImage("floor.png")).empty());
    EXPECT_TRUE(pagesToChooseFrom(files.path("missing.pdf")).empty());
}

TEST(PlanGlance, IsInvertedAtNightAsTheMapIs) {
    QImage white(2, 2, QImage::Format_RGB32);
    white.fill(Qt::white);
    EXPECT_EQ(themedPicture(white, nightTheme()).pixelColor(0, 0), nightTheme().paper);
    EXPECT_EQ(themedPicture(white, dayTheme()).pixelColor(0, 0), QColor(Qt::white));
}

}  // namespace
}  // namespace hedr
