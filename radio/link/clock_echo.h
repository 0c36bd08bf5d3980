#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "core/robot/report.h"
#include "radio/wire/request.h"

namespace hedr {

// Asks the robot for its time once a second: how long a question and its answer take, and how far
// its clock is from ours. Times are seconds of the receive clock.
class ClockEcho {
  public:
    static constexpr double kPeriod_s = 1.0;
    // An answer that took longer is a late one to an earlier question.
    static constexpr double kPatience_s = 5.0;

    // The question that is due now.
    std::optional<TimeRequest> requestIfDue(double now_s);
    // `clock_period_s`: robot time wraps at it; infinite: never. False for an answer to nothing
    // that was asked.
    bool hear(const TimeEchoReport& echo, double now_s, double clock_period_s);

    // The robot was restarted: its clock is another one.
    void forgetAnswers();

    // Of the last answer; none where it is older than kPatience_s.
    std::optional<double> roundTrip_s(double now_s) const;
    // Robot time less receive time, as the quickest of the last answers tells: the way there and
    // the way back differ least in it. In a clock that wraps, within half a period of zero.
    std::optional<double> offset_s() const;

  private:
    struct Question {
        std::uint32_t token = 0;
        double asked_s = 0.0;
    };
    struct Answer {
        double heard_s = 0.0;
        double round_trip_s = 0.0;
        double offset_s = 0.0;
    };

    double next_s_ = 0.0;
    std::uint32_t last_token_ = 0;
    std::array<Question, 8> questions_{};
    std::array<std::optional<Answer>, 16> answers_{};
    std::size_t answer_count_ = 0;
};

}  // namespace hedr
