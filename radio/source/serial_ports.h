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

// What a USB adapter is known by: udev's name, which holds the serial number. Adapters without one
// look all the same, so that the socket they are plugged into belongs to it.
QString adapterIdentity(const QString& by_id, const QString& by_path, const QString& serial_number);

// The serial ports of this computer, USB adapters first.
std::vector<SerialPortEntry> listSerialPorts();

using PortLister = std::function<std::vector<SerialPortEntry>()>;

}  // namespace hedr
