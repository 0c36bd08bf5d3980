#include "radio/publish/publish_target.h"

#include <QHostAddress>
#include <optional>
#include <variant>

#include "radio/source/link_address.h"

namespace hedr {

namespace {

struct Language {
    PublishKind kind;
    const char* word;
    std::uint16_t port;  // 10110 is registered for NMEA 0183, 4242 is where CoT programs listen
};

constexpr Language kLanguages[] = {{PublishKind::kCot, "cot", 4242},
                                   {PublishKind::kNmea, "nmea", 10110},
                                   {PublishKind::kJson, "json", 10120}};

const Language& languageOf(PublishKind kind) { return kLanguages[static_cast<std::size_t>(kind)]; }

const char* wanted(PublishKind kind) {
    return kind == PublishKind::kCot
               ? "is sent by UDP: udp://HOST:PORT, or udp://:PORT for this computer"
               : "waits for clients by TCP: tcp://:PORT for those on this computer, "
                 "tcp://@ADDRESS:PORT for those who reach that address of it";
}

bool isNumeric(const QString& host) { return !QHostAddress(host).isNull(); }

// None: no address for this language. An empty host is this computer.
std::optional<PublishTarget> targetOf(PublishKind kind, const LinkAddress& address) {
    const bool cot = kind == PublishKind::kCot;
    if (const auto* to = std::get_if<UdpAddress>(&address); to && cot) {
        return PublishTarget{kind, to->host, to->port};
    }
    const auto* here = std::get_if<UdpListenAddress>(&address);
    if (here && cot && here->host.isEmpty()) return PublishTarget{.kind = kind, .port = here->port};
    const auto* at = std::get_if<TcpListenAddress>(&address);
    if (!at || cot) return std::nullopt;
    if (at->host.isEmpty()) return PublishTarget{.kind = kind, .port = at->port};
    if (!isNumeric(at->host)) return std::nullopt;
    return PublishTarget{kind, at->host, at->port};
}

}  // namespace

QString publishWord(PublishKind kind) { return QLatin1String(languageOf(kind).word); }

PublishTarget defaultTarget(PublishKind kind) {
    return {.kind = kind, .port = languageOf(kind).port};
}

Result<PublishTarget> parsePublishAddress(PublishKind kind, const QString& address) {
    const auto parsed = parseLinkAddress(address.trimmed());
    const auto target = parsed ? targetOf(kind, *parsed) : std::nullopt;
    if (!target) return fail(ErrorCode::kBadValue, address.toStdString(), wanted(kind));
    return *target;
}

Result<PublishTarget> parsePublishTarget(const QString& text) {
    const QString word = text.section(QLatin1Char('='), 0, 0).trimmed().toLower();
    for (const Language& language : kLanguages) {
        if (word != QLatin1String(language.word)) continue;
        if (!text.contains(QLatin1Char('='))) return defaultTarget(language.kind);
        auto target = parsePublishAddress(language.kind, text.section(QLatin1Char('='), 1));
        if (!target) target.error().subject = text.toStdString();
        return target;
    }
    return fail(ErrorCode::kBadValue, text.toStdString(),
                "must be cot=udp://HOST:PORT, nmea=tcp://:PORT or json=tcp://:PORT");
}

QString addressText(const PublishTarget& target) {
    const bool here = target.host == PublishTarget{}.host;
    if (target.kind == PublishKind::kCot) return toText(UdpAddress{target.host, target.port});
    return toText(TcpListenAddress{here ? QString() : target.host, target.port});
}

QString toText(const PublishTarget& target) {
    return publishWord(target.kind) + QLatin1Char('=') + addressText(target);
}

bool leavesThisComputer(const PublishTarget& target) {
    return target.host != QLatin1String("localhost") && !QHostAddress(target.host).isLoopback();
}

}  // namespace hedr
