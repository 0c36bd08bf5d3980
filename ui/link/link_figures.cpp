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
    const QString language = languageOf(last.language);
    if (!last.robot) return language;
    return QString::fromStdString(last.robot->vehicle) + QStringLiteral(" · ") + language;
}

Tone toneWhere(bool bad) { return bad ? Tone::kWarning : Tone::kPlain; }

QString counted(std::uint64_t count) { return QString::number(count); }

}  // namespace

double recentLoss(const LiveModel& model) {
    const auto& samples = model.linkHistory();
    if (samples.empty()) return model.last().link.lossRatio();
    double good = 0.0;
    double sent = 0.0;
    for (const LinkSample& sample : std::span(samples).last(std::min(kRecent, samples.size()))) {
        good += sample.frames_per_s;
        sent += sample.loss < 1.0 ? sample.frames_per_s / (1.0 - sample.loss) : 0.0;
    }
    return sent > 0.0 ? 1.0 - good / sent : 0.0;
}

std::vector<LinkFigure> linkFigures(const LiveModel& model, ReceiveClock::time_point now) {
    const LiveBatch& last = model.last();
    const LinkHealth& link = last.link;
    const auto& samples = model.linkHistory();
    const double loss = recentLoss(model);
    std::vector<LinkFigure> figures{
        {tr("Robot"), robotOf(last)},
        {tr("Port"), toText(last.address)},
        {tr("Last packet"), model.link(now).state == LinkState::kOff
                                ? QStringLiteral("–")
                                : tr("%1 ago").arg(formatAge(model.link(now).age_s))},
        {tr("Loss, 10 s"), formatLoss(loss), toneWhere(loss >= kMuchLoss)},
        {tr("Loss, mission"), formatLoss(link.lossRatio())},
        {tr("Damaged packets"), counted(link.bad_frames)}};
    if (link.late_frames > 0) figures.push_back({tr("Late packets"), counted(link.late_frames)});
    if (!samples.empty()) {
        const LinkSample& latest = samples.back();
        figures.push_back({tr("Jitter"), formatMilliseconds(latest.jitter_s)});
        if (latest.round_trip_s) {
            figures.push_back({tr("Round trip"), formatMilliseconds(*latest.round_trip_s),
                               toneWhere(*latest.round_trip_s >= kSlow_s)});
        }
        if (latest.radio_dbm) {
            figures.push_back({tr("Radio"), formatRadioStrength(*latest.radio_dbm),
                               toneWhere(*latest.radio_dbm <= kWeak_dbm)});
        }
    }
    figures.push_back({tr("Robot restarts"), counted(link.restarts), toneWhere(link.restarts > 0)});
    figures.push_back({tr("Port reopened"), counted(link.reconnects)});
    return figures;
}

}  // namespace hedr
