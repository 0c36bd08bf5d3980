#include "radio/publish/pose_publisher.h"

#include <gtest/gtest.h>

#include <QHostAddress>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTest>
#include <QUdpSocket>
#include <limits>
#include <memory>

#include "tests/radio/publish/sample_pose.h"

namespace hedr {
namespace {

const QHostAddress kHere(QHostAddress::LocalHost);

// A publisher whose clocks are moved by hand.
class Publishing {
  public:
    PosePublisher publisher{{.now = [this] { return test::sampleTime(now_s).now; },
                             .utc_now = [this] { return test::sampleTime(now_s).utc; }}};
    double now_s = 0.1;
};

// Any that is free; it is taken again at once.
std::uint16_t freePort() {
    QTcpServer server;
    server.listen(kHere);
    return server.serverPort();
}

PublishTarget json() { return {.kind = PublishKind::kJson, .port = freePort()}; }

std::unique_ptr<QTcpSocket> clientOf(const PosePublisher& publisher) {
    auto client = std::make_unique<QTcpSocket>();
    client->connectToHost(kHere, publisher.states().front().port);
    return client;
}

QByteArray nextLine(QTcpSocket& client) {
    EXPECT_TRUE(QTest::qWaitFor([&] { return client.canReadLine(); }));
    return client.readLine();
}

bool datagramComes(QUdpSocket& socket, int within_ms) {
    return QTest::qWaitFor([&] { return socket.hasPendingDatagrams(); }, within_ms);
}

QByteArray takeDatagram(QUdpSocket& socket) {
    QByteArray datagram(static_cast<qsizetype>(socket.pendingDatagramSize()), 0);
    socket.readDatagram(datagram.data(), datagram.size());
    return datagram;
}

TEST(PosePublisher, IsSilentUntilATargetIsSet) {
    Publishing it;
    it.publisher.setPoses({test::samplePose()});
    EXPECT_TRUE(it.publisher.states().empty());
}

TEST(PosePublisher, TellsEveryRobotAsJsonAndGoesOnWhileThePoseGrowsOld) {
    Publishing it;
    it.publisher.setTargets({json()});
    PublishedPose second = test::samplePose();
    second.call_sign = "Robot 2";
    PublishedPose broken = test::samplePose();
    broken.call_sign = "Robot 3";
    broken.pose.position.x = std::numeric_limits<double>::quiet_NaN();
    it.publisher.setPoses({test::samplePose(), broken, second});
    const auto client = clientOf(it.publisher);
    EXPECT_TRUE(nextLine(*client).contains("\"Robot 1\""));
    EXPECT_TRUE(nextLine(*client).contains("\"Robot 2\""));
    EXPECT_TRUE(nextLine(*client).contains("\"link\":\"live\""));
    it.now_s = 4.0;  // and nobody tells it anything new
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return client->canReadLine() && client->readLine().contains("\"link\":\"lost\""); }));
    EXPECT_EQ(it.publisher.states().front().clients, 1U);
}

TEST(PosePublisher, TellsTheChosenRobotAsNmea) {
    Publishing it;
    it.publisher.setTargets({{.kind = PublishKind::kNmea, .port = freePort()}});
    const auto client = clientOf(it.publisher);
    EXPECT_TRUE(nextLine(*client).contains(",V,")) << "there is no pose yet";
    it.publisher.setPoses({test::samplePose()});
    ASSERT_TRUE(QTest::qWaitFor([&] {
        return client->canReadLine() && client->readLine().startsWith("$GPRMC,090807.15,A,4808.");
    }));
}

TEST(PosePublisher, TellsNoOtherRobotAsNmeaWhereTheChosenOneIsNowhere) {
    Publishing it;
    it.publisher.setTargets({{.kind = PublishKind::kNmea, .port = freePort()}});
    PublishedPose other = test::samplePose();
    other.chosen = false;
    it.publisher.setPoses({other});
    const auto client = clientOf(it.publisher);
    for (int i = 0; i < 4; ++i) EXPECT_FALSE(nextLine(*client).contains(",A,"));
}

TEST(PosePublisher, SendsCotAndStopsWhenThePoseIsStale) {
    QUdpSocket listener;
    ASSERT_TRUE(listener.bind(kHere));
    Publishing it;
    it.publisher.setTargets({{.kind = PublishKind::kCot, .port = listener.localPort()}});
    it.publisher.setPoses({test::samplePose()});
    ASSERT_TRUE(datagramComes(listener, 5000));
    EXPECT_TRUE(takeDatagram(listener).contains("callsign=\"Robot 1\""));
    it.now_s = 2.0;
    while (listener.hasPendingDatagrams()) takeDatagram(listener);
    EXPECT_FALSE(datagramComes(listener, 1500));
}

TEST(PosePublisher, SaysThatTheSiteIsNotOnTheGlobeAndWhenItIs) {
    Publishing it;
    it.publisher.setTargets({{.kind = PublishKind::kNmea, .port = freePort()}, json()});
    PublishedPose pose = test::samplePose();
    pose.tie.reset();
    it.publisher.setPoses({pose});
    const auto error = [&] { return it.publisher.states().front().error; };
    ASSERT_TRUE(QTest::qWaitFor([&] { return error().has_value(); }));
    EXPECT_EQ(error()->code, ErrorCode::kNotOnGlobe);
    EXPECT_TRUE(error()->subject.starts_with("nmea=tcp://:"));
    EXPECT_FALSE(it.publisher.states().back().error) << "JSON has metres";
    it.publisher.setPoses({test::samplePose()});
    EXPECT_TRUE(QTest::qWaitFor([&] { return !error().has_value(); }));
}

TEST(PosePublisher, ListensOnThisComputerOnly) {
    Publishing it;
    it.publisher.setTargets({json()});
    QTcpSocket from_elsewhere;  // 127.0.0.2 is another address of the same computer
    from_elsewhere.connectToHost(QStringLiteral("127.0.0.2"), it.publisher.states().front().port);
    EXPECT_TRUE(QTest::qWaitFor(
        [&] { return from_elsewhere.error() == QTcpSocket::ConnectionRefusedError; }));
}

TEST(PosePublisher, KeepsTheClientsOfATargetThatStays) {
    Publishing it;
    const PublishTarget stays = json();
    it.publisher.setTargets({stays});
    it.publisher.setPoses({test::samplePose()});
    const auto client = clientOf(it.publisher);
    nextLine(*client);
    it.publisher.setTargets({{.kind = PublishKind::kNmea, .port = freePort()}, stays});
    EXPECT_EQ(it.publisher.states().back().clients, 1U);
    it.publisher.setTargets({{.kind = PublishKind::kNmea, .port = stays.port}});
    EXPECT_FALSE(it.publisher.states().front().error) << "the port was given up first";
    it.publisher.setTargets({});
    EXPECT_TRUE(it.publisher.states().empty());
    EXPECT_TRUE(QTest::qWaitFor([&] { return client->state() == QTcpSocket::UnconnectedState; }));
}

TEST(PosePublisher, SaysThatAPortIsTaken) {
    QTcpServer other;
    ASSERT_TRUE(other.listen(kHere));
    Publishing it;
    it.publisher.setTargets({{.kind = PublishKind::kJson, .port = other.serverPort()}});
    ASSERT_TRUE(it.publisher.states().front().error);
    EXPECT_EQ(it.publisher.states().front().error->code, ErrorCode::kAddressInUse);
}

TEST(PosePublisher, SaysThatNothingCanBeSentToAHostThatIsNone) {
    Publishing it;
    it.publisher.setTargets({{PublishKind::kCot, QStringLiteral("not..a.name"), 4242}});
    it.publisher.setPoses({test::samplePose()});
    ASSERT_TRUE(QTest::qWaitFor([&] { return it.publisher.states().front().error.has_value(); }));
    EXPECT_EQ(it.publisher.states().front().error->code, ErrorCode::kUnreachable);
}

}  // namespace
}  // namespace hedr
