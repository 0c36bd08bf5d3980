#pragma once

#include <QMetaType>
#include <QString>
#include <cstdint>
#include <variant>

#include "core/result.h"

namespace hedr {

// Where a robot is reached.

struct SerialAddress {
    static constexpr int kFindOut = 0;  // the usual rates are tried until frames come
    QString device;
    int baud = kFindOut;
    friend bool operator==(const SerialAddress&, const SerialAddress&) = default;
};

// The robot listens there.
struct TcpAddress {
    QString host;
    std::uint16_t port = 0;
    friend bool operator==(const TcpAddress&, const TcpAddress&) = default;
};

// We listen and the robot connects. `host` is one of our own addresses; empty: any.
struct TcpListenAddress {
    QString host;
    std::uint16_t port = 0;
    friend bool operator==(const TcpListenAddress&, const TcpListenAddress&) = default;
};

// We speak first, from a port of the system's choice.
struct UdpAddress {
    QString host;
    std::uint16_t port = 0;
    friend bool operator==(const UdpAddress&, const UdpAddress&) = default;
};

// We listen, and answer to whom we heard first. `host` as with TcpListenAddress.
struct UdpListenAddress {
    QString host;
    std::uint16_t port = 0;
    friend bool operator==(const UdpListenAddress&, const UdpListenAddress&) = default;
};

using LinkAddress =
    std::variant<SerialAddress, TcpAddress, TcpListenAddress, UdpAddress, UdpListenAddress>;

// "/dev/ttyUSB0", "ttyUSB0:115200", "tcp://HOST:PORT", "udp://HOST:PORT"; to listen
// "tcp://:PORT", "udp://:PORT", and on one own address only "udp://@127.0.0.1:PORT".
// Errors: kBadValue.
Result<LinkAddress> parseLinkAddress(const QString& text);

// As parseLinkAddress takes it.
QString toText(const LinkAddress& address);

}  // namespace hedr

Q_DECLARE_METATYPE(hedr::LinkAddress)
