#include "radio/source/serial_source.h"

#include <fcntl.h>
#include <unistd.h>

#include <QFileInfo>
#include <QSerialPort>
#include <algorithm>
#include <utility>

#include "core/file_descriptor.h"
#include "radio/source/port_holder.h"

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

// Asked only of what could not be opened as one: to open a board's port restarts the board.
bool isAnythingElse(const QString& device) {
    const FileDescriptor file(::open(device.toLocal8Bit(), O_RDONLY | O_NOCTTY | O_NONBLOCK));
    return file && ::isatty(file.get()) == 0;
}

ErrorCode codeOf(QSerialPort::SerialPortError error, const QString& device) {
    switch (error) {
        case QSerialPort::DeviceNotFoundError:
            return ErrorCode::kPortMissing;
        case QSerialPort::PermissionError:
            return ErrorCode::kPortBusy;
        case QSerialPort::OpenError:
            return ErrorCode::kPortBusy;
        default:
            return isAnythingElse(device) ? ErrorCode::kNotAPort : ErrorCode::kPortFailed;
    }
}

Error withHolder(Error error) {
    const std::string holder = describe(findPortHolders(error.subject), error.subject);
    if (!holder.empty()) error.detail = holder;
    return error;
}

// "ttyUSB0" is a device, "robot" may be a link in the current folder.
QString fullName(const QString& device) {
    if (device.startsWith(QLatin1Char('/'))) return device;
    return QFileInfo::exists(device) ? QFileInfo(device).absoluteFilePath()
                                     : QStringLiteral("/dev/") + device;
}

}  // namespace

SerialSource::SerialSource(const SerialAddress& address, PortLister list_ports, QObject* parent)
    : ByteSource(parent),
      port_(new QSerialPort(this)),
      retry_(this),
      address_{fullName(address.device), address.baud},
      list_ports_(std::move(list_ports)),
      search_(address.baud == SerialAddress::kFindOut ? kUsualBauds.front() : address.baud) {
    if (address.baud != SerialAddress::kFindOut) search_.settle();
    retry_.setInterval(kRetry_ms);
    connect(&retry_, &QTimer::timeout, this, &SerialSource::tryToOpen);
    connect(port_, &QSerialPort::readyRead, this, &SerialSource::readAll);
    // Queued: a port that was hung up reports errors without end unless it is closed, and it must
    // not be closed from within its own signal.
    connect(port_, &QSerialPort::errorOccurred, this, &SerialSource::handleError,
            Qt::QueuedConnection);
}

void SerialSource::open() {
    close();
    reported_.reset();
    board_restarted_ = false;
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

LinkAddress SerialSource::address() const {
    return SerialAddress{address_.device, search_.settled() ? search_.baud() : address_.baud};
}

void SerialSource::tryToOpen() {
    if (port_->isOpen()) return;
    const QString device = deviceNow();
    if (device.isEmpty())
        return reportOnce({ErrorCode::kPortMissing, address_.device.toStdString(), {}});
    const std::optional<Error> stop = obstacle(device);
    port_->setPortName(device);
    port_->setBaudRate(search_.baud());
    if (!stop && port_->open(QIODevice::ReadWrite)) {
        address_.device = device;
        reported_.reset();
        rememberIdentity();
        emit opened();
        return;
    }
    reportOnce(stop.value_or(Error{codeOf(port_->error(), device), device.toStdString(),
                                   port_->errorString().toStdString()}));
}

// Where the adapter that was opened is plugged in now; empty where a port has its name that is
// not it.
QString SerialSource::deviceNow() const {
    if (identity_.isEmpty()) return address_.device;
    const std::vector<SerialPortEntry> ports = list_ports_();
    for (const SerialPortEntry& port : ports) {
        if (port.identity == identity_) return port.device;
    }
    const bool taken = std::ranges::any_of(
        ports, [this](const SerialPortEntry& port) { return port.device == address_.device; });
    return taken ? QString() : address_.device;
}

void SerialSource::rememberIdentity() {
    const QString real = QFileInfo(address_.device).canonicalFilePath();
    for (const SerialPortEntry& entry : list_ports_()) {
        if (QFileInfo(entry.device).canonicalFilePath() == real) identity_ = entry.identity;
    }
}

void SerialSource::reportOnce(const Error& error) {
    if (std::exchange(reported_, error.code) == error.code) return;
    emit failed(error.code == ErrorCode::kPortBusy ? withHolder(error) : error);
}

void SerialSource::readAll() {
    const QByteArray bytes = port_->readAll();
    if (bytes.isEmpty()) return;
    emit bytesReceived(bytes);
    if (const auto baud = search_.noteBytes(BaudSearch::Clock::now())) port_->setBaudRate(*baud);
}

// The rate is right. Queued, for this comes out of the port's own signal.
void SerialSource::noteNamesMissing() {
    search_.settle();
    if (std::exchange(board_restarted_, true)) return;
    QMetaObject::invokeMethod(this, &SerialSource::restartBoard, Qt::QueuedConnection);
}

// Arduinos restart when their port is opened. The next try to open is a moment away, long enough
// for the line to fall.
void SerialSource::restartBoard() {
    if (port_->isOpen()) port_->close();
}

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
