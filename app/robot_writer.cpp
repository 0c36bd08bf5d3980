#include "app/robot_writer.h"

#include <utility>

namespace hedr {

namespace {

// Away from those of the window.
constexpr std::uint64_t kFirstTicket = std::uint64_t{1} << 62U;

}  // namespace

RobotWriter::RobotWriter(const std::vector<ParameterSet>& wishes, Ask ask, QObject* parent)
    : QObject(parent), write_(wishes), ask_(std::move(ask)), last_ticket_(kFirstTicket) {}

void RobotWriter::start() { goOn(); }

void RobotWriter::hear(const LiveBatch& batch) {
    if (write_.over()) return;
    for (const RequestProgress& progress : batch.requests) write_.hear(progress);
    if (write_.state() == RobotWrite::State::kWaitingForLink) {
        if (!std::exchange(told_missing_, true)) emit linkMissed();
        if (batch.port == PortState::kOpen && batch.frames_per_s > 0.0) write_.linkReturned();
    }
    goOn();
}

void RobotWriter::goOn() {
    if (const auto request = write_.next()) {
        write_.asked(++last_ticket_);
        ask_(last_ticket_, *request);
    }
    if (write_.over()) emit ended(QString::fromStdString(write_.reason()));
}

}  // namespace hedr
