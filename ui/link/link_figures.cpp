#include "ui/link/link_figures.h"

#include <QCoreApplication>
#include <algorithm>
#include <span>

#include "ui/format.h"

namespace hedr {
namespace {

constexpr std::size_t kRecent = 10;  // samples, one a second
constexpr double kMuchLoss = 0.2;
constexpr double kSlow_s = 0.5;  // of a round trip: commands feel late
constexpr int kWeak_dbm = -95;

QString tr(const char* text) { return QCoreApplication::translate("LinkFigures", text); }

QString languageOf(RobotLanguage language) {
    switch (language) {
        case RobotLanguage::kHedr:
            return tr("HEDR protocol");
        case RobotLanguage::kMavlink:
            return tr("MAVLink");
        case RobotLanguage::kText:
            return tr("text lines");
        case RobotLanguage::kUnknown:
            break;
    }
    return tr("not recognised yet");
}

QString robotOf(const LiveBatch& last) {
    QString language = languageOf(last.language);
    if (!last.robot) return language;
    return QString::fromStdString(last.robot->vehicle) + QStringLiteral(" · ") + language;
}

LinkFigure signingFigure(const LiveBatch& last) {
    const SigningCounters& signing = last.signing;
    const QString rejected =
        signing.rejected() > 0 ? tr(", %1 rejected").arg(signing.rejected()) : QString();
    const Tone tone = signing.rejected() > 0 ? Tone::kWarning : Tone::kPlain;
    if (signing.signed_frames > 0) return {tr("Signing"), tr("signed") + rejected, tone};
    if (signing.no_key > 0) {
        return {tr("Signing"), tr("signed, but there is no key for it here") + rejected, tone};
    }
    return {tr("Signing"), tr("unsigned") + rejected, tone};
}

Tone toneWhere(bool bad) { return bad ? Tone::kWarning : Tone::kPlain; }

std::optional<double> missionLoss(const LiveModel& model) {
    const LinkHealth& link = model.last().link;
    const bool known = countsLoss(model) && link.good_frames + link.lost_frames > 0;
    return known ? std::optional(link.lossRatio()) : std::nullopt;
}

QString lossText(const std::optional<double>& loss) {
    return loss ? formatLoss(*loss) : QStringLiteral("–");
}

LinkFigure lossFigure(const LiveModel& model) {
    if (!countsLoss(model)) return {tr("Loss"), tr("not told by lines of text"), Tone::kDim};
    const std::optional<double> loss = recentLoss(model);
    return {tr("Loss"), tr("%1, mission %2").arg(lossText(loss), lossText(missionLoss(model))),
            toneWhere(loss >= kMuchLoss)};
}

}  // namespace

bool countsLoss(const LiveModel& model) { return model.last().language != RobotLanguage::kText; }

std::optional<double> recentLoss(const LiveModel& model) {
    const auto& samples = model.linkHistory();
    if (!countsLoss(model)) return std::nullopt;
    if (samples.empty()) return missionLoss(model);
    double good = 0.0;
    double sent = 0.0;
    for (const LinkSample& sample : std::span(samples).last(std::min(kRecent, samples.size()))) {
        good += sample.frames_per_s;
        sent += sample.loss < 1.0 ? sample.frames_per_s / (1.0 - sample.loss) : 0.0;
    }
    return sent > 0.0 ? std::optional(1.0 - good / sent) : std::nullopt;
}

std::vector<LinkFigure> linkFigures(const LiveModel& model) {
    const LiveBatch& last = model.last();
    const LinkHealth& link = last.link;
    std::vector<LinkFigure> figures{{tr("Robot"), robotOf(last)}};
    if (last.wheels_assumed) {
        figures.push_back(
            {tr("Wheels"), tr("not known: trails that use them are a guess"), Tone::kWarning});
    }
    figures.push_back({tr("Port"), toText(last.address)});
    figures.push_back(lossFigure(model));
    if (!model.linkHistory().empty()) {
        const LinkSample& latest = model.linkHistory().back();
        if (latest.round_trip_s) {
            figures.push_back({tr("Round trip"),
                               tr("%1, jitter %2")
                                   .arg(formatMilliseconds(*latest.round_trip_s),
                                        formatMilliseconds(latest.jitter_s)),
                               toneWhere(*latest.round_trip_s >= kSlow_s)});
        } else {
            figures.push_back({tr("Jitter"), formatMilliseconds(latest.jitter_s)});
        }
        if (latest.clock_offset_s) {
            figures.push_back({tr("Robot clock"), formatClockOffset(*latest.clock_offset_s)});
        }
        if (latest.radio_dbm) {
            figures.push_back({tr("Radio"), formatRadioStrength(*latest.radio_dbm),
                               toneWhere(*latest.radio_dbm <= kWeak_dbm)});
        }
    }
    figures.push_back(signingFigure(last));
    const auto add_where_any = [&](const QString& label, std::uint64_t count, Tone tone) {
        if (count > 0) figures.push_back({label, QString::number(count), tone});
    };
    add_where_any(tr("Damaged packets"), link.bad_frames, Tone::kPlain);
    add_where_any(tr("Late packets"), link.late_frames, Tone::kPlain);
    add_where_any(tr("Robot restarts"), link.restarts, Tone::kWarning);
    add_where_any(tr("Port reopened"), link.reconnects, Tone::kPlain);
    return figures;
}

}  // namespace hedr
