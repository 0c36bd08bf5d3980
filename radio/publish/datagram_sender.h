#pragma once

#include <QByteArray>
#include <QHostAddress>
#include <QObject>
#include <QUdpSocket>
#include <cstdint>
#include <optional>
#include <string>

#include "core/result.h"

class QHostInfo;

namespace hedr {

// Sends datagrams to one address, also a group's (which stays in the local network). Never blocks:
// a name is looked up beside, and again as long as it is not found.
class DatagramSender : public QObject {
    Q_OBJECT

  public:
    // `name` is told in errors.
    DatagramSender(QString host, std::uint16_t port, std::string name, QObject* parent = nullptr);

    // Given up where it cannot go out now: the next one will say something newer.
    void send(const QByteArray& datagram);
    const std::optional<Error>& error() const { return error_; }  // kUnreachable

  signals:
    void stateChanged();

  private:
    void lookUp();
    void handleFound(const QHostInfo& found);
    void note(std::optional<Error> error);

    QString host_;
    std::uint16_t port_;
    std::string name_;
    QHostAddress address_;
    bool looking_up_ = false;
    QUdpSocket socket_;
    std::optional<Error> error_{};
};

}  // namespace hedr
