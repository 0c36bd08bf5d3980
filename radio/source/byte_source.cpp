#include "radio/source/byte_source.h"

#include "radio/source/recording_source.h"
#include "radio/source/serial_source.h"
#include "radio/source/simulated_source.h"
#include "radio/source/tcp_source.h"
#include "radio/source/udp_source.h"

namespace hedr {

namespace {

std::unique_ptr<ByteSource> make(const SerialAddress& address) {
    return std::make_unique<SerialSource>(address);
}
std::unique_ptr<ByteSource> make(const TcpAddress& address) {
    return std::make_unique<TcpSource>(address);
}
std::unique_ptr<ByteSource> make(const TcpListenAddress& address) {
    return std::make_unique<TcpListenSource>(address);
}
std::unique_ptr<ByteSource> make(const UdpAddress& address) {
    return std::make_unique<UdpSource>(address);
}
std::unique_ptr<ByteSource> make(const UdpListenAddress& address) {
    return std::make_unique<UdpSource>(address);
}
std::unique_ptr<ByteSource> make(const RecordingAddress& address) {
    const bool log = address.file.endsWith(QLatin1String(".csv"), Qt::CaseInsensitive);
    if (log) return makeLogSource(address);
    return std::make_unique<RecordingSource>(address);
}
std::unique_ptr<ByteSource> make(const SimulatorAddress& address) { return makeSource(address); }

}  // namespace

std::unique_ptr<ByteSource> makeByteSource(const LinkAddress& address) {
    return std::visit([](const auto& known) { return make(known); }, address);
}

}  // namespace hedr
