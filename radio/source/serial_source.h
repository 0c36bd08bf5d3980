#pragma once

#include <QString>
#include <QTimer>
#include <optional>

#include "radio/source/baud_search.h"
#include "radio/source/byte_source.h"
#include "radio/source/serial_ports.h"

class QSerialPort;

namespace hedr {

// A serial port. An adapter that is plugged in again is found also under another port name.
class SerialSource : public ByteSource {
    Q_OBJECT

  public:
    explicit SerialSource(const SerialAddress& address, PortLister list_ports = listSerialPorts,
                          QObject* parent = nullptr);

    void open() override;
    void close() override;
    void write(const QByteArray& bytes) override;
    void noteUnderstood() override { search_.settle(); }
    void noteNamesMissing() override;
    LinkAddress address() const override;

  private:
    void tryToOpen();
    QString deviceNow() const;
    void rememberIdentity();
    void readAll();
    void handleError();
    void restartBoard();
    void reportOnce(const Error& error);

    QSerialPort* port_;
    QTimer retry_;
    SerialAddress address_;
    PortLister list_ports_;
    QString identity_{};  // of the adapter that was opened
    BaudSearch search_;
    bool board_restarted_ = false;         // since open()
    std::optional<ErrorCode> reported_{};  // of this outage; another reason is reported again
};

}  // namespace hedr
