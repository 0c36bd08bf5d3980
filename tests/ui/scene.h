#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "core/site/plan.h"
#include "radio/live_batch.h"
#include "ui/clock.h"

namespace hedr::test {

using TimePoint = ReceiveClock::time_point;

inline TimePoint atSecond(double seconds) {
    return TimePoint{} + std::chrono::duration_cast<ReceiveClock::duration>(
                             std::chrono::duration<double>(10'000.0 + seconds));
}

// A clock that stands still until it is told otherwise.
class HandClock {
  public:
    void set(double seconds) { *now_s_ = seconds; }
    Clock clock() const;

  private:
    std::shared_ptr<double> now_s_ = std::make_shared<double>(0.0);
};

// A floor with two rows of rooms, three blocks and corridors between them, as grey lines.
PlanImage samplePlan();
PlanImage colouredPlan();

// A drive of 165 s through that floor's corridors at 0.62 m/s, reported after `seconds` of it.
LiveBatch sampleBatch(double seconds, double from_seconds = -1.0);
// The same drive as an estimator sees it whose heading goes wrong.
std::vector<TrackPoint> drift(double seconds, double error_rad_s);
inline constexpr double kDrive_s = 300.0;

}  // namespace hedr::test
