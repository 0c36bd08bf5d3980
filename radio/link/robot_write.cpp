#include "radio/link/robot_write.h"

#include <utility>

namespace hedr {

namespace {

std::string whyNot(const RequestProgress& progress) {
    switch (progress.state) {
        case RequestState::kRefused:
            return progress.reason == AcknowledgeResult::kNotWhileMoving
                       ? "The robot takes no parameters while it moves."
                       : "The robot refused a value.";
        case RequestState::kDiffers:
            return "The robot reads back another value than was written.";
        case RequestState::kCanceled:
            return "The link to the robot was lost.";
        default:
            return "The robot did not answer.";
    }
}

}  // namespace

RobotWrite::RobotWrite(const std::vector<ParameterSet>& wishes) {
    for (const ParameterSet& wish : wishes) values_.push_back({wish.id, wish.value});
    if (values_.empty()) state_ = State::kDone;
}

std::optional<Request> RobotWrite::next() const {
    if (ticket_ || over() || waits()) return std::nullopt;
    const Value& value = current();
    if (state_ == State::kReading || state_ == State::kComparing) return ParameterGet{value.id};
    return ParameterSet{value.id, state_ == State::kWriting ? value.wanted : *value.before};
}

void RobotWrite::hear(const RequestProgress& progress) {
    if (ticket_ != progress.ticket || !isOver(progress.state)) return;
    ticket_.reset();
    if (state_ == State::kReading) return heardRead(progress);
    if (state_ == State::kWriting) return heardWrite(progress);
    if (state_ == State::kComparing) return heardCompared(progress);
    if (state_ == State::kPuttingBack) heardPutBack(progress);
}

void RobotWrite::heardRead(const RequestProgress& progress) {
    if (progress.state != RequestState::kDone || !progress.value) {
        reason_ = whyNot(progress) + " Nothing was written.";
        state_ = State::kAsBefore;
        return;
    }
    current().before = progress.value;
    if (++at_ < values_.size()) return;
    at_ = 0;
    state_ = State::kWriting;
    skipWhatIsThere();
}

void RobotWrite::heardWrite(const RequestProgress& progress) {
    current().touched = true;
    if (progress.state != RequestState::kDone) return putBack(whyNot(progress));
    ++at_;
    skipWhatIsThere();
}

void RobotWrite::skipWhatIsThere() {
    while (at_ < values_.size() && current().before == current().wanted) ++at_;
    if (at_ < values_.size()) return;
    at_ = 0;
    state_ = State::kComparing;
}

void RobotWrite::heardCompared(const RequestProgress& progress) {
    if (progress.state != RequestState::kDone) return putBack(whyNot(progress));
    if (progress.value != current().wanted)
        return putBack("The robot has another value than was written; was it restarted?");
    if (++at_ == values_.size()) state_ = State::kDone;
}

void RobotWrite::putBack(std::string reason) {
    if (reason_.empty()) reason_ = std::move(reason);
    for (at_ = 0; at_ < values_.size() && !current().touched; ++at_) {
    }
    state_ = at_ < values_.size() ? State::kPuttingBack : State::kAsBefore;
}

void RobotWrite::heardPutBack(const RequestProgress& progress) {
    if (progress.state != RequestState::kDone) {
        const bool heard =
            progress.state == RequestState::kRefused || progress.state == RequestState::kDiffers;
        state_ = heard ? State::kWaitingForRobot : State::kWaitingForLink;
        delay_ = whyNot(progress);
        return;
    }
    current().touched = false;
    putBack({});
}

void RobotWrite::linkReturned() {
    if (state_ == State::kWaitingForLink) state_ = State::kPuttingBack;
}

void RobotWrite::tryAgain() {
    if (state_ == State::kWaitingForRobot) state_ = State::kPuttingBack;
}

void RobotWrite::cancel() {
    if (over() || state_ == State::kPuttingBack || waits()) return;
    // What is on its way may arrive.
    if (state_ == State::kWriting && ticket_) current().touched = true;
    ticket_.reset();
    putBack("It was canceled.");
}

}  // namespace hedr
