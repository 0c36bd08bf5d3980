#include "radio/source/udp_source.h"

#include <QHostInfo>
#include <QNetworkDatagram>
#include <QVariant>
#include <utility>

namespace hedr {

namespace {

constexpr int kRetry_ms = 250;
constexpr std::chrono::seconds kSilent{1};
constexpr int kReceiveBufferBytes = 1 << 20;  // a moment's rest of this thread loses nothing

}  // namespace

UdpSource::UdpSource(const UdpListenAddress& address, QObject* parent)
    : UdpSource(LinkAddress(address), parent) {}

UdpSource::UdpSource(const UdpAddress& address, QObject* parent)
    : UdpSource(LinkAddress(address), parent) {
    const QHostAddress host(address.host);
    if (!host.isNull()) peer_ = Peer{host, address.port, {}};
}

UdpSource::UdpSource(LinkAddress address, QObject* parent)
    : ByteSource(parent), address_(std::move(address)), socket_(this), retry_(this) {
    retry_.setInterval(kRetry_ms);
    connect(&retry_, &QTimer::timeout, this, &UdpSource::tryToBind);
    connect(&socket_, &QUdpSocket::readyRead, this, &UdpSource::readAll);
}

void UdpSource::open() {
    close();
    reported_ = false;
    retry_.start();
    tryToBind();
}

void UdpSource::close() {
    retry_.stop();
    socket_.close();
    if (!speaksFirst()) peer_.reset();
}

void UdpSource::write(const QByteArray& bytes) {
    if (peer_ && socket_.state() == QUdpSocket::BoundState) {
        socket_.writeDatagram(bytes, peer_->host, peer_->port);
    }
}

// A name may be known later only: it is looked up again with each try.
void UdpSource::lookUpPeer() {
    if (std::exchange(looking_up_, true)) return;
    const auto& wanted = std::get<UdpAddress>(address_);
    QHostInfo::lookupHost(wanted.host, this, [this](const QHostInfo& info) {
        looking_up_ = false;
        if (!retry_.isActive()) return;  // closed meanwhile
        if (!info.addresses().isEmpty()) {
            peer_ = Peer{info.addresses().front(), std::get<UdpAddress>(address_).port, {}};
            return tryToBind();
        }
        if (std::exchange(reported_, true)) return;
        emit failed({ErrorCode::kPeerMissing, toText(address_).toStdString(),
                     info.errorString().toStdString()});
    });
}

void UdpSource::tryToBind() {
    if (socket_.state() == QUdpSocket::BoundState) return;
    if (speaksFirst() && !peer_) return lookUpPeer();
    const auto* listen = std::get_if<UdpListenAddress>(&address_);
    const QHostAddress host = listen && !listen->host.isEmpty() ? QHostAddress(listen->host)
                                                                : QHostAddress(QHostAddress::Any);
    if (socket_.bind(host, listen ? listen->port : 0, QUdpSocket::DontShareAddress)) {
        socket_.setSocketOption(QUdpSocket::ReceiveBufferSizeSocketOption,
                                QVariant(kReceiveBufferBytes));
        reported_ = false;
        emit opened();
        return;
    }
    if (std::exchange(reported_, true)) return;
    emit failed({ErrorCode::kAddressInUse, toText(address_).toStdString(),
                 socket_.errorString().toStdString()});
}

void UdpSource::readAll() {
    QByteArray bytes;
    while (socket_.hasPendingDatagrams()) {
        const QNetworkDatagram datagram = socket_.receiveDatagram();
        const auto port = static_cast<std::uint16_t>(datagram.senderPort());
        if (isRobot(datagram.senderAddress(), port)) bytes += datagram.data();
    }
    if (!bytes.isEmpty()) emit bytesReceived(bytes);
}

bool UdpSource::isRobot(const QHostAddress& host, std::uint16_t port) {
    const auto now = Clock::now();
    const bool known = peer_ && peer_->port == port && peer_->host.isEqual(host);
    const bool may_change = !speaksFirst() && (!peer_ || now - peer_->heard > kSilent);
    if (!known && !may_change) return false;
    peer_ = Peer{host, port, now};
    return true;
}

}  // namespace hedr
