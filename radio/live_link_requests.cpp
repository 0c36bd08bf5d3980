// What a LiveLink says to its robot.
#include <algorithm>
#include <cmath>
#include <string>

#include "radio/live_link.h"

namespace hedr {

void LiveLink::ask(std::uint64_t ticket, const Request& request) {
    requests_.ask(ticket, request);
    const bool heard = batch_.port == PortState::kOpen && source_->canAnswer();
    if (!heard) requests_.cancel(ticket);
    askRobot();
}

void LiveLink::cancelRequest(std::uint64_t ticket) {
    requests_.cancel(ticket);
    noteRequests();
}

void LiveLink::askRobot() {
    if (batch_.port == PortState::kOpen) {
        const double round_trip_s = clock_echo_.roundTrip_s(time_s()).value_or(0.0);
        for (const Request& request : requests_.due(time_s(), round_trip_s))
            send(receiver_.spoken(request));
        if (source_->canAnswer() && (receiver_.listens() || source_->speaksFirst())) {
            if (const auto question = clock_echo_.requestIfDue(time_s()))
                send(receiver_.spoken(*question));
        }
    }
    noteRequests();
}

// What goes to the robot is recorded like what comes from it.
void LiveLink::send(const std::vector<std::uint8_t>& spoken) {
    const auto bytes = keys_.outgoing(receiver_.verifier(), spoken);
    if (!bytes) noteKeys(tl::make_unexpected(bytes.error()));
    if (!bytes || bytes->empty()) return;
    recorder_.addMark(time_s(), StreamKind::kSent, *bytes);
    source_->write(QByteArray(reinterpret_cast<const char*>(bytes->data()),
                              static_cast<qsizetype>(bytes->size())));
}

void LiveLink::noteRequests() {
    for (const RequestProgress& progress : requests_.takeNews()) {
        if (isOver(progress.state)) {
            recorder_.addEvent({time_s(), kRequestEvent, describe(progress)});
        }
        batch_.requests.push_back(progress);
        news_ = true;
    }
}

// A robot of which nothing comes is another trouble, and what is played cannot be asked.
void LiveLink::watchSensorRate() {
    const bool live = batch_.port == PortState::kOpen && source_->canAnswer();
    if (!live || !receiver_.robot() || batch_.frames_per_s == 0.0) return;
    const auto& [sensors, poses] = receiver_.motionCount();
    const SensorRate::Advice advice = sensor_rate_.look(time_s(), std::max(sensors, poses));
    if (advice == SensorRate::Advice::kNone) return;
    for (const auto& wish : receiver_.wishesSpoken()) send(wish);
    if (advice == SensorRate::Advice::kWarn) warnOfRareSensors();
}

void LiveLink::warnOfRareSensors() {
    const auto tenths = static_cast<long>(std::lround(10.0 * sensor_rate_.rate_hz()));
    const std::string rate = std::to_string(tenths / 10) + '.' + std::to_string(tenths % 10);
    const std::string detail = rate + " times a second";
    batch_.warnings.push_back({ErrorCode::kSensorsRare, receiver_.robot()->vehicle, detail});
    recorder_.addEvent({time_s(), kWarningEvent, "sensors: " + detail});
    news_ = true;
}

}  // namespace hedr
