// A session with several robots, all of them simulated.
#include <gtest/gtest.h>

#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QTemporaryDir>
#include <QTest>

#include "app/interrupted_robots.h"
#include "app/mission_files.h"
#include "app/session.h"
#include "app/settings_store.h"
#include "core/mission/mission_reader.h"
#include "core/mission/mission_writer.h"
#include "radio/source/link_address.h"
#include "ui/main_window.h"
#include "ui/panels/choice_note.h"
#include "ui/panels/connect_card.h"

namespace hedr {
namespace {

class RobotsOfASession : public testing::Test {
  protected:
    RobotsOfASession() {
        saveSettings({});
        QDir(QString::fromStdString(missionsFolder().string())).removeRecursively();
        window.show();
    }
    ~RobotsOfASession() override { saveSettings({}); }

    const FleetRobot& robot(RobotId id) const { return *window.fleet().find(id); }
    bool drives(RobotId id) const { return robot(id).model.trails().size() > 1; }
    std::vector<std::filesystem::path> missions() const {
        std::vector<std::filesystem::path> files;
        for (const auto& entry : std::filesystem::directory_iterator(missionsFolder())) {
            if (entry.path().extension() == ".hedr") files.push_back(entry.path());
        }
        return files;
    }

    MainWindow window;
    Session session{window, {}};
    const QString first = QStringLiteral("sim://packbot-corridors?seed=1&speed=20");
    const QString second = QStringLiteral("sim://packbot-corridors?seed=2&speed=20");
};

TEST_F(RobotsOfASession, AreEachHeardAndRecordedInAMissionOfTheirOwn) {
    session.connectToAll({first, second});
    EXPECT_EQ(window.chosenRobot(), kFirstRobot);
    ASSERT_TRUE(QTest::qWaitFor([&] { return drives(1) && drives(2); }, 60000));
    EXPECT_NE(window.fleet().callSign(robot(1)), window.fleet().callSign(robot(2)));
    ASSERT_TRUE(QTest::qWaitFor([&] { return missions().size() == 2; }, 20000));
    for (const auto& file : missions()) EXPECT_TRUE(MissionReader::open(file)) << file;
}

TEST_F(RobotsOfASession, GoOnWhileOneIsDisconnectedAndTakenAway) {
    session.connectToAll({first, second});
    ASSERT_TRUE(QTest::qWaitFor([&] { return drives(1) && drives(2); }, 60000));
    emit window.disconnectRequested(2);
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return robot(2).model.last().port == PortState::kClosed; }, 20000));
    emit window.robotRemoved(2);
    const std::size_t points = robot(1).model.primary()->track.size();
    EXPECT_TRUE(QTest::qWaitFor(
        [&] { return robot(1).model.primary()->track.size() > points + 50; }, 20000));
}

TEST_F(RobotsOfASession, AreConnectedFromTheCardOneAfterTheOther) {
    ConnectRequest request;
    request.port = first;
    request.call_sign = "Alpha";
    emit window.connectRequested(request, kFirstRobot);
    ASSERT_TRUE(QTest::qWaitFor([&] { return drives(1); }, 60000));
    request.port = second;
    const RobotId other = window.addRobot();
    emit window.connectRequested(request, other);
    EXPECT_TRUE(QTest::qWaitFor([&] { return drives(other); }, 60000));
    EXPECT_EQ(loadSettings().connection.call_sign, "Alpha");
}

// What a program that is killed leaves: missions whose logs were not put in order.
class KilledSession : public testing::Test {
  protected:
    KilledSession() {
        saveSettings({});
        for (const OpenMission& open : openMissions()) forgetOpenMission(open.file);
        leaveBehind();
    }
    ~KilledSession() override { saveSettings({}); }

    // Two robots drive; their files are copied while they are recorded. The second one began first.
    void leaveBehind() {
        MainWindow window;
        Session session(window, {});
        const RobotId second = window.addRobot();
        emit window.connectRequested({.port = port(2), .call_sign = "Bravo"}, second);
        ASSERT_TRUE(QTest::qWaitFor([&] { return pointsOf(window, second) > 50; }, 60000));
        emit window.connectRequested({.port = port(1), .call_sign = "Alpha"}, kFirstRobot);
        ASSERT_TRUE(QTest::qWaitFor([&] { return pointsOf(window, kFirstRobot) > 50; }, 60000));
        ASSERT_TRUE(QTest::qWaitFor([] { return openMissions().size() == 2; }, 20000));
        for (const OpenMission& open : openMissions()) {
            OpenMission copy = open;
            copy.file = folder.filePath(QFileInfo(open.file).fileName());
            ASSERT_TRUE(QTest::qWaitFor([&] { return copied(open.file, copy.file); }, 60000));
            left.push_back(copy);
        }
        ASSERT_EQ(left.size(), 2U);
        for (const OpenMission& each : left) rememberOpenMission(each);
    }
    // False where the recorder wrote meanwhile.
    static bool copied(const QString& from, const QString& to) {
        for (const char* end : {"", "-wal"}) {
            QFile::remove(to + end);
            if (!QFile::copy(from + end, to + end)) return false;
        }
        return interruptedIn(to.toStdString()) &&
               !MissionReader::open(to.toStdString())->salvaged();
    }
    static QString port(int seed) {
        return QStringLiteral("sim://packbot-corridors?seed=%1&speed=20").arg(seed);
    }
    static std::size_t pointsOf(const MainWindow& window, RobotId id) {
        const FleetRobot* robot = window.fleet().find(id);
        if (!robot || robot->model.trails().empty()) return 0;
        return robot->model.primary()->track.size();
    }
    static QString question(const MainWindow& window) {
        for (const auto* note : window.findChildren<ChoiceNote*>()) {
            if (note->isVisible()) return note->findChild<QLabel*>()->text();
        }
        return {};
    }

    QTemporaryDir folder;
    std::vector<OpenMission> left;
};

TEST_F(KilledSession, GoesOnWithEveryRobot) {
    EXPECT_EQ(openMissions(), left) << "those that were closed in good order are forgotten";
    MainWindow window;
    window.show();
    Session session(window, {});
    session.offerResuming();
    EXPECT_TRUE(question(window).startsWith(
        "The missions of 2 robots were interrupted. The first began at "))
        << question(window).toStdString();
    emit window.resumeWished();
    EXPECT_EQ(question(window), "");
    EXPECT_EQ(window.fleet().size(), 2U);
    EXPECT_EQ(window.chosenRobot(), kFirstRobot);
    for (const RobotId id : {kFirstRobot, kFirstRobot + 1}) {
        const FleetRobot& robot = *window.fleet().find(id);
        ASSERT_TRUE(QTest::qWaitFor([&] { return pointsOf(window, id) > 0; }, 60000)) << id;
        EXPECT_EQ(toText(robot.model.last().address), port(static_cast<int>(id)));
        EXPECT_EQ(window.fleet().callSign(robot), id == kFirstRobot ? "Alpha" : "Bravo");
    }
    const auto noted = [&] { return openMissions() == left; };
    EXPECT_TRUE(QTest::qWaitFor(noted, 20000)) << "to be found again if this one is killed, too";
}

TEST_F(KilledSession, AsksForTheRobotsThatCannotBeReachedAsBefore) {
    for (OpenMission each : left) {
        if (each.robot == kFirstRobot) each.request.vehicle_file = "/nowhere/vehicle.toml";
        if (each.robot != kFirstRobot) each.request.identity = "an adapter that is not plugged in";
        rememberOpenMission(each);
    }
    MainWindow window;
    window.show();
    Session session(window, {});
    session.offerResuming();
    emit window.resumeWished();
    EXPECT_TRUE(window.findChild<ConnectCard*>()->isVisible()) << "for the first one";
    EXPECT_TRUE(question(window).startsWith("The mission of ")) << "the other one waits";
    EXPECT_EQ(window.fleet().size(), 1U);
    EXPECT_EQ(openMissions().size(), 2U);
}

TEST_F(KilledSession, LeavesAMissionAloneThatGoesOnInAnotherWindow) {
    MainWindow window;
    window.show();
    Session session(window, {});
    session.offerResuming();
    {
        const auto other = MissionWriter::create(left.front().file.toStdString(), {});
        ASSERT_TRUE(other);
        emit window.resumeDeclined();
        EXPECT_EQ(openMissions(), std::vector({left.front()}));
    }
}

TEST_F(KilledSession, GoesOnWithTheNewestOfEachConnection) {
    for (OpenMission each : left) {
        each.request.port = port(1);
        rememberOpenMission(each);
    }
    EXPECT_EQ(findInterruptedRobots().size(), 1U);
    EXPECT_EQ(openMissions().size(), 1U);
}

TEST(InterruptedRobot, IsLocatedByItsAdapter) {
    const std::vector<SerialPortEntry> ports{{"/dev/ttyUSB0", "radio", "B"},
                                             {"/dev/ttyUSB1", "radio", "A"}};
    const ConnectRequest request{.port = "/dev/ttyUSB0", .identity = "A"};
    EXPECT_EQ(located(request, ports).port, "/dev/ttyUSB1");
    EXPECT_EQ(located({.port = "/dev/ttyUSB0", .identity = "C"}, ports).port, "");
    EXPECT_EQ(located({.port = "tcp://robot:1"}, ports).port, "tcp://robot:1");
}

TEST_F(KilledSession, IsOfferedOnceWhereTheOperatorDeclines) {
    {
        MainWindow window;
        Session session(window, {});
        session.offerResuming();
        emit window.resumeDeclined();
    }
    EXPECT_TRUE(openMissions().empty());
    EXPECT_EQ(loadSettings().declined_missions.size(), 2);
    MainWindow window;
    window.show();
    Session session(window, {});
    session.offerResuming();
    EXPECT_EQ(question(window), "");
    for (const OpenMission& each : left)
        EXPECT_FALSE(QFile::exists(each.file + "-wal")) << "closed";
}

// A damaged mission cannot be closed, so that it stays as it was left.
TEST_F(KilledSession, IsOfferedByItsFileAloneUntilItIsDeclined) {
    QDir().mkpath(QString::fromStdString(missionsFolder().string()));
    const QString file =
        QString::fromStdString((missionsFolder() / "2999-01-01T00-00-00.hedr").string());
    for (const char* end : {"", "-wal"})
        ASSERT_TRUE(QFile::copy(left.front().file + end, file + end));
    for (const OpenMission& each : left) forgetOpenMission(each.file);
    const std::vector<InterruptedRobot> found = findInterruptedRobots();
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].mission.file, file.toStdString());
    EXPECT_EQ(found[0].request.port, "") << "nobody knows how it was reached";
    rememberDeclined(file);
    EXPECT_TRUE(findInterruptedRobots().empty());
    for (const char* end : {"", "-wal", "-shm"}) QFile::remove(file + end);
}

TEST_F(KilledSession, IsOfferedNoMoreOnceTheOperatorHasGoneOnToSomethingElse) {
    {
        MainWindow window;
        Session session(window, {});
        session.offerResuming();
        session.connectToAll({port(3)});
        EXPECT_EQ(openMissions(), left) << "nothing is heard yet";
        ASSERT_TRUE(QTest::qWaitFor([&] { return pointsOf(window, kFirstRobot) > 0; }, 60000));
    }
    EXPECT_TRUE(openMissions().empty());
    for (const OpenMission& each : left) EXPECT_TRUE(QFile::exists(each.file + "-wal"));
}

}  // namespace
}  // namespace hedr
