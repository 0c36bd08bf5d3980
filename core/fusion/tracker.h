#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/fusion/estimators.h"
#include "core/robot/motion.h"
#include "core/track/track.h"

namespace hedr {

// Runs several estimators side by side on the reports of one robot: the same engine behind the live
// map, the command line and a mission that is computed again.
class Tracker {
  public:
    struct Setup {
        Vehicle vehicle{};
        FusionConfig config{};
        Pose<World> start{};
        double clock_period_s = MotionBuilder::kNoWrap;
        std::vector<const EstimatorEntry*> estimators{};
    };

    explicit Tracker(const Setup& setup);

    // True if the report moved time on: then every estimator has a new point.
    bool add(const SensorReport& report);
    // The heading of one corridor, for the estimators that use it; none: they learn it.
    void setDirection(std::optional<double> direction_rad);
    // The robot says that it was restarted.
    void restart() { motions_.restart(); }
    // The robot says that it was not restarted in the gap that the next report ends.
    void goOnAfterGap() { motions_.goOnAfterGap(); }

    std::size_t size() const { return runs_.size(); }
    std::string_view name(std::size_t index) const { return runs_[index].entry->name; }
    TrackPoint point(std::size_t index) const;
    const Motion& motion() const { return motion_; }  // the last one
    double driven_m() const { return driven_m_; }
    const HedrStatus* hedrStatus() const;            // nullptr without hedr among the estimators
    std::optional<BayesStatus> bayesStatus() const;  // none without hedr_bayes among them
    const MotionBuilder& motions() const { return motions_; }

  private:
    struct Run {
        const EstimatorEntry* entry;
        AnyEstimator estimator;
    };

    MotionBuilder motions_;
    Motion motion_{};
    double driven_m_ = 0.0;
    std::vector<Run> runs_;
    bool begun_ = false;
};

// All estimators of the table that can work with what this robot reports and its file says.
std::vector<const EstimatorEntry*> estimatorsFor(const EstimatorInputs& given);

}  // namespace hedr
