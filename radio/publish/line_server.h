#pragma once

#include <QByteArray>
#include <QObject>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTimer>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"

namespace hedr {

// Gives the same lines to everybody who connects, and takes nothing from them. Never blocks; who
// reads too slowly is dropped, and may connect again. Where it cannot listen it tries again.
class LineServer : public QObject {
    Q_OBJECT

  public:
    static constexpr std::size_t kMostClients = 16;     // further ones are turned away
    static constexpr qint64 kMostWaitingBytes = 65536;  // of one client: a good minute of JSON

    // `name` is told in errors.
    LineServer(QString host, std::uint16_t port, std::string name, QObject* parent = nullptr);
    ~LineServer() override;

    void send(const QByteArray& lines);
    std::size_t clients() const { return clients_.size(); }
    std::uint16_t port() const { return server_.serverPort(); }   // 0: it does not listen
    const std::optional<Error>& error() const { return error_; }  // kAddressInUse
    std::uint64_t turnedAway() const { return turned_away_; }     // too slow, or too many

  signals:
    void stateChanged();

  private:
    void tryToListen();
    void takeClients();
    void take(QTcpSocket* client);
    void drop(QTcpSocket* client);

    QString host_;
    std::uint16_t wanted_port_;
    std::string name_;
    QTcpServer server_;
    QTimer retry_;
    std::vector<QTcpSocket*> clients_;  // the server's children
    std::optional<Error> error_{};
    std::uint64_t turned_away_ = 0;
};

}  // namespace hedr
