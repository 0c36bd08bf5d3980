#include "ui/calibration/sample_collector.h"

namespace hedr {

void SampleCollector::add(const std::vector<HeardSensors>& sensors) {
    for (const HeardSensors& each : sensors) {
        if (boot_ != each.boot) input_.sets.push_back({origin_, {}});
        boot_ = each.boot;
        input_.sets.back().reports.push_back(each.report);
    }
}

}  // namespace hedr
