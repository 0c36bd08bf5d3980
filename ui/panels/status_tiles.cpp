#include "ui/panels/status_tiles.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QStringList>
#include <cmath>

#include "core/geometry/angle.h"
#include "ui/error_text.h"
#include "ui/format.h"
#include "ui/link/link_figures.h"

namespace hedr {

QColor colourOf(Tone tone, const Theme& theme) {
    switch (tone) {
        case Tone::kGood:
            return theme.good;
        case Tone::kWarning:
            return theme.warning;
        case Tone::kAlarm:
            return theme.alarm;
        case Tone::kDim:
            return theme.dim;
        case Tone::kPlain:
            break;
    }
    return theme.ink;
}

namespace {

QString tr(const char* text) { return QCoreApplication::translate("StatusTiles", text); }

const QString kNothing = QStringLiteral("–");

QString joined(const QStringList& parts) { return parts.join(QStringLiteral(" · ")); }

QString oldDetail(const LinkVerdict& link) {
    const bool heard = link.state == LinkState::kStale || link.state == LinkState::kLost;
    return heard ? tr("%1 old").arg(formatAge(link.age_s)) : tr("old");
}

// Never silently off: what cannot be checked is called unsigned.
QString signingBadge(const SigningCounters& signing) {
    if (signing.rejected() > 0) return tr("%1 rejected").arg(signing.rejected());
    return signing.signed_frames > 0 ? tr("signed") : tr("unsigned");
}

QString linkDetail(const LiveModel& model, const LinkVerdict& link) {
    const LiveBatch& last = model.last();
    if (link.state == LinkState::kOff) return tr("not connected");
    if (link.trouble == LinkTrouble::kDeviceGone) {
        const bool by_radio = std::holds_alternative<SerialAddress>(last.address);
        if (link.state != LinkState::kWaiting)
            return by_radio ? tr("radio unplugged") : tr("not connected");
        return isAwaited(last) ? tr("for the robot") : tr("port is not open");
    }
    if (link.trouble == LinkTrouble::kNoValidFrames) return tr("no valid packets");
    if (link.trouble == LinkTrouble::kNoMotion) return tr("robot greets only");
    if (link.trouble == LinkTrouble::kNoBytes) return tr("robot is silent");
    if (link.state == LinkState::kWaiting) return tr("for the first packet");
    QStringList parts{signingBadge(last.signing), formatFrameRate(last.frames_per_s)};
    if (const auto loss = recentLoss(model)) parts.prepend(tr("loss %1").arg(formatLoss(*loss)));
    if (last.status && last.status->radio_dbm) {
        parts << formatRadioStrength(*last.status->radio_dbm);
    }
    return joined(parts);
}

StatusTile linkTile(const LiveModel& model, const LinkVerdict& link) {
    const QString detail = linkDetail(model, link);
    switch (link.state) {
        case LinkState::kOff:
            return {tr("LINK"), tr("OFF"), detail, Tone::kDim, Mark::kRing};
        case LinkState::kWaiting:
            return {tr("LINK"), tr("WAITING"), detail, Tone::kPlain, Mark::kRing};
        case LinkState::kStale:
            return {tr("LINK"), tr("STALE %1").arg(formatAge(link.age_s)), detail, Tone::kWarning,
                    Mark::kTriangle};
        case LinkState::kLost:
            return {tr("LINK"), tr("LOST %1").arg(formatAge(link.age_s)), detail, Tone::kAlarm,
                    Mark::kCross};
        case LinkState::kLive:
            break;
    }
    if (link.trouble == LinkTrouble::kRobotFault) {
        return {tr("LINK"), tr("FAULT"), detail, Tone::kAlarm, Mark::kTriangle};
    }
    return {tr("LINK"), tr("LIVE"), detail, Tone::kGood, Mark::kDisc};
}

QString suspendedBecause(SuspendReason reason) {
    switch (reason) {
        case SuspendReason::kStanding:
            return tr("standing");
        case SuspendReason::kTurning:
            return tr("turning");
        case SuspendReason::kSearching:
            return tr("seeking corridors");
        case SuspendReason::kOffCorridors:
            return tr("off the corridors");
        case SuspendReason::kNone:
            break;
    }
    return tr("suspended");
}

// Two standard deviations: nineteen times of twenty it is nearer.
QString uncertainty(const PoseVariance& variance) {
    const auto position_m2 = static_cast<double>(variance.var_x_m2 + variance.var_y_m2);
    const QString position = formatDistance(2.0 * std::sqrt(position_m2));
    const double heading_rad = 2.0 * std::sqrt(static_cast<double>(variance.var_heading_rad2));
    // Beyond a quarter turn either way the robot may as well drive backwards.
    if (!(heading_rad <= kPi / 2.0)) return tr("heading unknown, ±%1").arg(position);
    return tr("±%1 ±%2").arg(position, formatAngle(heading_rad));
}

// What the few words of the detail mean. Tracks in files have one standard deviation.
QString trustNote(const HedrStatus& hedr, const PoseVariance& variance) {
    QStringList lines;
    if (variance.known()) lines << tr("± holds 95 % of the time (two standard deviations).");
    if (hedr.state == HedrState::kOff) {
        lines << tr("Nothing checks this heading against the corridors.");
    }
    return lines.join(u'\n');
}

QString trustDetail(const HedrStatus& hedr, const PoseVariance& variance) {
    QStringList parts;
    if (variance.known()) parts << uncertainty(variance);
    if (hedr.state == HedrState::kOff) {
        parts << tr("no heading check");
    } else if (hedr.lost) {
        parts << tr("corridors lost");
    } else if (parts.isEmpty() && hedr.state == HedrState::kActive) {
        parts << tr("HEDR active");
    } else if (parts.isEmpty()) {
        parts << suspendedBecause(hedr.reason)
              << tr("HEDR idle %1").arg(formatAge(hedr.seconds_since_active));
    }
    return joined(parts);
}

StatusTile trustOf(const LiveModel& model, ReceiveClock::time_point now) {
    const QString label = tr("TRUST");
    const LinkVerdict link = model.link(now);
    const QString detail =
        isOld(link.state) ? oldDetail(link) : trustDetail(model.status(), model.variance());
    switch (model.trust(now)) {
        case Trust::kGood:
            return {label, tr("GOOD"), detail, Tone::kGood};
        case Trust::kCoasting:
            return {label, tr("COASTING"), detail, Tone::kWarning};
        case Trust::kLostLock:
            return {label, tr("LOST LOCK"), detail, Tone::kAlarm, Mark::kTriangle};
        case Trust::kOff:
            break;
    }
    if (!model.pose()) return {label, kNothing, {}, Tone::kDim};
    // A heading that nothing checks goes wrong without a word: that is worth a warning.
    if (!isOld(link.state)) return {label, tr("OFF"), detail, Tone::kWarning};
    return {label, kNothing, detail, Tone::kDim};
}

StatusTile trustTile(const LiveModel& model, ReceiveClock::time_point now) {
    StatusTile tile = trustOf(model, now);
    if (!isOld(model.link(now).state) && model.pose()) {
        tile.note = trustNote(model.status(), model.variance());
    }
    return tile;
}

QString driftDetail(const HedrStatus& hedr) {
    if (hedr.state == HedrState::kOff) return {};
    const QString drift = tr("drift %1").arg(formatDrift(hedr.drift_rad_s));
    return hedr.held_expired || hedr.lost ? drift + tr(", unknown now") : drift + tr(", removed");
}

StatusTile recordingTile(const LiveBatch& last) {
    const RecorderState& recorder = last.recorder;
    if (recorder.error) {
        const bool full = recorder.error->code == ErrorCode::kDiskFull;
        return {tr("RECORDING"), full ? tr("DISK FULL") : tr("NOT SAVED"),
                joined({tr("kept in memory, tried again"), errorText(*recorder.error)}),
                Tone::kAlarm, Mark::kCross};
    }
    if (recorder.file.empty()) {
        return {tr("RECORDING"), tr("OFF"), tr("starts by itself"), Tone::kDim, Mark::kRing};
    }
    if (last.port == PortState::kClosed) {
        return {tr("RECORDING"), tr("OFF"), tr("saved %1").arg(formatBytes(recorder.bytes)),
                Tone::kDim, Mark::kRing};
    }
    const bool little_room = recorder.free_bytes && *recorder.free_bytes < kLittleRoomBytes;
    if (little_room) {
        return {tr("RECORDING"), tr("REC"), tr("%1 left").arg(formatBytes(*recorder.free_bytes)),
                Tone::kWarning, Mark::kRecording};
    }
    return {tr("RECORDING"), tr("REC"), formatBytes(recorder.bytes), Tone::kPlain,
            Mark::kRecording};
}

QString missionDetail(const LiveBatch& last) {
    return last.robot ? QString::fromStdString(last.robot->vehicle) : QString();
}

}  // namespace

std::vector<StatusTile> statusTiles(const LiveModel& model, ReceiveClock::time_point now) {
    const LiveBatch& last = model.last();
    const LinkVerdict link = model.link(now);
    const auto pose = model.pose();
    const bool old = isOld(link.state);
    const Tone tone = old ? Tone::kDim : Tone::kPlain;
    const auto measured = [&](const QString& label, const QString& value, const QString& detail) {
        if (!pose) return StatusTile{label, kNothing, {}, Tone::kDim};
        return StatusTile{label, value, old ? oldDetail(link) : detail, tone};
    };
    const double home_m = model.homeDistance_m();
    const double duration_s = model.missionDuration_s(now);
    std::vector<StatusTile> tiles{
        linkTile(model, link),
        trustTile(model, now),
        measured(tr("HEADING"), pose ? formatHeading(pose->heading_rad) : QString(),
                 driftDetail(model.status())),
        measured(tr("SPEED"), formatSpeed(last.speed_m_s),
                 tr("driven %1").arg(formatDistance(last.driven_m))),
        measured(tr("HOME"), formatDistance(home_m),
                 home_m < 0.5 ? tr("here")
                              : tr("towards %1").arg(formatHeading(model.homeBearing_rad()))),
        {tr("MISSION"), formatDuration(duration_s), missionDetail(last),
         duration_s > 0.0 && link.state != LinkState::kOff ? Tone::kPlain : Tone::kDim},
        recordingTile(last),
    };
    const QString widest[] = {tr("STALE %1").arg(formatAge(99.0)),
                              tr("LOST LOCK"),
                              formatHeading(3.0),
                              formatSpeed(9.99),
                              formatDistance(999.9),
                              formatDuration(0.0),
                              tr("NOT SAVED")};
    for (std::size_t i = 0; i < tiles.size(); ++i) tiles[i].widest_value = widest[i];
    tiles.front().kind = TileKind::kLink;
    return tiles;
}

}  // namespace hedr
