#pragma once

#include <cstdint>
#include <vector>

#include "core/simulation/random.h"
#include "radio/receiver.h"
#include "ui/calibration/calibration_view.h"
#include "ui/calibration/procedure_list.h"

namespace hedr::test {

// Squares driven for UMBmark: `counter_clockwise` of the five to the left are done.
CalibrationView squaresView(int counter_clockwise);
// The same at its end, as it may be decided.
CalibrationView decidedView(Verdict verdict);
// Nothing done yet, nothing known.
CalibrationView emptyView();
// A gyro that warms up: two plots with many samples, figures with intervals, many remarks.
CalibrationView warmUpView();
// An Allan deviation with its band, on two logarithmic axes.
EvidencePlot allanPlot();
// Words longer than anybody should write, and more of everything than fits.
CalibrationView wordyView();

std::vector<ProcedureEntry> procedureEntries();

// What a standing robot says, at 50 Hz; its gyro has a bias of 0.9 °/s.
std::vector<HeardSensors> standingSensors(double begin_s, double seconds, Random& random,
                                          std::uint64_t boot = 1);

}  // namespace hedr::test
