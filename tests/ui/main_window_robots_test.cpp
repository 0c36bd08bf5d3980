#include <gtest/gtest.h>

#include <QDir>
#include <QSignalSpy>
#include <QTest>

#include "tests/ui/window_user.h"
#include "ui/panels/connect_card.h"
#include "ui/panels/robots_card.h"
#include "ui/site/site_desk.h"

namespace hedr {
namespace {

// The sample drive as another robot makes it, which starts elsewhere.
LiveBatch driveBeside(double second, Vector<World> aside) {
    LiveBatch batch = test::sampleBatch(second);
    for (NamedPoints& track : batch.tracks) {
        for (TrackPoint& point : track.points) point.pose.position = point.pose.position + aside;
    }
    return batch;
}

class SeveralRobots : public testing::Test {
  protected:
    SeveralRobots() {
        user.live(30.0);
        second = user.window.addRobot();
        hearSecond();
    }
    void hearSecond() { user.window.applyBatch(driveBeside(30.0, {0.0, -3.0}), second); }
    const RobotsCard& list() const { return *user.window.findChild<RobotsCard*>(); }
    RobotRow* row(const QString& call_sign) const {
        for (auto* row : list().findChildren<RobotRow*>()) {
            if (row->accessibleName() == call_sign) return row;
        }
        return nullptr;
    }
    int pixelsOf(std::size_t place) const {
        return user.pixels(colourOf(robotMark(place), dayTheme()));
    }

    WindowUser user;
    RobotId second = 0;
};

TEST(OneRobot, HasNoListOfRobots) {
    WindowUser user;
    user.live(30.0);
    EXPECT_FALSE(user.window.findChild<RobotsCard*>()->isVisible());
    EXPECT_EQ(user.tile("LINK").left(4), "LIVE");
}

TEST_F(SeveralRobots, EachHasItsColourOnTheMapAndItsLineInTheList) {
    ASSERT_TRUE(list().isVisible());
    ASSERT_TRUE(soon([&] { return user.map().isSharp(); }));
    EXPECT_GT(pixelsOf(0), 50) << "the first one's trail, though the second one is chosen";
    EXPECT_GT(pixelsOf(1), 50);
    EXPECT_EQ(list().findChildren<RobotRow*>().size(), 2);
}

TEST_F(SeveralRobots, TheStripIsAboutTheChosenOneAndSaysWhich) {
    EXPECT_FALSE(user.tile("PACKBOT 2 · LINK").isEmpty());
    QTest::mouseClick(row("packbot"), Qt::LeftButton);
    EXPECT_TRUE(user.tile("PACKBOT 2 · LINK").isEmpty());
    EXPECT_FALSE(user.tile("PACKBOT · LINK").isEmpty());
    QTest::keyClick(&user.map(), Qt::Key_V);
    EXPECT_FALSE(user.tile("PACKBOT 2 · LINK").isEmpty());
}

TEST_F(SeveralRobots, AClickOnTheMapTurnsToTheRobotThere) {
    user.window.chooseRobot(kFirstRobot);
    const QPoint at = user.robotAt(driveBeside(30.0, {0.0, -3.0}), "hedr_bayes");
    QTest::mouseClick(&user.map(), Qt::LeftButton, {}, at);
    EXPECT_EQ(user.window.chosenRobot(), second);
}

TEST_F(SeveralRobots, OneThatIsLostIsSaidWhileAnotherIsChosen) {
    user.window.chooseRobot(kFirstRobot);
    user.live(33.5);
    QTest::qWait(150);
    EXPECT_TRUE(user.banner().startsWith("packbot 2: ")) << user.banner().toStdString();
    EXPECT_EQ(row("packbot 2")->accessibleDescription().left(4), "LOST");
    EXPECT_EQ(row("packbot")->accessibleDescription(), "LIVE");
}

TEST_F(SeveralRobots, RequestsGoToTheChosenOne) {
    QSignalSpy disconnected(&user.window, &MainWindow::disconnectRequested);
    QTest::keyClick(&user.window, Qt::Key_C);
    ASSERT_EQ(disconnected.size(), 1);
    EXPECT_EQ(disconnected[0][0].value<RobotId>(), second);
}

TEST_F(SeveralRobots, AThirdIsConnectedBesideThem) {
    QSignalSpy asked(&user.window, &MainWindow::connectRequested);
    QTest::keyClick(&user.window, Qt::Key_C, Qt::ShiftModifier);
    auto* card = user.window.findChild<ConnectCard*>();
    ASSERT_TRUE(card->isVisible());
    EXPECT_EQ(list().findChildren<RobotRow*>().size(), 3);
    card->findChild<QComboBox*>("port")->setEditText("udp://:14550");
    card->findChild<QLineEdit*>("call_sign")->setText(" Charlie ");
    card->findChild<QPushButton*>("connect")->click();
    ASSERT_EQ(asked.size(), 1);
    EXPECT_EQ(asked[0][1].value<RobotId>(), user.window.chosenRobot());
    EXPECT_NE(asked[0][1].value<RobotId>(), second);
    EXPECT_NE(row("Charlie"), nullptr);
}

TEST_F(SeveralRobots, OneThatIsDisconnectedCanBeTakenOffTheList) {
    QSignalSpy removed(&user.window, &MainWindow::robotRemoved);
    EXPECT_EQ(user.button("Remove packbot 2"), nullptr) << "it is connected";
    LiveBatch over = test::sampleBatch(61.0, 60.0);
    over.port = PortState::kClosed;
    user.window.applyBatch(over, second);
    QTest::qWait(150);
    ASSERT_NE(user.button("Remove packbot 2"), nullptr);
    user.button("Remove packbot 2")->click();
    EXPECT_EQ(removed.size(), 1);
    EXPECT_FALSE(list().isVisible());
    EXPECT_EQ(user.window.chosenRobot(), kFirstRobot);
    user.window.applyBatch(test::sampleBatch(62.0), second);  // late: nothing happens
}

TEST_F(SeveralRobots, EachIsOnItsFloor) {
    SiteModel& site = user.window.desk().site();
    Site two = site.site();
    two.floors.push_back({.name = "Floor 2"});
    site.edit(two);
    site.moveRobot(1);
    user.window.chooseRobot(kFirstRobot);
    EXPECT_EQ(site.floorIndex(), 0U) << "the map goes to the robot that it follows";
    EXPECT_EQ(site.robotFloorIndex(), 0U);
    ASSERT_TRUE(soon([&] { return user.map().isSharp(); }));
    EXPECT_GT(pixelsOf(0), 50);
    user.window.chooseRobot(second);
    EXPECT_EQ(site.floorIndex(), 1U);
}

// Pictures for people to look at, as those of screenshots_test.cpp.
class RobotsScreenshots : public testing::TestWithParam<ThemeName> {
  protected:
    void hearFour() {
        const Vector<World> aside[] = {{}, {0.4, -1.0}, {-2.0, 0.5}, {1.0, 0.8}};
        const double seconds[] = {120.0, 60.0, 20.0, 90.0};
        const char* names[] = {"alpha", "bravo", "charlie", "delta"};
        user.hand.set(120.0);
        for (std::size_t i = 0; i < 4; ++i) {
            const RobotId robot = i == 0 ? kFirstRobot : user.window.addRobot();
            LiveBatch batch = driveBeside(seconds[i], aside[i]);
            batch.last_byte = batch.last_frame = test::atSecond(i == 2 ? 108.0 : 119.9);
            batch.robot->vehicle = names[i];
            user.window.applyBatch(batch, robot);
        }
        user.window.chooseRobot(2);
    }
    void write(const QString& name) {
        QDir().mkpath(QStringLiteral(HEDR_BINARY_DIR "/screenshots"));
        user.window.fitMap();
        QTest::qWait(200);
        ASSERT_TRUE(soon([&] { return user.map().isSharp(); }));
        const QString file = QStringLiteral(HEDR_BINARY_DIR "/screenshots/%1-%2-%3.png")
                                 .arg(name, GetParam() == ThemeName::kDay ? "day" : "night")
                                 .arg(user.window.width());
        EXPECT_TRUE(user.window.grab().save(file)) << file.toStdString();
    }

    WindowUser user;
};

TEST_P(RobotsScreenshots, FourOnOneMapAndWhoIsTold) {
    user.window.setTheme(GetParam());
    user.window.setPlan(test::samplePlan());
    hearFour();
    for (const QSize size : {QSize(1600, 1000), QSize(1024, 640)}) {
        user.window.resize(size);
        write("robots");
    }
    QTest::keyClick(&user.window, Qt::Key_O);
    user.window.showPublishing(
        {{.target = defaultTarget(PublishKind::kJson), .port = 10120, .clients = 2},
         {.target = defaultTarget(PublishKind::kNmea),
          .port = 10110,
          .error = Error{ErrorCode::kNotOnGlobe, "NMEA", {}}}});
    for (const QSize size : {QSize(1600, 1000), QSize(1024, 640)}) {
        user.window.resize(size);
        write("publish");
    }
}

INSTANTIATE_TEST_SUITE_P(Both, RobotsScreenshots,
                         testing::Values(ThemeName::kDay, ThemeName::kNight));

TEST_F(SeveralRobots, AWarningSaysWhichOneItIsAboutAndWaitsItsTurn) {
    LiveBatch batch = driveBeside(30.0, {0.0, -3.0});
    batch.tracks.clear();
    batch.warnings = {{ErrorCode::kWheelsUnknown, "text robot", "they are taken to be 1 m apart"}};
    batch.wheels_assumed = true;
    user.window.applyBatch(batch, second);
    EXPECT_TRUE(user.banner().startsWith("packbot 2: text robot does not say how its wheels"))
        << user.banner().toStdString();
    user.window.showError({ErrorCode::kDiskFull, "/missions", {}});
    EXPECT_TRUE(user.banner().contains("/missions")) << user.banner().toStdString();
    QAbstractButton* next = user.button("Next (1)");
    ASSERT_TRUE(soon([&] { return next->isEnabled(); }));
    next->click();
    EXPECT_TRUE(user.banner().startsWith("packbot 2: "));
    ASSERT_TRUE(soon([&] { return next->isEnabled(); }));
    next->click();
    EXPECT_EQ(user.banner(), "");
}

}  // namespace
}  // namespace hedr
