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

// A mission, or a sensors.csv with a vehicle.toml beside it, played from its beginning.
struct RecordingAddress {
    QString file;        // a full path
    double speed = 1.0;  // times real time
    friend bool operator==(const RecordingAddress&, const RecordingAddress&) = default;
};

// A robot that drives through one of the scenarios (core/simulation/scenario.h).
struct SimulatorAddress {
    static constexpr std::uint64_t kUsualSeed = 7;
    QString scenario;
    std::uint64_t seed = kUsualSeed;
    double speed = 1.0;  // times real time
    friend bool operator==(const SimulatorAddress&, const SimulatorAddress&) = default;
};

using LinkAddress = std::variant<SerialAddress, TcpAddress, TcpListenAddress, UdpAddress,
                                 UdpListenAddress, RecordingAddress, SimulatorAddress>;

// "/dev/ttyUSB0", "ttyUSB0:115200", "tcp://HOST:PORT", "udp://HOST:PORT"; to listen
// "tcp://:PORT", "udp://:PORT", and on one own address only "udp://@127.0.0.1:PORT";
// "file:///FILE?speed=X" with % before two hexadecimal digits as in every such address;
// "sim://SCENARIO?seed=N&speed=X". What follows the question mark may be left out. Without "://"
// a name that ends in .hedr or .csv is a recording, unless it lies below /dev, and every other a
// serial port. Errors: kBadValue.
Result<LinkAddress> parseLinkAddress(const QString& text);

// As parseLinkAddress takes it.
QString toText(const LinkAddress& address);

}  // namespace hedr

Q_DECLARE_METATYPE(hedr::LinkAddress)
