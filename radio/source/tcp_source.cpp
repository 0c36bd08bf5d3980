#include "radio/source/tcp_source.h"

#include <utility>

#include "radio/source/dead_peer.h"

namespace hedr {

namespace {

constexpr int kRetry_ms = 250;
constexpr int kConnectPatience_ms = 1500;  // a host that drops packets answers nothing at all

}  // namespace

TcpSource::TcpSource(const TcpAddress& address, QObject* parent)
    : ByteSource(parent), address_(address), socket_(this), retry_(this), patience_(this) {
    retry_.setInterval(kRetry_ms);
    patience_.setSingleShot(true);
    patience_.setInterval(kConnectPatience_ms);
    connect(&retry_, &QTimer::timeout, this, &TcpSource::tryToConnect);
    connect(&patience_, &QTimer::timeout, this, &TcpSource::handleError);
    connect(&socket_, &QTcpSocket::connected, this, &TcpSource::handleConnected);
    connect(&socket_, &QTcpSocket::readyRead, this, [this] {
        const QByteArray bytes = socket_.readAll();
        if (!bytes.isEmpty()) emit bytesReceived(bytes);
    });
    connect(&socket_, &QTcpSocket::errorOccurred, this, &TcpSource::handleError);
}

void TcpSource::open() {
    close();
    reported_ = false;
    retry_.start();
    tryToConnect();
}

void TcpSource::close() {
    retry_.stop();
    patience_.stop();
    const QSignalBlocker quiet(socket_);
    socket_.abort();
}

void TcpSource::write(const QByteArray& bytes) {
    if (socket_.state() == QTcpSocket::ConnectedState) socket_.write(bytes);
}

void TcpSource::tryToConnect() {
    if (socket_.state() != QTcpSocket::UnconnectedState) return;
    patience_.start();
    socket_.connectToHost(address_.host, address_.port);
}

void TcpSource::handleConnected() {
    patience_.stop();
    reported_ = false;
    watchForDeath(socket_);
    emit opened();
}

void TcpSource::handleError() {
    const bool too_slow = !patience_.isActive() && socket_.state() != QTcpSocket::ConnectedState &&
                          socket_.state() != QTcpSocket::UnconnectedState;
    const QString reason = too_slow ? QStringLiteral("it does not answer") : socket_.errorString();
    patience_.stop();
    const QSignalBlocker quiet(socket_);
    socket_.abort();
    if (std::exchange(reported_, true)) return;
    emit failed({ErrorCode::kPeerMissing, toText(address_).toStdString(), reason.toStdString()});
}

TcpListenSource::TcpListenSource(const TcpListenAddress& address, QObject* parent)
    : ByteSource(parent), address_(address), server_(this), retry_(this) {
    retry_.setInterval(kRetry_ms);
    connect(&retry_, &QTimer::timeout, this, &TcpListenSource::tryToListen);
    connect(&server_, &QTcpServer::newConnection, this, &TcpListenSource::takeNewest);
}

void TcpListenSource::open() {
    close();
    reported_.reset();
    retry_.start();
    tryToListen();
}

void TcpListenSource::close() {
    retry_.stop();
    server_.close();
    if (peer_) forget(std::exchange(peer_, nullptr));
}

// Its goodbye is of no interest any more.
void TcpListenSource::forget(QTcpSocket* peer) {
    peer->disconnect(this);
    peer->deleteLater();
}

void TcpListenSource::write(const QByteArray& bytes) {
    if (peer_) peer_->write(bytes);
}

void TcpListenSource::tryToListen() {
    if (server_.isListening()) return;
    const QHostAddress host =
        address_.host.isEmpty() ? QHostAddress(QHostAddress::Any) : QHostAddress(address_.host);
    const bool listens = server_.listen(host, address_.port);
    const ErrorCode trouble = listens ? ErrorCode::kPeerMissing : ErrorCode::kAddressInUse;
    if (std::exchange(reported_, trouble) == trouble) return;
    emit failed({trouble, toText(address_).toStdString(),
                 listens ? "nobody has connected yet" : server_.errorString().toStdString()});
}

void TcpListenSource::takeNewest() {
    while (QTcpSocket* const next = server_.nextPendingConnection()) {
        if (peer_) forget(peer_);
        peer_ = next;
    }
    if (!peer_) return;
    watchForDeath(*peer_);
    connect(peer_, &QTcpSocket::readyRead, this, [this] {
        const QByteArray bytes = peer_->readAll();
        if (!bytes.isEmpty()) emit bytesReceived(bytes);
    });
    connect(peer_, &QTcpSocket::disconnected, this, &TcpListenSource::dropPeer);
    emit opened();
}

void TcpListenSource::dropPeer() {
    forget(std::exchange(peer_, nullptr));
    emit failed({ErrorCode::kPeerMissing, toText(address_).toStdString(),
                 "the robot has closed the connection"});
}

}  // namespace hedr
