#include "radio/publish/pose_publisher.h"

#include <QSysInfo>
#include <QTimer>
#include <algorithm>
#include <utility>

#include "radio/publish/cot_event.h"
#include "radio/publish/datagram_sender.h"
#include "radio/publish/json_line.h"
#include "radio/publish/line_server.h"
#include "radio/publish/nmea_sentence.h"

namespace hedr {

namespace {

std::chrono::milliseconds periodOf(PublishKind kind) {
    switch (kind) {
        case PublishKind::kNmea:
            return std::chrono::milliseconds(200);
        case PublishKind::kJson:
            return std::chrono::milliseconds(100);
        case PublishKind::kCot:
            break;
    }
    return std::chrono::milliseconds(1000);
}

bool needsGlobe(PublishKind kind) { return kind != PublishKind::kJson; }

}  // namespace

// One target that is open: a sender or a server.
struct PosePublisher::Outlet {
    PublishTarget target;
    std::unique_ptr<DatagramSender> sender{};
    std::unique_ptr<LineServer> server{};
    std::optional<Error> pose_error{};  // why there is nothing to say
    QTimer timer{};
};

PosePublisher::PosePublisher(PublishClock clock, QObject* parent)
    : QObject(parent), clock_(std::move(clock)), station_(QSysInfo::machineUniqueId()) {}

PosePublisher::~PosePublisher() = default;

void PosePublisher::setTargets(const std::vector<PublishTarget>& targets) {
    std::vector<std::unique_ptr<Outlet>> before = std::exchange(outlets_, {});
    // What goes is closed before what comes is opened: both may have the same port.
    std::erase_if(before, [&](const std::unique_ptr<Outlet>& outlet) {
        return std::ranges::find(targets, outlet->target) == targets.end();
    });
    outlets_.reserve(targets.size());
    for (const PublishTarget& target : targets) {
        const auto kept = std::ranges::find_if(before, [&](const std::unique_ptr<Outlet>& outlet) {
            return outlet && outlet->target == target;
        });
        outlets_.push_back(kept != before.end() ? std::move(*kept) : open(target));
    }
    emit stateChanged();
}

std::unique_ptr<PosePublisher::Outlet> PosePublisher::open(const PublishTarget& target) {
    auto outlet = std::make_unique<Outlet>();
    outlet->target = target;
    const std::string name = toText(target).toStdString();
    if (target.kind == PublishKind::kCot) {
        outlet->sender = std::make_unique<DatagramSender>(target.host, target.port, name);
        connect(outlet->sender.get(), &DatagramSender::stateChanged, this,
                &PosePublisher::stateChanged);
    } else {
        outlet->server = std::make_unique<LineServer>(target.host, target.port, name);
        connect(outlet->server.get(), &LineServer::stateChanged, this,
                &PosePublisher::stateChanged);
    }
    connect(&outlet->timer, &QTimer::timeout, this, [this, raw = outlet.get()] { send(*raw); });
    outlet->timer.start(periodOf(target.kind));
    return outlet;
}

void PosePublisher::send(Outlet& outlet) {
    const PublishTime time{clock_.now(), clock_.utc_now()};
    QByteArray lines;
    for (const PublishedPose& pose : poses_) {
        if (outlet.target.kind == PublishKind::kJson) lines += jsonLine(pose, time).value_or("");
        if (outlet.target.kind != PublishKind::kCot) continue;
        if (const auto event = cotEvent(pose, time, station_)) outlet.sender->send(*event);
    }
    if (outlet.target.kind == PublishKind::kNmea) {
        const auto chosen = std::ranges::find(poses_, true, &PublishedPose::chosen);
        lines = QByteArray::fromStdString(
            nmeaSentences(chosen == poses_.end() ? std::nullopt : std::optional(*chosen), time));
    }
    if (outlet.server && !lines.isEmpty()) outlet.server->send(lines);
    noteGlobe(outlet);
}

// A robot that does not lie on the globe is the operator's to mend; one that is silent is not.
void PosePublisher::noteGlobe(Outlet& outlet) {
    std::optional<Error> error;
    for (const PublishedPose& pose : poses_) {
        if (!needsGlobe(outlet.target.kind) || error || !isFinite(pose)) continue;
        if (const auto globe = onGlobe(pose); !globe) error = globe.error();
    }
    if (error) error->subject = toText(outlet.target).toStdString();
    const bool changed = error.has_value() != outlet.pose_error.has_value();
    outlet.pose_error = std::move(error);
    if (changed) emit stateChanged();
}

std::vector<PublishState> PosePublisher::states() const {
    std::vector<PublishState> states;
    states.reserve(outlets_.size());
    for (const std::unique_ptr<Outlet>& outlet : outlets_) {
        PublishState state{.target = outlet->target};
        if (outlet->server) {
            state.port = outlet->server->port();
            state.clients = outlet->server->clients();
        }
        state.error = outlet->server ? outlet->server->error() : outlet->sender->error();
        if (!state.error) state.error = outlet->pose_error;
        states.push_back(std::move(state));
    }
    return states;
}

}  // namespace hedr
