#pragma once

#include <optional>

namespace hedr {

// Makes robot times of the times that a robot prints: millis() and micros(), which wrap at 2^32,
// run on. Nothing guards a digit of a text line, so what is no usual step counts only if the next
// line confirms it.
class TextClock {
  public:
    enum class Step {
        kGoesOn,
        kRestarted,  // the robot's time began again
        kDoubtful,   // a leap, forth or back, that no other line confirms yet
    };

    // `period_s`: the printed time wraps at it.
    Step advance(double printed_s, std::optional<double> period_s);

    // The robot said that it begins: the next time need not be near the last.
    void expectStart() { expects_start_ = true; }

    double time_s() const { return time_s_; }

  private:
    bool follows(double elapsed_s) const;
    bool confirmsSuspect(double printed_s) const;
    void accept(double printed_s) {
        last_s_ = printed_s;
        time_s_ = printed_s + offset_s_;
        suspect_s_.reset();
        expects_start_ = false;
    }

    bool started_ = false;
    bool expects_start_ = false;
    double last_s_ = 0.0;    // as printed
    double offset_s_ = 0.0;  // whole periods
    double time_s_ = 0.0;
    std::optional<double> usual_step_s_{};
    std::optional<double> suspect_s_{};
};

}  // namespace hedr
