#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/calibration/estimate.h"
#include "core/calibration/evidence.h"
#include "core/calibration/proof.h"
#include "core/calibration/track_width.h"
#include "core/robot/vehicle.h"

namespace hedr {

enum class Verdict : unsigned char {
    kAccepted,   // found, proven to be better
    kUnchanged,  // the old values are as good as the samples can tell
    kNotProven,  // found, but no held-out data say that it is better
    kRefused     // the samples are no good, or held-out data say that it is worse
};

// A number of the vehicle file, as it was and as it was found.
struct FoundParameter {
    std::string_view key;         // of the vehicle file, in its unit: "wheelbase_m"
    std::optional<double> was{};  // none: the file did not say
    Estimate now{};
    // Found, but not surely another one than the old value, which the file keeps.
    bool stays = false;
    // Nothing was found about it: it goes with the others, and `now` has only their error.
    bool follows = false;
};

// What one procedure says of one robot: the same for the page in the window, the command line and
// the robot's history.
struct Calibration {
    std::string_view procedure;
    std::vector<FoundParameter> found{};
    std::vector<CalibrationStep> steps{};
    CalibrationProgress progress{};
    std::vector<TrackWidth> track_widths{};  // the slowest turns first; empty: not looked for
    std::vector<EvidenceFigure> figures{};
    std::vector<EvidencePlot> plots{};
    std::vector<std::string> remarks{};  // what the operator should know, one sentence each
    std::optional<Proof> proof{};
    Verdict verdict = Verdict::kNotProven;
    std::string reason{};  // of the verdict, one sentence
};

// The one way to a verdict. Accepted is only what held-out data call better (99 %) and what is
// nearer to the truth than the old values by its own uncertainty (99 %), not only different from
// them; where there was no old value, the proof has to have one to compare with (no correction at
// all).
Calibration judged(Calibration calibration);

// A verdict for samples that are no good, whatever was found in them; what is no number goes.
Calibration refused(Calibration calibration, std::string reason);

// The vehicle with the values found that do not stay. Errors: those of setVehicleNumber.
Result<Vehicle> calibrated(const Vehicle& believed, const Calibration& calibration);

}  // namespace hedr
