#include "ui/main_window.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QComboBox>
#include <QDropEvent>
#include <QMimeData>
#include <QSignalSpy>
#include <QTest>

#include "tests/ui/scene.h"
#include "ui/fonts.h"
#include "ui/map/map_view.h"
#include "ui/panels/banner.h"
#include "ui/panels/connect_card.h"
#include "ui/panels/hint.h"
#include "ui/panels/legend.h"
#include "ui/panels/plan_progress_card.h"
#include "ui/panels/rail.h"
#include "ui/panels/status_strip.h"
#include "ui/panels/status_tile_view.h"

namespace hedr {
namespace {

// Finds things in a window as a person would: by their words.
class Window {
  public:
    Window() : window(hand.clock()) {
        window.resize(1280, 800);
        window.show();
        window.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&window));
    }

    void live(double second) {
        hand.set(second);
        window.applyBatch(test::sampleBatch(second, second_ < 0.0 ? -1.0 : second_));
        second_ = second;
    }
    QString tile(const QString& label) const {
        for (const auto* view : window.findChildren<StatusTileView*>()) {
            if (view->accessibleName() == label) {
                return view->accessibleDescription().replace(QChar(0x00A0), QChar(' '));
            }
        }
        return {};
    }
    QAbstractButton* button(const QString& name) const {
        for (auto* candidate : window.findChildren<QAbstractButton*>()) {
            const bool named = candidate->text() == name || candidate->accessibleName() == name;
            if (named && candidate->isVisible()) return candidate;
        }
        return nullptr;
    }
    MapView& map() const { return *window.findChild<MapView*>(); }
    // Without the cards: the legend has the trails' colours too.
    QImage mapPicture() const {
        QImage picture(map().size(), QImage::Format_RGB32);
        map().render(&picture, {}, {}, QWidget::DrawWindowBackground);
        return picture;
    }
    // Of exactly this colour on the map.
    int pixels(const QColor& colour) const {
        const QImage picture = mapPicture();
        int count = 0;
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) count += picture.pixel(x, y) == colour.rgb();
        }
        return count;
    }
    QColor colourAt(const QPoint& place) const { return mapPicture().pixelColor(place); }
    QPoint robotAt(const LiveBatch& batch, const std::string& trail) const {
        for (const NamedPoints& track : batch.tracks) {
            if (track.name != trail) continue;
            const Point<View> at = map().view().viewFromWorld() * track.points.back().pose.position;
            return {qRound(at.x), qRound(at.y)};
        }
        return {};
    }
    QString banner() const {
        for (const auto* banner : window.findChildren<Banner*>()) {
            if (banner->isVisible()) return banner->text();
        }
        return {};
    }

    test::HandClock hand;
    MainWindow window;

  private:
    double second_ = -1.0;
};

template <class Condition>
testing::AssertionResult soon(Condition condition) {
    if (QTest::qWaitFor(condition, 2000)) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "not within two seconds";
}

TEST(MainWindow, ShowsAFirstTimeUserHowToBegin) {
    Window w;
    EXPECT_TRUE(w.window.findChild<ConnectCard*>()->isVisible());
    EXPECT_TRUE(w.window.findChild<Hint*>()->isVisible());
    EXPECT_FALSE(w.window.findChild<Legend*>()->isVisible());
    EXPECT_EQ(w.tile("LINK"), "OFF, not connected");
}

TEST(MainWindow, ShowsAMissionThatGoesLiveStaleLostAndLiveAgain) {
    Window w;
    w.live(1.0);
    EXPECT_TRUE(soon([&] { return w.tile("LINK").startsWith("LIVE"); }));
    EXPECT_FALSE(w.window.findChild<ConnectCard*>()->isVisible());
    EXPECT_TRUE(w.window.findChild<Legend*>()->isVisible());
    w.hand.set(2.5);
    EXPECT_TRUE(soon([&] { return w.tile("LINK").startsWith("STALE 1 s"); }));
    EXPECT_TRUE(w.banner().startsWith("No packets since")) << w.banner().toStdString();
    w.hand.set(5.0);
    EXPECT_TRUE(soon([&] { return w.tile("LINK").startsWith("LOST 4 s"); }));
    w.live(5.1);
    EXPECT_TRUE(soon([&] { return w.tile("LINK").startsWith("LIVE"); }));
    EXPECT_EQ(w.banner(), "");
}

TEST(MainWindow, AsksToConnectWithWhatTheCardSays) {
    Window w;
    QSignalSpy spy(&w.window, &MainWindow::connectRequested);
    auto* card = w.window.findChild<ConnectCard*>();
    card->findChild<QComboBox*>("port")->setEditText("/dev/ttyUSB7");
    card->findChild<QComboBox*>("vehicle")->setCurrentText("packbot");
    card->findChild<QComboBox*>("baud")->setCurrentText("115200");
    card->findChild<QPushButton*>("connect")->click();
    ASSERT_EQ(spy.count(), 1);
    EXPECT_EQ(spy[0][0].value<ConnectRequest>(),
              (ConnectRequest{"/dev/ttyUSB7", 115200, "packbot", {}}));
    EXPECT_FALSE(card->isVisible());
}

TEST(MainWindow, DoesNotConnectToNothing) {
    Window w;
    auto* card = w.window.findChild<ConnectCard*>();
    card->findChild<QComboBox*>("port")->setEditText("");
    EXPECT_FALSE(card->findChild<QPushButton*>("connect")->isEnabled());
}

TEST(MainWindow, AsksToDisconnectWhileAPortIsOpen) {
    Window w;
    QSignalSpy spy(&w.window, &MainWindow::disconnectRequested);
    w.live(1.0);
    EXPECT_TRUE(soon([&] { return w.button("Disconnect") != nullptr; }));
    w.button("Disconnect")->click();
    EXPECT_EQ(spy.count(), 1);
}

TEST(MainWindow, PassesADroppedPlanOn) {
    Window w;
    QSignalSpy spy(&w.window, &MainWindow::planFileChosen);
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile("/plans/floor 1.png")});
    QDragEnterEvent enter({600, 400}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&w.window, &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent drop({600, 400}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&w.window, &drop);
    ASSERT_EQ(spy.count(), 1);
    EXPECT_EQ(spy[0][0].toString(), "/plans/floor 1.png");
}

TEST(MainWindow, LetsAPlanLoadBeCanceled) {
    Window w;
    QSignalSpy spy(&w.window, &MainWindow::planLoadCanceled);
    w.window.showPlanProgress(0.4);
    ASSERT_NE(w.button("Cancel"), nullptr);
    w.button("Cancel")->click();
    EXPECT_EQ(spy.count(), 1);
    w.window.showPlanProgress(std::nullopt);
    EXPECT_EQ(w.button("Cancel"), nullptr);
}

TEST(MainWindow, KeepsAnErrorUntilItIsAcknowledged) {
    Window w;
    w.window.showError({ErrorCode::kNotAnImage, "notes.txt", ""});
    EXPECT_TRUE(w.banner().contains("notes.txt"));
    QTest::qWait(250);
    EXPECT_TRUE(w.banner().contains("notes.txt"));
    w.button("Acknowledge")->click();
    EXPECT_EQ(w.banner(), "");
}

TEST(MainWindow, SaysOnceThatRecordingFails) {
    Window w;
    w.live(1.0);
    LiveBatch batch = test::sampleBatch(1.1, 1.0);
    batch.recorder.error = Error{ErrorCode::kDiskFull, "/missions/a.hedr", ""};
    w.window.applyBatch(batch);
    EXPECT_TRUE(w.banner().contains("full"));
    w.button("Acknowledge")->click();
    w.window.applyBatch(batch);
    EXPECT_EQ(w.banner(), "");
}

TEST(MainWindow, PausesFollowingOnADragAndOffersToResume) {
    Window w;
    w.live(1.0);
    const QPoint middle = w.map().rect().center();
    QTest::mousePress(&w.map(), Qt::LeftButton, {}, middle);
    QTest::mouseMove(&w.map(), middle + QPoint(40, 0));
    QTest::mouseMove(&w.map(), middle + QPoint(80, 0));
    QTest::mouseRelease(&w.map(), Qt::LeftButton, {}, middle + QPoint(80, 0));
    EXPECT_FALSE(w.map().following());
    ASSERT_NE(w.button("Resume following"), nullptr);
    w.button("Resume following")->click();
    EXPECT_TRUE(w.map().following());
    EXPECT_EQ(w.button("Resume following"), nullptr);
}

TEST(MainWindow, FollowsARobotThatLeavesTheScreenButNotWhenPaused) {
    Window w;
    w.live(1.0);
    LiveBatch batch = test::sampleBatch(1.1, 1.0);
    batch.tracks = {{"hedr_bayes", {{1.1, {{500.0, 500.0}, 0.0}, 0.0}}}};
    w.window.applyBatch(batch);
    const Point<View> at = w.map().view().viewFromWorld() * Point<World>{500.0, 500.0};
    EXPECT_TRUE(w.map().rect().contains(QPoint(qRound(at.x), qRound(at.y))));
    w.map().setFollowing(false);
    const ViewTransform before = w.map().view();
    batch.tracks = {{"hedr_bayes", {{1.2, {{900.0, 500.0}, 0.0}, 0.0}}}};
    w.window.applyBatch(batch);
    EXPECT_EQ(w.map().view(), before);
}

TEST(MainWindow, KeepsTheFollowedRobotBesideTheLegendInANarrowWindow) {
    Window w;
    w.window.resize(1024, 640);
    w.live(1.0);
    const auto* legend = w.window.findChild<Legend*>();
    ASSERT_TRUE(soon([&] { return legend->isVisible() && legend->x() > 0; }));
    LiveBatch batch = test::sampleBatch(1.1, 1.0);
    for (double along_m = 0.0; along_m < 60.0; along_m += 0.5) {
        batch.tracks = {{"hedr_bayes", {{1.1 + along_m, {{along_m, 12.0}, 0.0}, 0.0}}}};
        w.window.applyBatch(batch);
        const Point<View> at = w.map().view().viewFromWorld() * Point<World>{along_m, 12.0};
        ASSERT_LT(at.x, legend->x()) << along_m;
    }
}

TEST(MainWindow, IsWorkedByKeys) {
    Window w;
    w.live(1.0);
    w.map().setFocus();
    const double scale = w.map().view().pixels_per_metre;
    QTest::keyClick(&w.map(), Qt::Key_Plus);
    EXPECT_GT(w.map().view().pixels_per_metre, scale);
    QTest::keyClick(&w.map(), Qt::Key_R);
    EXPECT_FALSE(w.map().following());
    const double x = w.map().view().centre.x;
    QTest::keyClick(&w.map(), Qt::Key_Right);
    EXPECT_GT(w.map().view().centre.x, x);
    QSignalSpy spy(&w.window, &MainWindow::themeChanged);
    QTest::keyClick(&w.map(), Qt::Key_N);
    EXPECT_EQ(spy.count(), 1);
    EXPECT_NE(w.button("Day"), nullptr);
}

TEST(MainWindow, HidesATrailByItsLegend) {
    Window w;
    w.live(150.0);
    ASSERT_TRUE(soon([&] { return w.button("Odometry") != nullptr; }));
    const QColor orange = dayTheme().odometry;
    EXPECT_TRUE(soon([&] { return w.map().isSharp(); }));
    EXPECT_GT(w.pixels(orange), 20);
    w.button("Odometry")->click();
    EXPECT_TRUE(soon([&] { return w.map().isSharp(); }));
    EXPECT_EQ(w.pixels(orange), 0);
}

// The middle of a drive: odometry has left the building by metres.
TEST(MainWindow, MakesAnotherTrailThePrimaryOneWithAllThatItHasDrawn) {
    Window w;
    w.window.setPlan(test::samplePlan());
    w.live(0.0);
    w.live(150.0);
    ASSERT_TRUE(soon([&] { return w.button("Odometry carries the robot") != nullptr; }));
    ASSERT_TRUE(soon([&] { return w.map().isSharp(); }));
    const Theme day = dayTheme();
    const QString home = w.tile("HOME");
    const int accent = w.pixels(day.accent);
    EXPECT_EQ(w.pixels(day.hedr_bayes), 0);
    EXPECT_TRUE(w.tile("TRUST").startsWith("GOOD"));
    const QPoint before = w.robotAt(test::sampleBatch(150.0), "hedr_bayes");
    const QPoint after = w.robotAt(test::sampleBatch(150.0), "odometry");
    ASSERT_GT((before - after).manhattanLength(), 60);

    QSignalSpy spy(&w.window, &MainWindow::trailChoiceChanged);
    w.button("Odometry carries the robot")->click();
    EXPECT_EQ(spy.count(), 1);
    EXPECT_TRUE(w.tile("TRUST").startsWith("OFF, no heading check"));
    EXPECT_NE(w.tile("HOME"), home);
    ASSERT_TRUE(soon([&] { return w.map().isSharp(); }));
    EXPECT_EQ(w.pixels(day.odometry), 0) << "all of it is in the accent now";
    EXPECT_GT(w.pixels(day.accent), accent / 2);
    EXPECT_GT(w.pixels(day.hedr_bayes), 200) << "the old one is still there, all of it";
    EXPECT_EQ(w.colourAt(after), day.accent);
    EXPECT_NE(w.colourAt(before), day.accent);
    w.live(150.5);
    EXPECT_TRUE(w.tile("TRUST").startsWith("OFF"));

    w.map().setFocus();
    for (const char* trust : {"GOOD", "GOOD", "OFF"}) {  // hedr_bayes, robot, odometry
        QTest::keyClick(&w.map(), Qt::Key_T);
        EXPECT_TRUE(w.tile("TRUST").startsWith(trust)) << w.tile("TRUST").toStdString();
    }
}

TEST(MainWindow, ShowsTheSameMapWhetherATrailWasPrimaryFromTheStartOrLater) {
    QImage pictures[2];
    for (const bool from_the_start : {true, false}) {
        Window w;
        w.window.setPlan(test::samplePlan());
        if (from_the_start) w.window.setTrailChoice({.primary = "odometry"});
        w.live(0.0);
        w.live(150.0);
        if (!from_the_start) w.window.setTrailChoice({.primary = "odometry"});
        ASSERT_TRUE(soon([&] { return w.map().isSharp(); }));
        pictures[from_the_start] = w.mapPicture();
    }
    EXPECT_EQ(pictures[0], pictures[1]);
}

TEST(MainWindow, FollowsTheTrailThatIsPrimary) {
    Window w;
    w.live(1.0);
    LiveBatch batch = test::sampleBatch(1.1, 1.0);
    batch.tracks = {{"odometry", {{1.1, {{500.0, 500.0}, 0.0}, 0.0}}}};
    w.window.applyBatch(batch);
    const auto inSight = [&] {
        const Point<View> at = w.map().view().viewFromWorld() * Point<World>{500.0, 500.0};
        return w.map().rect().contains(QPoint(qRound(at.x), qRound(at.y)));
    };
    EXPECT_FALSE(inSight());
    w.window.setTrailChoice({.primary = "odometry"});
    EXPECT_TRUE(inSight());
}

// Plain odometry after a long drive: it may be anywhere.
TEST(MainWindow, ShowsTheSameMapHoweverUncertainThePositionIs) {
    QImage pictures[2];
    ViewTransform views[2];
    for (const bool uncertain : {true, false}) {
        Window w;
        w.window.setPlan(test::samplePlan());
        w.window.setTrailChoice({.primary = "odometry"});
        LiveBatch batch = test::sampleBatch(150.0);
        if (uncertain) batch.tracks[0].points.back().variance = {1200.0F, 0.0F, 1200.0F, 0.7F};
        w.hand.set(150.0);
        w.window.applyBatch(batch);
        EXPECT_EQ(w.tile("TRUST").contains("heading unknown"), uncertain);
        w.button("Fit")->click();
        ASSERT_TRUE(soon([&] { return w.map().isSharp(); }));
        pictures[uncertain] = w.mapPicture();
        views[uncertain] = w.map().view();
    }
    EXPECT_EQ(views[0], views[1]);
    EXPECT_EQ(pictures[0], pictures[1]) << "no ellipse hides the plan";
}

TEST(MainWindow, ForgetsTheMissionWhenToldTo) {
    Window w;
    w.live(1.0);
    w.window.clearMission();
    EXPECT_FALSE(w.window.findChild<Legend*>()->isVisible());
    EXPECT_TRUE(w.tile("HEADING").startsWith("–"));
}

TEST(MainWindow, NamesEverythingThatCanBeReachedAndReachesItByTab) {
    Window w;
    w.live(1.0);
    EXPECT_TRUE(soon([&] { return w.button("Odometry") != nullptr; }));
    for (auto* button : w.window.findChildren<QAbstractButton*>()) {
        if (!button->isVisible() || !button->isEnabled()) continue;
        EXPECT_FALSE(button->accessibleName().isEmpty() && button->text().isEmpty());
        EXPECT_FALSE(button->toolTip().isEmpty()) << button->text().toStdString();
        EXPECT_NE(button->focusPolicy() & Qt::TabFocus, 0) << button->text().toStdString();
    }
    std::set<QWidget*> reached;
    for (int i = 0; i < 60; ++i) {
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        reached.insert(QApplication::focusWidget());
    }
    for (const char* name : {"Follow", "Fit", "Plan", "Night", "Odometry", "Disconnect"}) {
        EXPECT_TRUE(reached.contains(w.button(name))) << name;
    }
    EXPECT_TRUE(reached.contains(&w.map()));
}

TEST(StatusStrip, GivesEveryTileItsRoomAtAnyWidth) {
    for (const int width : {1024, 1100, 1280, 1440, 1600, 2560}) {
        Window w;
        w.window.resize(width, 700);
        w.live(1.0);
        w.hand.set(80.0);
        EXPECT_TRUE(soon([&] { return w.tile("LINK").startsWith("LOST"); }));
        int right = 0;
        for (const auto* tile : w.window.findChildren<StatusTileView*>()) {
            EXPECT_GE(tile->x(), right) << width;
            EXPECT_GE(tile->width(), tile->neededWidth(15)) << width;
            right = tile->geometry().right();
        }
        EXPECT_LT(right, w.button("Disconnect")->x()) << width;
    }
}

// The first words, where the window is at its narrowest; what follows them may be left out.
TEST(StatusStrip, CutsNoWordOfTrustInANarrowWindow) {
    const auto robotIs = [](SuspendReason reason) {
        return NamedStatus{"robot", {.state = HedrState::kSuspended, .reason = reason}};
    };
    for (const NamedStatus& status :
         {NamedStatus{"odometry", {}}, robotIs(SuspendReason::kSearching),
          robotIs(SuspendReason::kOffCorridors), robotIs(SuspendReason::kTurning)}) {
        Window w;
        w.window.resize(1024, 640);
        LiveBatch batch = test::sampleBatch(1.0);
        batch.statuses = {status};
        w.window.setTrailChoice({.primary = status.name});
        w.hand.set(1.0);
        w.window.applyBatch(batch);
        for (const auto* tile : w.window.findChildren<StatusTileView*>()) {
            if (tile->accessibleName() != "TRUST") continue;
            const QString words = tile->toolTip().section('\n', 0, 0).section(" · ", 0, 0);
            EXPECT_FALSE(words.isEmpty());
            EXPECT_LE(figuresWidth(uiFont(13), words), tile->width() - 16) << words.toStdString();
        }
    }
}

}  // namespace
}  // namespace hedr
