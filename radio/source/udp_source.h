#pragma once

#include <QTimer>
#include <QUdpSocket>
#include <chrono>
#include <optional>

#include "radio/source/byte_source.h"

namespace hedr {

// A robot that sends datagrams: to a port where we listen, or to the one from which we spoke to it
// first. Only one sender is heard at a time: another one once the first has been silent.
class UdpSource : public ByteSource {
    Q_OBJECT

  public:
    explicit UdpSource(const UdpListenAddress& address, QObject* parent = nullptr);
    explicit UdpSource(const UdpAddress& address, QObject* parent = nullptr);

    void open() override;
    void close() override;
    void write(const QByteArray& bytes) override;
    LinkAddress address() const override { return address_; }
    bool speaksFirst() const override { return std::holds_alternative<UdpAddress>(address_); }
    std::uint16_t port() const { return socket_.localPort(); }

  private:
    using Clock = std::chrono::steady_clock;
    struct Peer {
        QHostAddress host;
        std::uint16_t port = 0;
        Clock::time_point heard{};
    };

    explicit UdpSource(LinkAddress address, QObject* parent);
    void lookUpPeer();
    void tryToBind();
    void readAll();
    bool isRobot(const QHostAddress& host, std::uint16_t port);

    LinkAddress address_;
    QUdpSocket socket_;
    QTimer retry_;
    std::optional<Peer> peer_{};
    bool looking_up_ = false;
    bool reported_ = false;
};

}  // namespace hedr
