#include "app/robot_writer.h"

#include <utility>

namespace hedr {

namespace {

// Away from those of the window.
constexpr std::uint64_t kFirstTicket = std::uint64_t{1} << 62U;

constexpr int kPause_ms = 2000;

}  // namespace

RobotWriter::RobotWriter(const std::vector<ParameterSet>& wishes, Ask ask, QObject* parent)
    : QObject(parent), write_(wishes), ask_(std::move(ask)), last_ticket_(kFirstTicket) {
    pause_.setSingleShot(true);
    connect(&pause_, &QTimer::timeout, this, [this] {
        write_.tryAgain();
        goOn();
    });
}

void RobotWriter::start() { goOn(); }

void RobotWriter::hear(const LiveBatch& batch) {
    if (write_.over()) return;
    for (const RequestProgress& progress : batch.requests) write_.hear(progress);
    if (write_.waits() && !std::exchange(told_delay_, true))
        emit delayed(QString::fromStdString(write_.delay()));
    if (write_.state() == RobotWrite::State::kWaitingForRobot && !pause_.isActive())
        pause_.start(kPause_ms);
    if (batch.port == PortState::kOpen && batch.frames_per_s > 0.0) write_.linkReturned();
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
