#pragma once

#include <QString>
#include <functional>
#include <vector>

namespace hedr {

struct SerialPortEntry {
    QString device;    // "/dev/ttyUSB0"
    QString name;      // as its maker calls it, with its serial number; empty where unknown
    QString identity;  // the same under every port name; empty where it has none
};

// The serial ports of this computer, USB adapters first.
std::vector<SerialPortEntry> listSerialPorts();

using PortLister = std::function<std::vector<SerialPortEntry>()>;

}  // namespace hedr
