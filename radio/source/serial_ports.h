#pragma once

#include <QString>
#include <vector>

namespace hedr {

struct SerialPortEntry {
    QString device;       // "/dev/ttyUSB0"
    QString description;  // USB product and serial number, empty where unknown
};

// The serial ports of this computer, USB adapters first.
std::vector<SerialPortEntry> listSerialPorts();

}  // namespace hedr
