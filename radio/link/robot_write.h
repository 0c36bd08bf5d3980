#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "radio/link/requests.h"

namespace hedr {

// Writes several parameters to a robot so that it has all of them in the end or none: reads what it
// has, writes, and puts back what was there as soon as one value is refused, differs or is not
// answered. Where the link is lost meanwhile, that is done when it is back. Asks for one request at
// a time; each is repeated and read back by `Requests`.
class RobotWrite {
  public:
    enum class State : std::uint8_t {
        kReading,
        kWriting,
        kComparing,  // all of them once more, for the robot may have been restarted meanwhile
        kPuttingBack,
        kWaitingForLink,   // to put back
        kWaitingForRobot,  // the same: it is heard, but refuses what it had; `delay` says why
        kDone,             // the robot has the new values
        kAsBefore          // it has the old ones; `reason` says why
    };

    struct Value {
        std::uint8_t id = 0;
        std::int32_t wanted = 0;
        std::optional<std::int32_t> before{};  // as the robot said
        bool touched = false;                  // it may have another value than `before`
        friend bool operator==(const Value&, const Value&) = default;
    };

    explicit RobotWrite(const std::vector<ParameterSet>& wishes);

    // What is to be asked now; none while an answer is waited for and where nothing is left.
    std::optional<Request> next() const;
    void asked(std::uint64_t ticket) { ticket_ = ticket; }
    void hear(const RequestProgress& progress);
    // The link was lost and is back.
    void linkReturned();
    // The robot had a while since it refused.
    void tryAgain();
    // The operator does not want it any more.
    void cancel();

    State state() const { return state_; }
    bool waits() const {
        return state_ == State::kWaitingForLink || state_ == State::kWaitingForRobot;
    }
    bool over() const { return state_ == State::kDone || state_ == State::kAsBefore; }
    const std::string& reason() const { return reason_; }  // why not, in plain English
    const std::string& delay() const { return delay_; }    // why it is not put back yet
    const std::vector<Value>& values() const { return values_; }

  private:
    void heardRead(const RequestProgress& progress);
    void heardWrite(const RequestProgress& progress);
    void heardCompared(const RequestProgress& progress);
    void heardPutBack(const RequestProgress& progress);
    void skipWhatIsThere();
    void putBack(std::string reason);
    Value& current() { return values_[at_]; }
    const Value& current() const { return values_[at_]; }

    std::vector<Value> values_;
    std::size_t at_ = 0;  // the value that is next
    std::optional<std::uint64_t> ticket_{};
    State state_ = State::kReading;
    std::string reason_{};
    std::string delay_{};
};

}  // namespace hedr
