#include "radio/source/serial_source.h"

#include <unistd.h>

#include <QFileInfo>
#include <QSerialPort>
#include <utility>

namespace hedr {

namespace {

constexpr int kRetry_ms = 250;

// Told apart before QSerialPort tries, which calls a port held by another program and a port
// without permission by the same name.
std::optional<Error> obstacle(const QString& device) {
    const std::string name = device.toStdString();
    if (!QFileInfo::exists(device)) return Error{ErrorCode::kPortMissing, name, {}};
    if (::access(name.c_str(), R_OK | W_OK) != 0) {
        return Error{ErrorCode::kPortPermission, name, {}};
    }
    return std::nullopt;
}

ErrorCode codeOf(QSerialPort::SerialPortError error) {
    switch (error) {
        case QSerialPort::DeviceNotFoundError:
            return ErrorCode::kPortMissing;
        case QSerialPort::PermissionError:
            return ErrorCode::kPortBusy;
        case QSerialPort::OpenError:
            return ErrorCode::kPortBusy;
        default:
            return ErrorCode::kPortFailed;
    }
}

// "ttyUSB0" is a device, "robot" may be a link in the current folder.
QString fullName(const QString& device) {
    if (device.startsWith(QLatin1Char('/'))) return device;
    return QFileInfo::exists(device) ? QFileInfo(device).absoluteFilePath()
                                     : QStringLiteral("/dev/") + device;
}

}  // namespace

SerialAddress parseSerialAddress(const QString& text) {
    const qsizetype colon = text.lastIndexOf(QLatin1Char(':'));
    bool is_number = false;
    const int baud = colon > 0 ? text.mid(colon + 1).toInt(&is_number) : 0;
    if (!is_number || baud <= 0) return {.device = text};
    return {.device = text.left(colon), .baud = baud};
}

SerialSource::SerialSource(QObject* parent)
    : QObject(parent), port_(new QSerialPort(this)), retry_(this) {
    retry_.setInterval(kRetry_ms);
    connect(&retry_, &QTimer::timeout, this, &SerialSource::tryToOpen);
    connect(port_, &QSerialPort::readyRead, this, &SerialSource::readAll);
    // Queued: a port that was hung up reports errors without end unless it is closed, and it must
    // not be closed from within its own signal.
    connect(port_, &QSerialPort::errorOccurred, this, &SerialSource::handleError,
            Qt::QueuedConnection);
}

void SerialSource::open(const SerialAddress& address) {
    close();
    address_ = {fullName(address.device), address.baud};
    reported_.reset();
    retry_.start();
    tryToOpen();
}

void SerialSource::close() {
    retry_.stop();
    if (port_->isOpen()) port_->close();
}

void SerialSource::write(const QByteArray& bytes) {
    if (port_->isOpen()) port_->write(bytes);
}

void SerialSource::tryToOpen() {
    if (port_->isOpen()) return;
    const std::optional<Error> stop = obstacle(address_.device);
    port_->setPortName(address_.device);
    port_->setBaudRate(address_.baud);
    if (!stop && port_->open(QIODevice::ReadWrite)) {
        reported_.reset();
        emit opened();
        return;
    }
    reportOnce(stop.value_or(Error{codeOf(port_->error()), address_.device.toStdString(),
                                   port_->errorString().toStdString()}));
}

void SerialSource::reportOnce(const Error& error) {
    if (std::exchange(reported_, error.code) != error.code) emit failed(error);
}

void SerialSource::readAll() { emit bytesReceived(port_->readAll()); }

void SerialSource::handleError() {
    const QSerialPort::SerialPortError error = port_->error();
    const bool harmless = error == QSerialPort::NoError || error == QSerialPort::TimeoutError;
    if (harmless || !port_->isOpen()) return;
    const QString reason = port_->errorString();
    if (port_->bytesAvailable() > 0) readAll();
    port_->close();
    reportOnce({ErrorCode::kPortMissing, address_.device.toStdString(), reason.toStdString()});
}

}  // namespace hedr
