#include "radio/source/link_address.h"

#include <QStringList>
#include <utility>

namespace hedr {

namespace {

constexpr int kFastestBaud = 12'000'000;

SerialAddress serialAddress(const QString& text) {
    const qsizetype colon = text.lastIndexOf(QLatin1Char(':'));
    bool is_number = false;
    const int baud = colon > 0 ? text.mid(colon + 1).toInt(&is_number) : 0;
    if (!is_number || baud <= 0 || baud > kFastestBaud) return {.device = text};
    return {.device = text.left(colon), .baud = baud};
}

struct HostAndPort {
    QString host;
    std::uint16_t port = 0;
    bool own = false;  // "@HOST": an address of this computer
};

// An address of IPv6 stands in brackets.
Result<HostAndPort> hostAndPort(const QString& text, const QString& rest) {
    const qsizetype colon = rest.lastIndexOf(QLatin1Char(':'));
    bool is_number = false;
    const std::uint16_t port = colon >= 0 ? rest.mid(colon + 1).toUShort(&is_number) : 0;
    if (!is_number || port == 0) {
        return fail(ErrorCode::kBadValue, text.toStdString(),
                    "needs a port from 1 to 65535, as in tcp://192.168.1.5:4000 or udp://:14550");
    }
    QString host = rest.left(colon);
    const bool own = host.startsWith(QLatin1Char('@'));
    if (own) host.remove(0, 1);
    if (host.startsWith(QLatin1Char('[')) && host.endsWith(QLatin1Char(']'))) {
        host = host.mid(1, host.size() - 2);
    }
    if (host.contains(QLatin1Char('/')) || host.contains(QLatin1Char(' '))) {
        return fail(ErrorCode::kBadValue, text.toStdString(), "has a host that cannot be one");
    }
    return HostAndPort{host, port, own || host.isEmpty()};
}

QString withScheme(const char* scheme, const QString& host, std::uint16_t port, bool own) {
    const QString at = own && !host.isEmpty() ? QStringLiteral("@") : QString();
    const QString shown = host.contains(QLatin1Char(':')) ? '[' + host + ']' : host;
    return QLatin1String(scheme) + at + shown + ':' + QString::number(port);
}

template <class... Cases>
struct Overloaded : Cases... {
    using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

}  // namespace

Result<LinkAddress> parseLinkAddress(const QString& text) {
    const qsizetype mark = text.indexOf(QLatin1String("://"));
    if (mark < 0) return serialAddress(text);
    const QString scheme = text.left(mark).toLower();
    const bool tcp = scheme == QLatin1String("tcp");
    if (!tcp && scheme != QLatin1String("udp")) {
        return fail(ErrorCode::kBadValue, text.toStdString(),
                    "must be a serial port, tcp://HOST:PORT or udp://:PORT");
    }
    auto place = hostAndPort(text, text.mid(mark + 3));
    if (!place) return tl::make_unexpected(place.error());
    auto& [host, port, own] = *place;
    if (tcp && own) return TcpListenAddress{host, port};
    if (tcp) return TcpAddress{host, port};
    if (own) return UdpListenAddress{host, port};
    return UdpAddress{host, port};
}

QString toText(const LinkAddress& address) {
    return std::visit(
        Overloaded{
            [](const SerialAddress& a) {
                const bool known = a.baud != SerialAddress::kFindOut;
                return known ? a.device + ':' + QString::number(a.baud) : a.device;
            },
            [](const TcpAddress& a) { return withScheme("tcp://", a.host, a.port, false); },
            [](const TcpListenAddress& a) { return withScheme("tcp://", a.host, a.port, true); },
            [](const UdpAddress& a) { return withScheme("udp://", a.host, a.port, false); },
            [](const UdpListenAddress& a) { return withScheme("udp://", a.host, a.port, true); }},
        address);
}

}  // namespace hedr
