#include "radio/publish/datagram_sender.h"

#include <QHostInfo>
#include <utility>

namespace hedr {

DatagramSender::DatagramSender(QString host, std::uint16_t port, std::string name, QObject* parent)
    : QObject(parent),
      host_(std::move(host)),
      port_(port),
      name_(std::move(name)),
      address_(host_),
      socket_(this) {
    if (address_.isNull()) lookUp();
}

void DatagramSender::lookUp() {
    if (std::exchange(looking_up_, true)) return;
    QHostInfo::lookupHost(host_, this, &DatagramSender::handleFound);
}

void DatagramSender::handleFound(const QHostInfo& found) {
    looking_up_ = false;
    if (!found.addresses().isEmpty()) {
        address_ = found.addresses().first();
        return note(std::nullopt);
    }
    note(Error{ErrorCode::kUnreachable, name_, found.errorString().toStdString()});
}

void DatagramSender::send(const QByteArray& datagram) {
    if (address_.isNull()) return lookUp();
    if (socket_.writeDatagram(datagram, address_, port_) == datagram.size()) {
        return note(std::nullopt);
    }
    note(Error{ErrorCode::kUnreachable, name_, socket_.errorString().toStdString()});
}

void DatagramSender::note(std::optional<Error> error) {
    const bool changed = error.has_value() != error_.has_value();
    error_ = std::move(error);
    if (changed) emit stateChanged();
}

}  // namespace hedr
