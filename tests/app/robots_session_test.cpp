// A session with several robots, all of them simulated.
#include <gtest/gtest.h>

#include <QDir>
#include <QTest>

#include "app/session.h"
#include "app/settings_store.h"
#include "core/mission/mission_reader.h"
#include "ui/main_window.h"

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

}  // namespace
}  // namespace hedr
