#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/calibration/procedures.h"
#include "radio/receiver.h"

namespace hedr {

// Gathers what the sensors of one robot say for a calibration: a set for each start of the robot,
// for its counters and its gyro's angle begin anew with it; of closed drives, a set for each.
class SampleCollector {
  public:
    // `origin`: where they come from, for the record.
    SampleCollector(std::string origin, const Vehicle& believed)
        : origin_(std::move(origin)), input_{.vehicle = believed} {}

    void add(const std::vector<HeardSensors>& sensors);
    // The robot stands at its mark: there the first closed drive begins, and every other ends. What
    // came before the first mark is forgotten, and a drive on which the robot was restarted.
    void mark();
    void set(const ProcedureSettings& settings) { input_.settings = settings; }
    const ProcedureInput& input() const { return input_; }

  private:
    std::string origin_;
    ProcedureInput input_;
    std::optional<std::uint64_t> boot_{};
    std::optional<SampleSet> under_way_{};  // a closed drive from its mark on
    bool closed_drives_ = false;
};

}  // namespace hedr
