#include "radio/source/serial_ports.h"

#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>
#include <QSerialPortInfo>

namespace hedr {

namespace {

// udev names a port after maker, product, serial number and, of an adapter with several, place
// ("by-id"), and after the socket ("by-path").
QString udevName(const QString& kind, const QString& device) {
    for (const QFileInfo& link : QDir(QStringLiteral("/dev/serial/") + kind).entryInfoList()) {
        if (link.canonicalFilePath() == device) return link.fileName();
    }
    return {};
}

QString identityOf(const QSerialPortInfo& port) {
    if (!port.hasProductIdentifier()) return {};
    QString by_id = udevName(QStringLiteral("by-id"), port.systemLocation());
    if (by_id.isEmpty()) {
        by_id = QStringLiteral("%1:%2:%3")
                    .arg(port.vendorIdentifier(), 4, 16, QLatin1Char('0'))
                    .arg(port.productIdentifier(), 4, 16, QLatin1Char('0'))
                    .arg(port.serialNumber());
    }
    return adapterIdentity(by_id, udevName(QStringLiteral("by-path"), port.systemLocation()),
                           port.serialNumber());
}

QString nameOf(const QSerialPortInfo& port) {
    const QStringList names{port.manufacturer(), port.description(), port.serialNumber()};
    return names.filter(QRegularExpression(QStringLiteral("."))).join(QLatin1Char(' '));
}

}  // namespace

QString adapterIdentity(const QString& by_id, const QString& by_path,
                        const QString& serial_number) {
    if (!serial_number.isEmpty() || by_path.isEmpty()) return by_id;
    return by_id + QLatin1Char('@') + by_path;
}

std::vector<SerialPortEntry> listSerialPorts() {
    std::vector<SerialPortEntry> usb;
    std::vector<SerialPortEntry> others;
    for (const QSerialPortInfo& port : QSerialPortInfo::availablePorts()) {
        (port.hasProductIdentifier() ? usb : others)
            .push_back({port.systemLocation(), nameOf(port), identityOf(port)});
    }
    usb.insert(usb.end(), others.begin(), others.end());
    return usb;
}

}  // namespace hedr
