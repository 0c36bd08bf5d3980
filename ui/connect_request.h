#pragma once

#include <QString>

namespace hedr {

// What the operator chose in the connect card.
struct ConnectRequest {
    QString port;  // "/dev/ttyUSB0", or an address such as tcp://host:port
    int baud = 57600;
    QString vehicle_preset;  // empty, with an empty file: as the robot says
    QString vehicle_file;
    friend bool operator==(const ConnectRequest&, const ConnectRequest&) = default;
};

}  // namespace hedr
