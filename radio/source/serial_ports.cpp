#include "radio/source/serial_ports.h"

#include <QRegularExpression>
#include <QSerialPortInfo>

namespace hedr {

std::vector<SerialPortEntry> listSerialPorts() {
    std::vector<SerialPortEntry> usb;
    std::vector<SerialPortEntry> others;
    for (const QSerialPortInfo& port : QSerialPortInfo::availablePorts()) {
        const QStringList names{port.manufacturer(), port.description(), port.serialNumber()};
        const QString description = QStringList(names).filter(QRegularExpression(".")).join(' ');
        (port.hasProductIdentifier() ? usb : others)
            .push_back({port.systemLocation(), description});
    }
    usb.insert(usb.end(), others.begin(), others.end());
    return usb;
}

}  // namespace hedr
