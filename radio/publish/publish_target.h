#pragma once

#include <QString>
#include <cstdint>

#include "core/result.h"

namespace hedr {

enum class PublishKind : unsigned char { kCot, kNmea, kJson };

inline constexpr PublishKind kPublishKinds[] = {PublishKind::kCot, PublishKind::kNmea,
                                                PublishKind::kJson};

// Where poses are published, and in which language. CoT is sent there by UDP; NMEA and JSON wait
// there for clients by TCP, on one of our own addresses.
struct PublishTarget {
    PublishKind kind = PublishKind::kCot;
    QString host = QStringLiteral("127.0.0.1");
    std::uint16_t port = 0;
    friend bool operator==(const PublishTarget&, const PublishTarget&) = default;
};

// "cot", "nmea", "json".
QString publishWord(PublishKind kind);

// On this computer: CoT to port 4242, NMEA at 10110, JSON at 10120.
PublishTarget defaultTarget(PublishKind kind);

// "cot=udp://HOST:PORT", "nmea=tcp://:PORT", "json=tcp://@ADDRESS:PORT"; the word alone: its
// default. A host that is not said is this computer, 127.0.0.1, and nobody else hears or connects;
// radio/source/link_address.h, where the robot is meant, listens everywhere then. Errors:
// kBadValue.
Result<PublishTarget> parsePublishTarget(const QString& text);

// The address alone, as it stands after the "=".
Result<PublishTarget> parsePublishAddress(PublishKind kind, const QString& address);

// As these two take it.
QString toText(const PublishTarget& target);
QString addressText(const PublishTarget& target);

// Other computers hear it, or may connect: nothing of it is secret, nor signed.
bool leavesThisComputer(const PublishTarget& target);

}  // namespace hedr
