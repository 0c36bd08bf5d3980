#include "ui/link/link_advice.h"

#include <QCoreApplication>
#include <QStringList>

#include "radio/wire/frame.h"
#include "ui/error_text.h"

namespace hedr {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("LinkAdvice", text); }

QString awaitedAdvice(const LinkAddress& address) {
    return tr("Waiting for the robot to connect to port %1.")
        .arg(std::get<TcpListenAddress>(address).port);
}

// A port that went away in mid-mission is an unplugged radio; any other reason speaks for itself.
QString goneAdvice(const LiveBatch& last, const LinkVerdict& link) {
    const bool by_radio = std::holds_alternative<SerialAddress>(last.address);
    if (!by_radio && !last.port_error) {
        return tr(
            "The connection to the robot has ended. The mission goes on by itself as soon as "
            "the robot is back.");
    }
    if (link.state == LinkState::kWaiting && isAwaited(last)) return awaitedAdvice(last.address);
    const bool unplugged = link.state != LinkState::kWaiting &&
                           (!last.port_error || last.port_error->code == ErrorCode::kPortMissing ||
                            last.port_error->code == ErrorCode::kPortFailed);
    if (unplugged || !last.port_error) {
        return tr("The radio is unplugged. Plug it in again: the mission goes on by itself.");
    }
    return errorText(*last.port_error);
}

QString asSentence(QString words) {
    words[0] = words[0].toUpper();
    return words + u'.';
}

// What to do about bytes that nobody understands.
QString babbleAdvice(const LiveBatch& last) {
    const SigningCounters& signing = last.signing;
    if (signing.no_key > 0 && signing.signed_frames == 0) {
        return tr(
            "They are signed, and this computer has no key: copy the robot's key file into "
            "~/.local/share/hedr/keys and connect again.");
    }
    if (signing.rejected() > 0) {
        return tr("They are not believed: unsigned, repeated, or signed with another key.");
    }
    if (!last.refusal.empty()) return asSentence(QString::fromStdString(last.refusal));
    const auto* serial = std::get_if<SerialAddress>(&last.address);
    if (!serial) return tr("It speaks neither protocol 1, nor MAVLink, nor lines of text.");
    return serial->baud == SerialAddress::kFindOut ? tr("Looking for the baud rate.")
                                                   : tr("Check the baud rate.");
}

// The bits of radio/README.md in words; those it does not name by their numbers.
QString faultAdvice(const LiveBatch& last) {
    const QStringList names{tr("left encoder"), tr("right encoder"), tr("gyro"), tr("battery low"),
                            tr("drive")};
    const unsigned faults = last.status ? last.status->faults : 0U;
    QStringList said;
    for (int bit = 0; bit < 16; ++bit) {
        if ((faults >> static_cast<unsigned>(bit) & 1U) == 0U) continue;
        said << (bit < names.size() ? names[bit] : tr("number %1").arg(bit));
    }
    return tr("The robot reports a fault: %1.").arg(said.join(QStringLiteral(", ")));
}

}  // namespace

QString linkAdvice(const LiveBatch& last, const LinkVerdict& link, const Clock& clock) {
    const bool heard = link.trouble == LinkTrouble::kNone || link.trouble == LinkTrouble::kNoMotion;
    if (heard && last.robot && last.robot->protocol != kProtocol) {
        return tr("The robot speaks protocol %1, this program protocol %2. Update the older one.")
            .arg(last.robot->protocol)
            .arg(kProtocol);
    }
    const auto age_ms = static_cast<qint64>(1000.0 * link.age_s);
    const QString since = clock.wall_now().addMSecs(-age_ms).toString(QStringLiteral("HH:mm:ss"));
    switch (link.trouble) {
        case LinkTrouble::kDeviceGone:
            return goneAdvice(last, link);
        case LinkTrouble::kNoBytes:
            return tr("No packets since %1. Radio is plugged in, robot is silent.").arg(since);
        case LinkTrouble::kNoValidFrames:
            return tr("No valid packets since %1, but bytes arrive. %2")
                .arg(since, babbleAdvice(last));
        case LinkTrouble::kNoMotion:
            return tr("The robot is heard, but since %1 it has not said how it moves.").arg(since);
        case LinkTrouble::kRobotFault:
            return faultAdvice(last);
        case LinkTrouble::kNone:
            break;
    }
    return link.state == LinkState::kOff && last.port_error ? errorText(*last.port_error)
                                                            : QString();
}

}  // namespace hedr
