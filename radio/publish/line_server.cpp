#include "radio/publish/line_server.h"

#include <QHostAddress>
#include <QVariant>
#include <algorithm>
#include <utility>

#include "radio/source/dead_peer.h"

namespace hedr {

namespace {

constexpr int kRetry_ms = 1000;
constexpr int kSendBufferBytes = 65536;  // the kernel's share, else megabytes of what is long past
constexpr qint64 kReadBufferBytes = 4096;

}  // namespace

LineServer::LineServer(QString host, std::uint16_t port, std::string name, QObject* parent)
    : QObject(parent),
      host_(std::move(host)),
      wanted_port_(port),
      name_(std::move(name)),
      server_(this),
      retry_(this) {
    retry_.setInterval(kRetry_ms);
    connect(&retry_, &QTimer::timeout, this, &LineServer::tryToListen);
    connect(&server_, &QTcpServer::newConnection, this, &LineServer::takeClients);
    tryToListen();
}

// They say goodbye while they are destroyed, when nothing of this is left to hear it.
LineServer::~LineServer() {
    for (QTcpSocket* const client : clients_) client->disconnect(this);
}

void LineServer::tryToListen() {
    const bool listens = server_.listen(QHostAddress(host_), wanted_port_);
    listens ? retry_.stop() : retry_.start();
    const bool failed_before = error_.has_value();
    error_.reset();
    if (!listens) {
        error_ = Error{ErrorCode::kAddressInUse, name_, server_.errorString().toStdString()};
    }
    if (failed_before != error_.has_value()) emit stateChanged();
}

void LineServer::takeClients() {
    while (QTcpSocket* const client = server_.nextPendingConnection()) take(client);
    emit stateChanged();
}

void LineServer::take(QTcpSocket* client) {
    if (clients_.size() >= kMostClients) {
        ++turned_away_;
        client->abort();
        client->deleteLater();
        return;
    }
    watchForDeath(*client);
    client->setSocketOption(QTcpSocket::SendBufferSizeSocketOption, QVariant(kSendBufferBytes));
    client->setReadBufferSize(kReadBufferBytes);
    clients_.push_back(client);
    connect(client, &QTcpSocket::readyRead, this, [client] { client->readAll(); });
    connect(client, &QTcpSocket::disconnected, this, [this, client] { drop(client); });
}

void LineServer::drop(QTcpSocket* client) {
    std::erase(clients_, client);
    client->disconnect(this);
    client->abort();
    client->deleteLater();
    emit stateChanged();
}

void LineServer::send(const QByteArray& lines) {
    const std::vector<QTcpSocket*> clients = clients_;  // who is dropped leaves the list
    for (QTcpSocket* const client : clients) {
        if (client->bytesToWrite() + lines.size() > kMostWaitingBytes) {
            ++turned_away_;
            drop(client);
        } else {
            client->write(lines);
        }
    }
}

}  // namespace hedr
