#include "ui/calibration/sample_collector.h"

namespace hedr {

void SampleCollector::add(const std::vector<HeardSensors>& sensors) {
    for (const HeardSensors& each : sensors) {
        const bool starts_anew = boot_ != each.boot;
        const bool restarted = boot_ && starts_anew;
        boot_ = each.boot;
        if (closed_drives_) {
            if (restarted) under_way_.reset();
            if (under_way_) under_way_->reports.push_back(each.report);
            continue;
        }
        if (starts_anew) input_.sets.push_back({origin_, {}});
        input_.sets.back().reports.push_back(each.report);
    }
}

void SampleCollector::mark() {
    if (!closed_drives_) input_.sets.clear();
    closed_drives_ = true;
    if (under_way_) input_.sets.push_back(std::move(*under_way_));
    under_way_ = SampleSet{origin_, {}};
}

}  // namespace hedr
