#include "ui/main_window.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QComboBox>
#include <QDropEvent>
#include <QMimeData>
#include <QSignalSpy>
#include <QTest>

#include "tests/ui/scene.h"
#include "tests/ui/window_user.h"
#include "ui/map/map_view.h"
#include "ui/panels/banner.h"
#include "ui/panels/connect_card.h"
#include "ui/panels/hint.h"
#include "ui/panels/legend.h"

namespace hedr {
namespace {

TEST(MainWindow, ShowsAFirstTimeUserHowToBegin) {
    WindowUser w;
    EXPECT_TRUE(w.window.findChild<ConnectCard*>()->isVisible());
    EXPECT_TRUE(w.window.findChild<Hint*>()->isVisible());
    EXPECT_FALSE(w.window.findChild<Legend*>()->isVisible());
    EXPECT_EQ(w.tile("LINK"), "OFF, not connected");
}

TEST(MainWindow, ShowsAMissionThatGoesLiveStaleLostAndLiveAgain) {
    WindowUser w;
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
    WindowUser w;
    QSignalSpy spy(&w.window, &MainWindow::connectRequested);
    auto* card = w.window.findChild<ConnectCard*>();
    card->findChild<QComboBox*>("port")->setEditText("/dev/ttyUSB7");
    card->findChild<QComboBox*>("vehicle")->setCurrentText("packbot");
    card->findChild<QComboBox*>("baud")->setCurrentText("115200");
    card->findChild<QPushButton*>("connect")->click();
    ASSERT_EQ(spy.count(), 1);
    EXPECT_EQ(spy[0][0].value<ConnectRequest>(),
              (ConnectRequest{"/dev/ttyUSB7", 115200, {}, "packbot", {}, {}}));
    EXPECT_FALSE(card->isVisible());
}

TEST(MainWindow, DoesNotConnectToNothing) {
    WindowUser w;
    auto* card = w.window.findChild<ConnectCard*>();
    card->findChild<QComboBox*>("port")->setEditText("");
    EXPECT_FALSE(card->findChild<QPushButton*>("connect")->isEnabled());
}

TEST(MainWindow, AsksToDisconnectWhileAPortIsOpen) {
    WindowUser w;
    QSignalSpy spy(&w.window, &MainWindow::disconnectRequested);
    w.live(1.0);
    EXPECT_TRUE(soon([&] { return w.button("Disconnect") != nullptr; }));
    w.button("Disconnect")->click();
    EXPECT_EQ(spy.count(), 1);
}

TEST(MainWindow, PassesADroppedPlanOn) {
    WindowUser w;
    QSignalSpy spy(&w.window, &MainWindow::planFileChosen);
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile("/plans/floor 1.png")});
    QDragEnterEvent enter({600, 400}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&w.window, &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent drop({600, 400}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&w.window, &drop);
    ASSERT_TRUE(soon([&] { return spy.count() == 1; }));
    EXPECT_EQ(spy[0][0].value<PlanFileWish>(), (PlanFileWish{.file = "/plans/floor 1.png"}));
}

TEST(MainWindow, LetsAPlanLoadBeCanceled) {
    WindowUser w;
    QSignalSpy spy(&w.window, &MainWindow::planLoadCanceled);
    w.window.showPlanProgress(0.4);
    ASSERT_NE(w.button("Cancel"), nullptr);
    w.button("Cancel")->click();
    EXPECT_EQ(spy.count(), 1);
    w.window.showPlanProgress(std::nullopt);
    EXPECT_EQ(w.button("Cancel"), nullptr);
}

TEST(MainWindow, KeepsAnErrorUntilItIsAcknowledged) {
    WindowUser w;
    w.window.showError({ErrorCode::kNotAnImage, "notes.txt", ""});
    EXPECT_TRUE(w.banner().contains("notes.txt"));
    QTest::qWait(250);
    EXPECT_TRUE(w.banner().contains("notes.txt"));
    w.button("Acknowledge")->click();
    EXPECT_EQ(w.banner(), "");
}

TEST(MainWindow, SaysOnceThatRecordingFails) {
    WindowUser w;
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
    WindowUser w;
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
    WindowUser w;
    w.live(1.0);
    LiveBatch batch = test::sampleBatch(1.1, 1.0);
    batch.tracks = {{"hedr_bayes", {{1.1, {{500.0, 500.0}, 0.0}, 0.0}}}};
    w.hand.set(1.1);
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
    WindowUser w;
    w.window.resize(1024, 640);
    w.live(1.0);
    const auto* legend = w.window.findChild<Legend*>();
    ASSERT_TRUE(soon([&] { return legend->isVisible() && legend->x() > 0; }));
    LiveBatch batch = test::sampleBatch(1.1, 1.0);
    for (double along_m = 0.0; along_m < 60.0; along_m += 0.5) {
        batch.tracks = {{"hedr_bayes", {{1.1 + along_m, {{along_m, 12.0}, 0.0}, 0.0}}}};
        w.hand.set(1.1 + along_m);
        w.window.applyBatch(batch);
        const Point<View> at = w.map().view().viewFromWorld() * Point<World>{along_m, 12.0};
        ASSERT_LT(at.x, legend->x()) << along_m;
    }
}

TEST(MainWindow, IsWorkedByKeys) {
    WindowUser w;
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

TEST(MainWindow, ForgetsTheMissionWhenToldTo) {
    WindowUser w;
    w.live(1.0);
    w.window.clearMission();
    EXPECT_FALSE(w.window.findChild<Legend*>()->isVisible());
    EXPECT_TRUE(w.tile("HEADING").startsWith("–"));
}

TEST(MainWindow, NamesEverythingThatCanBeReachedAndReachesItByTab) {
    WindowUser w;
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

}  // namespace
}  // namespace hedr
