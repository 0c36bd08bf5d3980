#pragma once

#include <QByteArray>
#include <QObject>
#include <QString>
#include <QTimer>
#include <optional>

#include "core/result.h"

class QSerialPort;

namespace hedr {

struct SerialAddress {
    QString device;
    int baud = 57600;
};

// "/dev/ttyUSB0" or "/dev/ttyUSB0:115200".
SerialAddress parseSerialAddress(const QString& text);

// Reads a serial port, and when the port goes away, opens it again as soon as it is back.
class SerialSource : public QObject {
    Q_OBJECT

  public:
    explicit SerialSource(QObject* parent = nullptr);

    void open(const SerialAddress& address);
    void close();
    void write(const QByteArray& bytes);

  signals:
    void opened();
    void bytesReceived(const QByteArray& bytes);
    // The port could not be opened or went away; tried again until close().
    void failed(const hedr::Error& error);

  private:
    void tryToOpen();
    void readAll();
    void handleError();
    void reportOnce(const Error& error);

    QSerialPort* port_;
    QTimer retry_;
    SerialAddress address_;
    std::optional<ErrorCode> reported_{};  // of this outage; another reason is reported again
};

}  // namespace hedr

Q_DECLARE_METATYPE(hedr::Error)
