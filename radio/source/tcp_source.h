#pragma once

#include <QTcpServer>
#include <QTcpSocket>
#include <QTimer>
#include <optional>

#include "radio/source/byte_source.h"

namespace hedr {

// A robot that listens for us on the network.
class TcpSource : public ByteSource {
    Q_OBJECT

  public:
    explicit TcpSource(const TcpAddress& address, QObject* parent = nullptr);

    void open() override;
    void close() override;
    void write(const QByteArray& bytes) override;
    LinkAddress address() const override { return address_; }

  private:
    void tryToConnect();
    void handleConnected();
    void handleError();

    TcpAddress address_;
    QTcpSocket socket_;
    QTimer retry_;
    QTimer patience_;
    bool reported_ = false;  // this outage
};

// A robot that connects to us; one at a time. The newest connection is the robot's, for one that
// was restarted comes back while the old connection still seems to stand.
class TcpListenSource : public ByteSource {
    Q_OBJECT

  public:
    explicit TcpListenSource(const TcpListenAddress& address, QObject* parent = nullptr);
    ~TcpListenSource() override { close(); }

    void open() override;
    void close() override;
    void write(const QByteArray& bytes) override;
    LinkAddress address() const override { return address_; }
    std::uint16_t port() const { return server_.serverPort(); }

  private:
    void tryToListen();
    void takeNewest();
    void forget(QTcpSocket* peer);
    void dropPeer();

    TcpListenAddress address_;
    QTcpServer server_;
    QTcpSocket* peer_ = nullptr;
    QTimer retry_;
    std::optional<ErrorCode> reported_{};  // another reason is reported again
};

}  // namespace hedr
