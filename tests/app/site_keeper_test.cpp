#include "app/site_keeper.h"

#include <QDir>
#include <QTest>

#include "core/site/site_file.h"
#include "tests/ui/site/plan_files.h"
#include "ui/main_window.h"
#include "ui/site/site_desk.h"

namespace hedr {
namespace {

// A window with its keeper, as one start of the program has them.
struct Start {
    Start() : keeper(window, nullptr) {
        QObject::connect(&keeper, &SiteKeeper::failed, &window,
                         [this](const Error& error) { errors.push_back(error); });
    }
    void open(const QString& file) {
        keeper.open({.file = file});
        EXPECT_TRUE(QTest::qWaitFor([&] { return !site().floor().plans.empty(); }, 20000));
        EXPECT_TRUE(QTest::qWaitFor(
            [&] { return site().plansWithoutImage().empty() || !errors.empty(); }, 20000));
    }
    SiteModel& site() { return window.desk().site(); }
    void place(double x_m) {
        Site next = site().site();
        next.floors.front().plans.front().placement.origin.position.x = x_m;
        site().edit(next);
    }
    double placed() { return site().floor().plans.front().placement.origin.position.x; }

    MainWindow window;
    SiteKeeper keeper;
    std::vector<Error> errors{};
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
        ASSERT_TRUE(QTest::qWaitFor([&] { return hashIsKept(image); }, 20000));
    }
    files.addImage("floor.png", {500, 400});
    Start second;
    second.open(image);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !second.errors.empty(); }, 20000));
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
        20000));
    ASSERT_EQ(start.errors.size(), 1u);
    EXPECT_EQ(start.errors.front().code, ErrorCode::kFileMissing);
    EXPECT_EQ(start.site().floor().name, "Ground");
}

}  // namespace
}  // namespace hedr
