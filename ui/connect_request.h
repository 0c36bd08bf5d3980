#pragma once

#include <QString>

namespace hedr {

// What the operator chose in the connect card, and what is proposed there the next time.
struct ConnectRequest {
    QString port{};      // "/dev/ttyUSB0", or an address such as tcp://host:port
    int baud = 0;        // 0: to be found out
    QString identity{};  // of the adapter, the same under every port name; empty: none is known
    QString vehicle_preset{};  // empty, with an empty file: as the robot says
    QString vehicle_file{};
    QString call_sign{};  // empty: as the robot calls itself
    friend bool operator==(const ConnectRequest&, const ConnectRequest&) = default;
};

}  // namespace hedr
