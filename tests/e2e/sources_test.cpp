// Every kind of byte source: what comes, what goes back, and what happens when it goes away.
#include <gtest/gtest.h>
#include <termios.h>

#include <QElapsedTimer>
#include <QNetworkDatagram>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTemporaryDir>
#include <QUdpSocket>

#include "radio/source/serial_source.h"
#include "radio/source/tcp_source.h"
#include "radio/source/udp_source.h"
#include "tests/e2e/program.h"
#include "tests/e2e/talking_robot.h"
#include "tests/radio/source/source_listener.h"
#include "ui/error_text.h"

namespace hedr {
namespace {

const QHostAddress kHere(QHostAddress::LocalHost);

TEST(TcpSource, ReadsWritesAndComesBackWhenTheRobotWasRestarted) {
    auto robot = std::make_unique<QTcpServer>();
    ASSERT_TRUE(robot->listen(kHere));
    const std::uint16_t port = robot->serverPort();
    TcpSource source({"127.0.0.1", port});
    SourceListener heard(source);
    source.open();
    ASSERT_TRUE(soon([&] { return heard.opened == 1 && robot->hasPendingConnections(); }));
    QTcpSocket* peer = robot->nextPendingConnection();
    peer->write("hello");
    ASSERT_TRUE(soon([&] { return heard.bytes == "hello"; }));
    source.write("request");
    ASSERT_TRUE(soon([&] { return peer->bytesAvailable() == 7; }));

    robot.reset();  // with its connection
    ASSERT_TRUE(soon([&] { return heard.errors.size() == 1; }));
    EXPECT_EQ(heard.errors[0].code, ErrorCode::kPeerMissing);
    robot = std::make_unique<QTcpServer>();
    ASSERT_TRUE(robot->listen(kHere, port));
    EXPECT_TRUE(soon([&] { return heard.opened == 2; }, 2000)) << "back within 2 s";
    EXPECT_EQ(heard.errors.size(), 1U) << "an outage is told once";
}

TEST(TcpListenSource, TakesTheNewestConnectionForTheRobots) {
    TcpListenSource source(TcpListenAddress{"127.0.0.1", 0});
    SourceListener heard(source);
    source.open();
    ASSERT_TRUE(soon([&] { return !heard.errors.empty(); })) << "nobody has connected yet";
    QTcpSocket first;
    first.connectToHost(kHere, source.port());
    ASSERT_TRUE(soon([&] { return heard.opened == 1; }));
    QTcpSocket second;
    second.connectToHost(kHere, source.port());
    ASSERT_TRUE(soon([&] { return heard.opened == 2; }));
    second.write("new");
    ASSERT_TRUE(soon([&] { return heard.bytes == "new"; }));
    second.close();
    EXPECT_TRUE(soon([&] { return heard.errors.size() == 2; }));
}

TEST(TcpListenSource, IsSilentOnceItIsClosedOrGone) {
    auto source = std::make_unique<TcpListenSource>(TcpListenAddress{"127.0.0.1", 0});
    SourceListener heard(*source);
    source->open();
    ASSERT_TRUE(soon([&] { return !heard.errors.empty(); })) << "nobody has connected yet";
    QTcpSocket robot;
    robot.connectToHost(kHere, source->port());
    ASSERT_TRUE(soon([&] { return heard.opened == 1; }));
    source->close();
    EXPECT_FALSE(soon([&] { return heard.errors.size() > 1; }, 300));

    source->open();
    ASSERT_TRUE(soon([&] { return heard.errors.size() == 2; }));
    QTcpSocket again;
    again.connectToHost(kHere, source->port());
    ASSERT_TRUE(soon([&] { return heard.opened == 2; }));
    source.reset();
    EXPECT_EQ(heard.errors.size(), 2U);
    EXPECT_TRUE(soon([&] { return again.state() == QTcpSocket::UnconnectedState; }));
}

TEST(TcpListenSource, SaysThatAnotherProgramListensThereAsLongAsItDoes) {
    auto other = std::make_unique<QTcpServer>();
    ASSERT_TRUE(other->listen(kHere));
    TcpListenSource source(TcpListenAddress{"127.0.0.1", other->serverPort()});
    SourceListener heard(source);
    source.open();
    ASSERT_EQ(heard.errors.size(), 1U);
    EXPECT_EQ(heard.errors[0].code, ErrorCode::kAddressInUse);
    other.reset();
    ASSERT_TRUE(soon([&] { return heard.errors.size() == 2; }, 2000));
    EXPECT_EQ(heard.errors[1].code, ErrorCode::kPeerMissing) << "now it waits for the robot";
}

TEST(UdpSource, FindsARobotByItsName) {
    QUdpSocket robot;
    robot.bind(kHere);
    UdpSource source(UdpAddress{"localhost", robot.localPort()});
    SourceListener heard(source);
    source.open();
    ASSERT_TRUE(soon([&] { return heard.opened == 1; }));
    source.write("hello");
    ASSERT_TRUE(soon([&] { return robot.hasPendingDatagrams(); }));
    const QNetworkDatagram hello = robot.receiveDatagram();
    robot.writeDatagram("I am here", hello.senderAddress(),
                        static_cast<std::uint16_t>(hello.senderPort()));
    EXPECT_TRUE(soon([&] { return heard.bytes == "I am here"; }));
}

TEST(UdpSource, SaysThatItDoesNotKnowAName) {
    UdpSource source(UdpAddress{"no-such-robot.invalid", 9});
    SourceListener heard(source);
    source.open();
    ASSERT_TRUE(soon([&] { return heard.errors.size() == 1; }));
    EXPECT_EQ(heard.errors[0].code, ErrorCode::kPeerMissing);
    EXPECT_EQ(heard.opened, 0);
}

TEST(UdpSource, HearsOneSenderAndAnswersIt) {
    UdpSource source(UdpListenAddress{"127.0.0.1", 0});
    SourceListener heard(source);
    source.open();
    ASSERT_EQ(heard.opened, 1);
    QUdpSocket robot;
    robot.bind(kHere);
    QUdpSocket stranger;
    robot.writeDatagram("one", kHere, source.port());
    ASSERT_TRUE(soon([&] { return heard.bytes == "one"; }));
    stranger.writeDatagram("x", kHere, source.port());
    robot.writeDatagram("two", kHere, source.port());
    ASSERT_TRUE(soon([&] { return heard.bytes == "onetwo"; })) << heard.bytes.toStdString();
    source.write("answer");
    EXPECT_TRUE(soon([&] { return robot.hasPendingDatagrams(); }));
    // The robot was restarted and has another port now.
    QTest::qWait(1100);
    stranger.writeDatagram("three", kHere, source.port());
    EXPECT_TRUE(soon([&] { return heard.bytes.endsWith("three"); }));
}

TEST(UdpSource, SpeaksFirstToARobotThatCannotKnowOfIt) {
    QUdpSocket robot;
    robot.bind(kHere);
    UdpSource source(UdpAddress{"127.0.0.1", robot.localPort()});
    SourceListener heard(source);
    source.open();
    EXPECT_TRUE(source.speaksFirst());
    source.write("who is there");
    ASSERT_TRUE(soon([&] { return robot.hasPendingDatagrams(); }));
    robot.receiveDatagram();
    robot.writeDatagram("I", kHere, source.port());
    EXPECT_TRUE(soon([&] { return heard.bytes == "I"; }));
}

TEST(UdpSource, SaysThatAnotherProgramListensThere) {
    QUdpSocket other;
    ASSERT_TRUE(other.bind(kHere, 0, QUdpSocket::DontShareAddress));
    UdpSource source(UdpListenAddress{"127.0.0.1", other.localPort()});
    SourceListener heard(source);
    source.open();
    ASSERT_EQ(heard.errors.size(), 1U);
    EXPECT_EQ(heard.errors[0].code, ErrorCode::kAddressInUse);
    other.close();
    EXPECT_TRUE(soon([&] { return heard.opened == 1; }, 2000));
}

class SerialSourceOnPty : public ::testing::Test {
  protected:
    QString path(const char* name) const { return folder_.filePath(QLatin1String(name)); }
    QTemporaryDir folder_;
};

TEST_F(SerialSourceOnPty, AnAdapterIsFoundAgainUnderAnotherName) {
    std::vector<SerialPortEntry> plugged{{path("ttyUSB0"), "adapter", "A50285BI"}};
    auto robot = std::make_unique<TalkingRobot>(path("ttyUSB0"), 60.0, ReplayScript{});
    SerialSource source({path("ttyUSB0")}, [&] { return plugged; });
    SourceListener heard(source);
    source.open();
    ASSERT_TRUE(soon([&] { return heard.bytes.size() > 100; }));
    robot.reset();
    ASSERT_TRUE(soon([&] { return heard.errors.size() == 1; }));
    // Another adapter has got the old name.
    const TalkingRobot other(path("ttyUSB0"), 60.0, ReplayScript{});
    plugged = {{path("ttyUSB0"), "another", "B1"}};
    QTest::qWait(600);
    EXPECT_EQ(heard.opened, 1) << "that is not ours";
    plugged.push_back({path("ttyUSB1"), "adapter", "A50285BI"});
    robot = std::make_unique<TalkingRobot>(path("ttyUSB1"), 60.0, ReplayScript{});
    QElapsedTimer timer;
    timer.start();
    ASSERT_TRUE(soon([&] { return heard.opened == 2; }));
    EXPECT_LT(timer.elapsed(), 2000);
    EXPECT_EQ(std::get<SerialAddress>(source.address()).device, path("ttyUSB1"));
}

TEST_F(SerialSourceOnPty, TwoProgramsOnOnePortAreKeptApart) {
    const TalkingRobot robot(path("ttyUSB0"), 60.0, ReplayScript{});
    SerialSource first({path("ttyUSB0")});
    SourceListener heard(first);
    first.open();
    ASSERT_TRUE(soon([&] { return heard.opened == 1; }));
    SerialSource second({path("ttyUSB0")});
    SourceListener too_late(second);
    second.open();
    ASSERT_EQ(too_late.errors.size(), 1U);
    EXPECT_EQ(too_late.errors[0].code, ErrorCode::kPortBusy);
    EXPECT_EQ(too_late.errors[0].detail, "this program has it open already");
    first.close();
    EXPECT_TRUE(soon([&] { return too_late.opened == 1; }, 2000));
}

TEST_F(SerialSourceOnPty, WhatIsNoPortIsCalledSo) {
    for (const QString& device : {QStringLiteral("/dev/null"), path(".")}) {
        SerialSource source({device});
        SourceListener heard(source);
        source.open();
        ASSERT_EQ(heard.errors.size(), 1U);
        EXPECT_EQ(heard.errors[0].code, ErrorCode::kNotAPort);
    }
}

TEST_F(SerialSourceOnPty, AProgramThatHoldsThePortIsNamedWithTheLineThatEndsIt) {
    const TalkingRobot robot(path("ttyUSB0"), 60.0, ReplayScript{});
    QProcess holder;
    holder.start(kHedrTool, {"record", "--port", path("ttyUSB0"), "--out", path("m.hedr")});
    ASSERT_TRUE(soon([&] { return holder.readAllStandardError().contains("Recording"); }, 20000));
    SerialSource source({path("ttyUSB0")});
    SourceListener heard(source);
    source.open();
    ASSERT_EQ(heard.errors.size(), 1U);
    EXPECT_EQ(heard.errors[0].code, ErrorCode::kPortBusy);
    const std::string pid = std::to_string(holder.processId());
    EXPECT_EQ(heard.errors[0].detail, "hedr (pid " + pid + ") has it open; to end it: kill " + pid);
    EXPECT_TRUE(errorText(heard.errors[0]).contains("kill"));
    holder.terminate();
    ASSERT_TRUE(holder.waitForFinished(5000));
    EXPECT_TRUE(soon([&] { return heard.opened == 1; }, 2000)) << "once it has let go";
}

}  // namespace
}  // namespace hedr
