#include "radio/link/clock_echo.h"

#include <algorithm>
#include <cmath>

namespace hedr {

std::optional<TimeRequest> ClockEcho::requestIfDue(double now_s) {
    if (now_s < next_s_) return std::nullopt;
    next_s_ = now_s + kPeriod_s;
    const std::uint32_t token = ++last_token_;
    questions_[token % questions_.size()] = {token, now_s};
    return TimeRequest{token};
}

bool ClockEcho::hear(const TimeEchoReport& echo, double now_s, double clock_period_s) {
    Question& question = questions_[echo.token % questions_.size()];
    const double round_trip_s = now_s - question.asked_s;
    const bool asked = echo.token != 0 && question.token == echo.token;
    if (!asked || round_trip_s < 0.0 || round_trip_s > kPatience_s) return false;
    question = {};
    const double apart_s = echo.robot_time_s - (now_s - 0.5 * round_trip_s);
    const double offset_s =
        std::isinf(clock_period_s) ? apart_s : std::remainder(apart_s, clock_period_s);
    answers_[answer_count_++ % answers_.size()] = Answer{now_s, round_trip_s, offset_s};
    return true;
}

// Its answers to what was asked before are not waited for either.
void ClockEcho::forgetAnswers() {
    questions_ = {};
    answers_ = {};
    answer_count_ = 0;
}

std::optional<double> ClockEcho::roundTrip_s(double now_s) const {
    if (answer_count_ == 0) return std::nullopt;
    const auto& last = answers_[(answer_count_ - 1) % answers_.size()];
    if (now_s - last->heard_s > kPatience_s) return std::nullopt;
    return last->round_trip_s;
}

std::optional<double> ClockEcho::offset_s() const {
    const auto slowness = [](const std::optional<Answer>& answer) {
        return answer ? answer->round_trip_s : kPatience_s;
    };
    const auto quickest = std::ranges::min_element(answers_, {}, slowness);
    return *quickest ? std::optional((*quickest)->offset_s) : std::nullopt;
}

}  // namespace hedr
