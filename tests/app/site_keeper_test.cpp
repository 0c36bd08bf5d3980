#include "app/site_keeper.h"

#include <QDir>
#include <QTest>

#include "app/site_place.h"
#include "core/site/site_file.h"
#include "tests/ui/site/plan_files.h"
#include "ui/main_window.h"
#include "ui/site/site_desk.h"

namespace hedr {
namespace {

namespace fs = std::filesystem;

constexpr int kPatience_ms = 120000;  // with a machine that has much else to do

// A window with its keeper, as one start of the program has them.
struct Start {
    Start() : keeper(window, nullptr) {
        QObject::connect(&keeper, &SiteKeeper::failed, &window,
                         [this](const Error& error) { errors.push_back(error); });
    }
    void open(const QString& file) {
        keeper.open({.file = file});
        EXPECT_TRUE(QTest::qWaitFor([&] { return !site().floor().plans.empty(); }, kPatience_ms));
        EXPECT_TRUE(QTest::qWaitFor(
            [&] { return site().plansWithoutImage().empty() || !errors.empty(); }, kPatience_ms));
    }
    SiteModel& site() { return window.desk().site(); }
    void place(double x_m) {
        Site next = site().site();
        next.floors.front().plans.front().placement.origin.position.x = x_m;
        site().edit(next);
    }
    double placed() { return site().floor().plans.front().placement.origin.position.x; }

    std::vector<Error> errors{};  // the keeper may still tell one when it ends
    MainWindow window;
    SiteKeeper keeper;
};

bool hashIsKept(const QString& image) {
    const auto kept = readSite(siteFileBeside(image.toStdString()));
    return kept && !kept->floors.front().plans.front().sha256.empty();
}

TEST(SiteKeeper, GivesAnAlignmentBackWithItsImage) {
    const test::PlanFiles files;
    const QString image = files.addImage("floor.png");
    {
        Start first;
        first.open(image);
        first.place(12.5);
    }
    ASSERT_TRUE(QFile::exists(image + ".site.toml"));
    Start second;
    second.open(image);
    EXPECT_EQ(second.placed(), 12.5);
}

TEST(SiteKeeper, KeepsNothingOfAnImageThatWasOnlyLookedAt) {
    const test::PlanFiles files;
    const QString image = files.addImage("floor.png");
    {
        Start only;
        only.open(image);
    }
    EXPECT_FALSE(QFile::exists(image + ".site.toml"));
}

TEST(SiteKeeper, SaysThatAnImageHasChangedSinceItWasAligned) {
    const test::PlanFiles files;
    const QString image = files.addImage("floor.png");
    {
        Start first;
        first.open(image);
        first.place(12.5);
        ASSERT_TRUE(QTest::qWaitFor([&] { return hashIsKept(image); }, kPatience_ms));
    }
    files.addImage("floor.png", {500, 400});
    Start second;
    second.open(image);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !second.errors.empty(); }, kPatience_ms));
    EXPECT_EQ(second.errors.front().code, ErrorCode::kFileChanged);
    EXPECT_FALSE(second.site().warning(second.site().floor().plans.front()).isEmpty());
}

TEST(SiteKeeper, KeepsTheSiteElsewhereWhereNothingCanBeWrittenBesideTheImage) {
    const test::PlanFiles files;
    const QString image = files.addImage("floor.png");
    QDir().mkpath(image + ".site.toml");  // in the way
    {
        Start first;
        first.open(image);
        first.place(12.5);
    }
    Start second;
    second.open(image);
    EXPECT_EQ(second.placed(), 12.5);
    EXPECT_TRUE(second.errors.empty());
    QFile::remove(QString::fromStdString(siteFileInOwnFolder(image.toStdString()).string()));
}

TEST(SiteKeeper, GoesOnInTheFileThatTheOperatorNamed) {
    const test::PlanFiles files;
    const QString image = files.addImage("floor.png");
    QDir().mkpath(files.path("elsewhere"));
    const QString site_file = files.path("elsewhere/campus.site.toml");
    {
        Start first;
        first.open(image);
        first.keeper.saveAs(site_file.toStdString());
        EXPECT_TRUE(QFile::exists(site_file));
        first.place(12.5);
    }
    EXPECT_FALSE(QFile::exists(image + ".site.toml"));
    Start second;
    second.open(site_file);
    EXPECT_EQ(second.placed(), 12.5);
    EXPECT_TRUE(second.errors.empty());
}

TEST(SiteKeeper, NamesImagesSoThatTheFolderOfASiteCanBeMoved) {
    const test::PlanFiles files;
    QDir().mkpath(files.path("campus"));
    {
        Start first;
        first.open(files.addImage("campus/floor.png"));
        first.place(12.5);
        first.keeper.saveAs(files.path("campus/all.site.toml").toStdString());
    }
    ASSERT_TRUE(QDir().rename(files.path("campus"), files.path("moved")));
    Start second;
    second.open(files.path("moved/all.site.toml"));
    EXPECT_EQ(second.placed(), 12.5);
    EXPECT_TRUE(second.errors.empty());
    EXPECT_TRUE(second.site().image(second.site().floor().plans.front()));
}

TEST(SiteKeeper, GoesOnWhereItWasIfTheNamedFileCannotBeWritten) {
    const test::PlanFiles files;
    const QString image = files.addImage("floor.png");
    {
        Start first;
        first.open(image);
        first.keeper.saveAs(files.path("gone/campus.site.toml").toStdString());
        ASSERT_EQ(first.errors.size(), 1u);
        EXPECT_EQ(first.errors.front().code, ErrorCode::kFileUnwritable);
        first.place(12.5);
    }
    EXPECT_TRUE(QFile::exists(image + ".site.toml"));
}

TEST(SiteKeeper, SaysThatTheNamedFileCanNoLongerBeWritten) {
    const test::PlanFiles files;
    const QString image = files.addImage("floor.png");
    QDir().mkpath(files.path("stick"));
    Start start;
    start.open(image);
    start.keeper.saveAs(files.path("stick/campus.site.toml").toStdString());
    ASSERT_TRUE(QDir(files.path("stick")).removeRecursively());
    start.place(12.5);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !start.errors.empty(); }, kPatience_ms));
    EXPECT_EQ(start.errors.front().code, ErrorCode::kFileUnwritable);
    const fs::path kept = siteFileInOwnFolder(image.toStdString());
    EXPECT_TRUE(fs::remove(kept));
}

TEST(SiteKeeper, AddsTheHashThatComesAfterTheFileWasWritten) {
    const test::PlanFiles files;
    const fs::path site_file = files.path("campus.site.toml").toStdString();
    Start start;
    // Before a hash can arrive: that takes a turn of the event loop.
    QObject::connect(
        &start.site(), &SiteModel::kept, &start.window, [&] { start.keeper.saveAs(site_file); },
        Qt::SingleShotConnection);
    start.open(files.addImage("floor.png"));
    const auto has_hash = [&] {
        const auto kept = readSite(site_file);
        return kept && !kept->floors.front().plans.front().sha256.empty();
    };
    EXPECT_TRUE(QTest::qWaitFor(has_hash, kPatience_ms));
}

TEST(SiteKeeper, KeepsNoPreviewOfAPageThatIsOpen) {
    const test::PlanFiles files;
    const QString image = files.addImage("floor.png");
    Start start;
    start.open(image);
    Site moved = start.site().site();
    moved.floors.front().name = "only tried";
    start.site().preview(moved);
    start.keeper.saveAs(files.path("campus.site.toml").toStdString());
    EXPECT_NE(readSite(files.path("campus.site.toml").toStdString())->floors.front().name,
              "only tried");
}

// A photo so large that it is seen before it is there.
TEST(SiteKeeper, LeavesNoStepOfAnImageThatWasCanceled) {
    const test::PlanFiles files;
    const QString image = files.addImage("large.jpg", {6000, 4000});
    Start start;
    const Site before = start.site().site();
    start.keeper.open({.file = image});
    ASSERT_TRUE(QTest::qWaitFor([&] { return !start.site().floor().plans.empty(); }, kPatience_ms));
    ASSERT_FALSE(start.site().wholeImage(start.site().floor().plans.front()))
        << "the preview was missed";
    start.keeper.cancel();
    EXPECT_EQ(start.site().site(), before);
    start.site().undo();
    EXPECT_EQ(start.site().site(), before);
    start.site().redo();
    EXPECT_EQ(start.site().site(), before);
}

TEST(SiteKeeper, ShowsWhatIsThereOfASiteThatLacksAnImage) {
    const test::PlanFiles files;
    const Site site{
        .floors = {{.name = "Ground",
                    .plans = {{.image_file = files.path("gone.png").toStdString()},
                              {.image_file = files.addImage("floor.png").toStdString()}}}}};
    ASSERT_TRUE(writeSite(site, files.path("a.site.toml").toStdString()));
    Start start;
    start.keeper.open({.file = files.path("a.site.toml")});
    ASSERT_TRUE(QTest::qWaitFor(
        [&] {
            const auto& plans = start.site().floor().plans;
            return plans.size() == 2 && start.site().image(plans[1]);
        },
        kPatience_ms));
    ASSERT_EQ(start.errors.size(), 1u);
    EXPECT_EQ(start.errors.front().code, ErrorCode::kFileMissing);
    EXPECT_EQ(start.site().floor().name, "Ground");
}

}  // namespace
}  // namespace hedr
