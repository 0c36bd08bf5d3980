#include "radio/publish/line_server.h"

#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <QHostAddress>
#include <QTest>
#include <memory>

#include "core/file_descriptor.h"

namespace hedr {
namespace {

const QString kHere = QStringLiteral("127.0.0.1");

// A client whose program does not read what arrives.
class DeafClient {
  public:
    explicit DeafClient(std::uint16_t port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
        const int bytes = 4096;
        ::setsockopt(socket_.get(), SOL_SOCKET, SO_RCVBUF, &bytes, sizeof bytes);
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(port);
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        connected_ = ::connect(socket_.get(), reinterpret_cast<const sockaddr*>(&address),
                               sizeof address) == 0;
    }
    bool connected() const { return connected_; }

  private:
    FileDescriptor socket_;
    bool connected_ = false;
};

std::unique_ptr<QTcpSocket> clientOf(const LineServer& server) {
    auto client = std::make_unique<QTcpSocket>();
    client->connectToHost(kHere, server.port());
    return client;
}

TEST(LineServer, TellsEverybodyWhoConnects) {
    LineServer server(kHere, 0, "json=tcp://:0");
    ASSERT_NE(server.port(), 0);
    const auto a = clientOf(server);
    const auto b = clientOf(server);
    ASSERT_TRUE(QTest::qWaitFor([&] { return server.clients() == 2; }));
    server.send("one\n");
    server.send("two\n");
    for (QTcpSocket* client : {a.get(), b.get()}) {
        ASSERT_TRUE(QTest::qWaitFor([&] { return client->bytesAvailable() == 8; }));
        EXPECT_EQ(client->readAll(), "one\ntwo\n");
    }
}

TEST(LineServer, ForgetsWhoLeaves) {
    LineServer server(kHere, 0, "json=tcp://:0");
    auto client = clientOf(server);
    ASSERT_TRUE(QTest::qWaitFor([&] { return server.clients() == 1; }));
    client.reset();
    ASSERT_TRUE(QTest::qWaitFor([&] { return server.clients() == 0; }));
    server.send("to nobody\n");
    EXPECT_EQ(server.turnedAway(), 0U);
}

TEST(LineServer, DropsWhoDoesNotReadAndServesTheOthers) {
    LineServer server(kHere, 0, "json=tcp://:0");
    const DeafClient deaf(server.port());
    ASSERT_TRUE(deaf.connected());
    const auto good = clientOf(server);
    ASSERT_TRUE(QTest::qWaitFor([&] { return server.clients() == 2; }));
    const QByteArray lines(10'000, '\n');
    qint64 sent = 0;
    qint64 read = 0;
    for (int i = 0; i < 1000 && server.clients() == 2; ++i) {
        server.send(lines);
        sent += lines.size();
        ASSERT_TRUE(QTest::qWaitFor([&] {
            read += good->readAll().size();
            return read == sent;
        })) << "a client that reads has waited for one that does not";
    }
    EXPECT_EQ(server.clients(), 1U);
    EXPECT_EQ(server.turnedAway(), 1U);
    EXPECT_LT(sent, 1'000'000) << "what a client that does not read costs";
    EXPECT_EQ(good->state(), QTcpSocket::ConnectedState);
}

TEST(LineServer, TurnsAwayWhoIsTooMany) {
    LineServer server(kHere, 0, "json=tcp://:0");
    std::vector<std::unique_ptr<QTcpSocket>> clients;
    for (std::size_t i = 0; i < LineServer::kMostClients + 1; ++i) {
        clients.push_back(clientOf(server));
    }
    ASSERT_TRUE(QTest::qWaitFor([&] { return server.turnedAway() == 1; }));
    EXPECT_EQ(server.clients(), LineServer::kMostClients);
}

TEST(LineServer, TakesNothingFromItsClients) {
    LineServer server(kHere, 0, "json=tcp://:0");
    const auto client = clientOf(server);
    ASSERT_TRUE(QTest::qWaitFor([&] { return server.clients() == 1; }));
    client->write(QByteArray(1'000'000, 'x'));
    ASSERT_TRUE(QTest::qWaitFor([&] { return client->bytesToWrite() == 0; }));
    server.send("on\n");
    ASSERT_TRUE(QTest::qWaitFor([&] { return client->bytesAvailable() == 3; }));
}

TEST(LineServer, SaysThatAPortIsTakenAndTakesItWhenItIsFree) {
    auto other = std::make_unique<LineServer>(kHere, 0, "first");
    LineServer server(kHere, other->port(), "nmea=tcp://:2000");
    ASSERT_TRUE(server.error());
    EXPECT_EQ(server.error()->code, ErrorCode::kAddressInUse);
    EXPECT_EQ(server.error()->subject, "nmea=tcp://:2000");
    EXPECT_EQ(server.port(), 0);
    other.reset();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !server.error(); }));
    EXPECT_NE(server.port(), 0);
}

TEST(LineServer, EndsWhileClientsAreConnected) {
    auto server = std::make_unique<LineServer>(kHere, 0, "json=tcp://:0");
    const auto client = clientOf(*server);
    ASSERT_TRUE(QTest::qWaitFor([&] { return server->clients() == 1; }));
    server.reset();
    ASSERT_TRUE(QTest::qWaitFor([&] { return client->state() == QTcpSocket::UnconnectedState; }));
}

}  // namespace
}  // namespace hedr
