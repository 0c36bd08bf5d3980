#include <gtest/gtest.h>

#include <QDir>
#include <QTest>

#include "tests/ui/photo.h"
#include "tests/ui/scene.h"
#include "ui/main_window.h"
#include "ui/map/map_view.h"
#include "ui/panels/legend.h"
#include "ui/site/align_page.h"
#include "ui/site/choices_panel.h"
#include "ui/site/desk_header.h"
#include "ui/site/site_desk.h"
#include "ui/site/walls_card.h"

namespace hedr {
namespace {

// Pictures for people to look at: build folder, screenshots/NAME-WIDTH.png.
void writePictures(const QString& name, MainWindow& window) {
    QDir().mkpath(QStringLiteral(HEDR_BINARY_DIR "/screenshots"));
    for (const QSize size : {QSize(1600, 1000), QSize(1280, 800), QSize(1024, 640)}) {
        window.resize(size);
        window.show();
        QTest::qWait(150);  // the values are refreshed ten times a second
        const auto* map = window.findChild<MapView*>();
        ASSERT_TRUE(QTest::qWaitFor([&] { return map->isSharp(); }));
        const QString file =
            QStringLiteral(HEDR_BINARY_DIR "/screenshots/%1-%2.png").arg(name).arg(size.width());
        EXPECT_TRUE(window.grab().save(file)) << file.toStdString();
    }
}

// A window in the middle of the sample mission.
void showMission(MainWindow& window, test::HandClock& hand, ThemeName theme) {
    window.setTheme(theme);
    window.setPlan(test::samplePlan());
    hand.set(0.0);
    window.applyBatch(test::sampleBatch(0.0));
    hand.set(test::kDrive_s);
    window.applyBatch(test::sampleBatch(test::kDrive_s, 0.0));
}

struct Picture {
    const char* name;
    ThemeName theme;
    double silence_s;  // since the last packet
};

class Screenshots : public testing::TestWithParam<Picture> {};

TEST_P(Screenshots, ShowALiveMission) {
    const Picture& picture = GetParam();
    test::HandClock hand;
    MainWindow window(hand.clock());
    showMission(window, hand, picture.theme);
    hand.set(test::kDrive_s + picture.silence_s);
    writePictures(QString::fromLatin1(picture.name), window);
}

INSTANTIATE_TEST_SUITE_P(All, Screenshots,
                         testing::Values(Picture{"live-day", ThemeName::kDay, 0.0},
                                         Picture{"live-night", ThemeName::kNight, 0.0},
                                         Picture{"stale-day", ThemeName::kDay, 2.4},
                                         Picture{"stale-night", ThemeName::kNight, 2.4},
                                         Picture{"lost-day", ThemeName::kDay, 7.0},
                                         Picture{"lost-night", ThemeName::kNight, 7.0}),
                         [](const auto& test) {
                             std::string name = test.param.name;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

// Every estimator there may be, five of them side by side, and one that is not the first carries
// the robot: by day one that nothing checks, by night one that is lost.
TEST(TrailScreenshots, ShowManyTrailsAndAnotherPrimaryOne) {
    for (const ThemeName theme : {ThemeName::kDay, ThemeName::kNight}) {
        test::HandClock hand;
        MainWindow window(hand.clock());
        window.setTheme(theme);
        window.setPlan(test::samplePlan());
        hand.set(test::kDrive_s);
        LiveBatch batch = test::sampleBatch(test::kDrive_s);
        for (const char* name : {"hedr", "gyrodometry", "gyro", "gyro_kalman", "gh_gyro",
                                 "gh_magnetometer", "gh_combined", "wall_filter"}) {
            const double error_rad_s = 0.0002 * static_cast<double>(batch.tracks.size());
            batch.tracks.push_back({name, test::drift(test::kDrive_s, error_rad_s)});
        }
        const bool day = theme == ThemeName::kDay;
        window.setTrailChoice({.primary = day ? "odometry" : "hedr",
                               .shown = {{"hedr", true},
                                         {"gyrodometry", true},
                                         {"gyro_kalman", false},
                                         {"gh_gyro", false},
                                         {"gh_magnetometer", false},
                                         {"gh_combined", false},
                                         {"wall_filter", false}}});
        batch.statuses.push_back({"hedr", {.state = HedrState::kActive, .lost = true}});
        window.applyBatch(batch);
        writePictures(day ? "trails-day" : "trails-night", window);
        auto* more = window.findChild<Legend*>()->findChild<QPushButton*>();
        more->click();
        more->setFocus();
        writePictures(day ? "trails-all-day" : "trails-all-night", window);
    }
}

TEST(EmptyScreenshots, ShowAFirstTimeUserWhatToDo) {
    for (const ThemeName theme : {ThemeName::kDay, ThemeName::kNight}) {
        test::HandClock hand;
        MainWindow window(hand.clock());
        window.setTheme(theme);
        writePictures(theme == ThemeName::kDay ? "empty-day" : "empty-night", window);
    }
}

TEST(ClosedScreenshots, ShowAMissionAfterDisconnecting) {
    test::HandClock hand;
    MainWindow window(hand.clock());
    window.setPlan(test::samplePlan());
    hand.set(test::kDrive_s);
    LiveBatch batch = test::sampleBatch(test::kDrive_s);
    window.applyBatch(batch);
    batch.port = PortState::kClosed;
    batch.tracks.clear();
    window.applyBatch(batch);
    writePictures("closed-day", window);
}

TEST(ErrorScreenshots, ShowAnErrorAboveTheMap) {
    test::HandClock hand;
    MainWindow window(hand.clock());
    window.setPlan(test::samplePlan());
    window.showError({ErrorCode::kPortPermission, "/dev/ttyUSB0", ""});
    window.showPlanProgress(0.42);
    writePictures("error-day", window);
}

TEST(AlignScreenshots, ShowAPlanThatIsAlignedByPoints) {
    for (const ThemeName theme : {ThemeName::kDay, ThemeName::kNight}) {
        test::HandClock hand;
        MainWindow window(hand.clock());
        showMission(window, hand, theme);
        window.desk().alignTopmost();
        window.resize(1600, 1000);
        window.show();
        auto* map = window.findChild<MapView*>();
        for (const Point<World>& at : {Point<World>{3.0, 11.2},
                                       {3.1, 11.3},
                                       {77.0, 11.2},
                                       {77.1, 11.0},
                                       {77.0, 37.8},
                                       {76.8, 38.0},
                                       {3.0, 37.8},
                                       {3.4, 37.2}}) {
            const Point<View> p = map->view().viewFromWorld() * at;
            QTest::mouseClick(map, Qt::LeftButton, {}, {qRound(p.x), qRound(p.y)});
        }
        writePictures(theme == ThemeName::kDay ? "align-day" : "align-night", window);
    }
}

TEST(LayersScreenshots, ShowFloorsAndImages) {
    for (const ThemeName theme : {ThemeName::kDay, ThemeName::kNight}) {
        test::HandClock hand;
        MainWindow window(hand.clock());
        showMission(window, hand, theme);
        SiteModel& site = window.desk().site();
        Site next = site.site();
        next.floors.front().name = "Ground floor";
        next.floors.push_back({.name = "First floor", .plans = next.floors.front().plans});
        next.floors.push_back({.name = "Second floor"});
        site.edit(next);
        PlanImage coloured = test::colouredPlan();
        coloured.placement.origin.position = {30.0, -45.0};
        site.addImage(coloured);
        window.desk().toggleLayers();
        window.resize(1600, 1000);
        window.show();
        QTest::qWait(500);  // the small pictures
        writePictures(theme == ThemeName::kDay ? "layers-day" : "layers-night", window);
        site.showFloor(1);
        QTest::qWait(500);
        writePictures(theme == ThemeName::kDay ? "floor-day" : "floor-night", window);
    }
}

// A window in which the sample photo is made flat.
void showPhoto(MainWindow& window, ThemeName theme) {
    window.setTheme(theme);
    window.resize(1600, 1000);
    window.show();
    window.setPlan(test::photographedPlan());
    window.desk().straightenTopmost();
    const auto* done = window.findChild<DeskHeader*>()->findChildren<QPushButton*>().back();
    ASSERT_TRUE(QTest::qWaitFor([&] { return done->isEnabled(); }));
}

QPoint onPhoto(const MapView& map, const PlanPlacement& placement, Point<Plan> p) {
    constexpr int kPhotoHeight_px = 900;
    const Point<View> at =
        map.view().viewFromWorld() * worldFromPlan(placement, kPhotoHeight_px) * p;
    return {qRound(at.x), qRound(at.y)};
}

TEST(AlignScreenshots, ShowWhatIsProposed) {
    for (const ThemeName theme : {ThemeName::kDay, ThemeName::kNight}) {
        test::HandClock hand;
        MainWindow window(hand.clock());
        showMission(window, hand, theme);
        window.resize(1024, 640);
        window.show();
        window.desk().alignTopmost();
        window.findChild<AlignPage*>()->setMethod(AlignMethod::kTurn);
        ASSERT_TRUE(QTest::qWaitFor(
            [&] { return window.findChildren<ChoiceButton*>().size() == 4; }, 20000));
        writePictures(theme == ThemeName::kDay ? "turn-day" : "turn-night", window);
    }
}

TEST(StraightenScreenshots, ShowAPhotoWhoseCornerIsDragged) {
    for (const ThemeName theme : {ThemeName::kDay, ThemeName::kNight}) {
        test::HandClock hand;
        MainWindow window(hand.clock());
        showPhoto(window, theme);
        auto* map = window.findChild<MapView*>();
        const PlanPlacement& placement = window.desk().site().floor().plans.front().placement;
        const Point<Plan> corner = test::sheetInPhoto().corners[1];
        QTest::mousePress(map, Qt::LeftButton, {}, onPhoto(*map, placement, corner));
        QTest::mouseMove(map, onPhoto(*map, placement, corner + Vector<Plan>{7.0, -5.0}));
        writePictures(theme == ThemeName::kDay ? "straighten-day" : "straighten-night", window);
    }
}

TEST(StraightenScreenshots, ShowCornersThatNoRectangleHas) {
    test::HandClock hand;
    MainWindow window(hand.clock());
    showPhoto(window, ThemeName::kDay);
    window.findChild<DeskHeader*>()->findChildren<QPushButton*>().back()->click();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window.desk().open(); }));
    window.desk().straightenTopmost();
    auto* map = window.findChild<MapView*>();
    const PlanPlacement& placement = window.desk().site().floor().plans.front().placement;
    QTest::mousePress(map, Qt::LeftButton, {},
                      onPhoto(*map, placement, test::sheetInPhoto().corners[0]));
    QTest::mouseMove(map, onPhoto(*map, placement, {900.0, 700.0}));
    writePictures("straighten-refused-day", window);
}

TEST(WallsScreenshots, ShowWallsAndFreeSpaceOfAPlan) {
    for (const ThemeName theme : {ThemeName::kDay, ThemeName::kNight}) {
        test::HandClock hand;
        MainWindow window(hand.clock());
        showMission(window, hand, theme);
        window.desk().drawWalls();
        window.resize(1600, 1000);
        window.show();
        auto* map = window.findChild<MapView*>();
        QTest::qWait(0);
        const auto drag = [&](Point<World> from, Point<World> to) {
            const Point<View> a = map->view().viewFromWorld() * from;
            const Point<View> b = map->view().viewFromWorld() * to;
            QTest::mousePress(map, Qt::LeftButton, {}, {qRound(a.x), qRound(a.y)});
            QTest::mouseMove(map, {qRound(b.x), qRound(b.y)});
            QTest::mouseRelease(map, Qt::LeftButton, {}, {qRound(b.x), qRound(b.y)});
        };
        drag({27.4, 20.0}, {52.4, 20.0});
        const auto* bar = window.findChild<WallsCard*>()->findChild<QProgressBar*>();
        ASSERT_TRUE(QTest::qWaitFor([&] { return !bar->isVisible(); }));
        QTest::keyClick(&window, Qt::Key_E);
        drag({60.0, 37.8}, {66.0, 37.8});
        writePictures(theme == ThemeName::kDay ? "walls-day" : "walls-night", window);
    }
}

}  // namespace
}  // namespace hedr
