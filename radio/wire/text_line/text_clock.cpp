#include "radio/wire/text_line/text_clock.h"

namespace hedr {
namespace {

constexpr double kLongestGap_s = 10.0;
constexpr double kLongestGapOverWrap_s = 60.0;

bool follows(double now_s, double before_s) {
    return now_s >= before_s && now_s - before_s <= kLongestGap_s;
}

}  // namespace

TextClock::Step TextClock::advance(double printed_s, std::optional<double> period_s) {
    if (!started_) {
        started_ = true;
        accept(printed_s);
        return Step::kGoesOn;
    }
    const bool back = printed_s < last_s_;
    if (back && period_s && printed_s + *period_s - last_s_ <= kLongestGapOverWrap_s) {
        offset_s_ += *period_s;
        accept(printed_s);
        return Step::kGoesOn;
    }
    const bool believed = follows(printed_s, last_s_) || expects_start_ ||
                          (suspect_s_ && follows(printed_s, *suspect_s_));
    if (!believed) {
        suspect_s_ = printed_s;
        return Step::kDoubtful;
    }
    if (back) offset_s_ = 0.0;
    accept(printed_s);
    return back ? Step::kRestarted : Step::kGoesOn;
}

}  // namespace hedr
