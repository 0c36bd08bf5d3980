#include "radio/wire/text_line/text_clock.h"

#include <algorithm>

namespace hedr {
namespace {

constexpr double kLongestStep_s = 10.0;  // a robot that is slower is not driven
constexpr double kJitter_s = 0.1;
constexpr double kUsualStepsToBelieve = 4.0;  // some lines may be lost
constexpr double kUsualShare = 0.2;           // of a new step in the usual one
constexpr double kLeastRestart_s = 1.0;       // less far back is a wrong digit before
constexpr double kLongestGapOverWrap_s = 60.0;

}  // namespace

TextClock::Step TextClock::advance(double printed_s, std::optional<double> period_s) {
    const double elapsed_s = printed_s - last_s_;
    if (!started_) {
        started_ = true;
    } else if (period_s && elapsed_s < 0.0 && elapsed_s + *period_s <= kLongestGapOverWrap_s) {
        offset_s_ += *period_s;
    } else if (follows(elapsed_s)) {
        usual_step_s_ =
            usual_step_s_ ? *usual_step_s_ + kUsualShare * (elapsed_s - *usual_step_s_) : elapsed_s;
    } else if (expects_start_ || confirmsSuspect(printed_s)) {
        if (suspect_s_) usual_step_s_ = printed_s - *suspect_s_;
        if (elapsed_s < 0.0) offset_s_ = 0.0;
        accept(printed_s);
        return elapsed_s < 0.0 ? Step::kRestarted : Step::kGoesOn;
    } else {
        suspect_s_ = printed_s;
        return Step::kDoubtful;
    }
    accept(printed_s);
    return Step::kGoesOn;
}

bool TextClock::follows(double elapsed_s) const {
    const double longest_s =
        usual_step_s_ ? std::max(kJitter_s, kUsualStepsToBelieve * *usual_step_s_) : kLongestStep_s;
    return elapsed_s >= 0.0 && elapsed_s <= longest_s;
}

bool TextClock::confirmsSuspect(double printed_s) const {
    if (!suspect_s_) return false;
    const double step_s = printed_s - *suspect_s_;
    const double back_s = last_s_ - printed_s;
    return step_s >= 0.0 && step_s <= kLongestStep_s && (back_s < 0.0 || back_s >= kLeastRestart_s);
}

}  // namespace hedr
