#include "radio/source/link_address.h"

#include <QFileInfo>
#include <QUrl>
#include <QUrlQuery>
#include <utility>

#include "core/simulation/scenario.h"

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

tl::unexpected<Error> refuse(const QString& text, const std::string& why) {
    return fail(ErrorCode::kBadValue, text.toStdString(), why);
}

bool isRecordingName(const QString& text) {
    const QString suffix = QFileInfo(text).suffix().toLower();
    return (suffix == QLatin1String("hedr") || suffix == QLatin1String("csv")) &&
           !text.startsWith(QLatin1String("/dev/"));
}

// What a recording and a simulation may be told.
struct Wishes {
    std::optional<std::uint64_t> seed{};
    double speed = 1.0;
};

Result<Wishes> wishesIn(const QString& text, const QString& query) {
    constexpr double kSlowest = 0.01;
    constexpr double kFastest = 10000.0;
    Wishes wishes;
    for (const auto& [key, value] : QUrlQuery(query).queryItems()) {
        bool good = false;
        if (key == QLatin1String("seed")) {
            wishes.seed = value.toULongLong(&good);
            if (!good) return refuse(text, "needs a seed that is a whole number from 0");
        } else if (key == QLatin1String("speed")) {
            wishes.speed = value.toDouble(&good);
            if (!good || !(wishes.speed >= kSlowest && wishes.speed <= kFastest))
                return refuse(text, "needs a speed from 0.01 to 10000");
        } else {
            return refuse(text, "has \"" + key.toStdString() + "\" where seed or speed may stand");
        }
    }
    return wishes;
}

Result<LinkAddress> recordingAt(const QString& text, const QString& path, const Wishes& wishes) {
    if (!path.startsWith(QLatin1Char('/')))
        return refuse(text, "needs the full path of a file, as in file:///home/me/mission.hedr");
    if (wishes.seed) return refuse(text, "has a seed, which a recording has not");
    return RecordingAddress{QUrl::fromPercentEncoding(path.toUtf8()), wishes.speed};
}

Result<LinkAddress> simulatorOf(const QString& text, const QString& name, const Wishes& wishes) {
    if (!scenarioByName(name.toStdString())) {
        std::string names;
        for (const ScenarioEntry& entry : scenarioTable())
            names.append(names.empty() ? "" : ", ").append(entry.name);
        return refuse(text, "has no scenario that is known; there are " + names);
    }
    return SimulatorAddress{name, wishes.seed.value_or(SimulatorAddress::kUsualSeed), wishes.speed};
}

// "file://" and "sim://", with `rest` behind them.
Result<LinkAddress> playedAddress(const QString& text, bool simulated, const QString& rest) {
    const qsizetype mark = rest.indexOf(QLatin1Char('?'));
    const auto wishes = wishesIn(text, mark < 0 ? QString() : rest.mid(mark + 1));
    if (!wishes) return tl::make_unexpected(wishes.error());
    const QString place = rest.left(mark);
    return simulated ? simulatorOf(text, place, *wishes) : recordingAt(text, place, *wishes);
}

QString withWishes(const QString& place, std::optional<std::uint64_t> seed, double speed) {
    QStringList wishes;
    if (seed) wishes += QStringLiteral("seed=") + QString::number(*seed);
    if (speed != 1.0) wishes += QStringLiteral("speed=") + QString::number(speed);
    return wishes.isEmpty() ? place : place + '?' + wishes.join('&');
}

// Only what the address would take for its own grammar.
QString fileUrl(QString path) {
    return QStringLiteral("file://") + path.replace('%', "%25").replace('?', "%3F");
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
    if (mark < 0 && isRecordingName(text))
        return RecordingAddress{QFileInfo(text).absoluteFilePath()};
    if (mark < 0) return serialAddress(text);
    const QString scheme = text.left(mark).toLower();
    const bool simulated = scheme == QLatin1String("sim");
    if (simulated || scheme == QLatin1String("file"))
        return playedAddress(text, simulated, text.mid(mark + 3));
    const bool tcp = scheme == QLatin1String("tcp");
    if (!tcp && scheme != QLatin1String("udp")) {
        return refuse(text,
                      "must be a serial port, tcp://HOST:PORT, udp://:PORT, file:///FILE or "
                      "sim://SCENARIO");
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
            [](const UdpListenAddress& a) { return withScheme("udp://", a.host, a.port, true); },
            [](const RecordingAddress& a) { return withWishes(fileUrl(a.file), {}, a.speed); },
            [](const SimulatorAddress& a) {
                return withWishes(QStringLiteral("sim://") + a.scenario, a.seed, a.speed);
            }},
        address);
}

}  // namespace hedr
