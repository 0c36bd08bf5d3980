#pragma once

#include <optional>
#include <span>

#include "core/calibration/calibration.h"
#include "core/calibration/gyro/warmup_fit.h"
#include "core/calibration/gyro/warmup_forecast.h"
#include "core/calibration/gyro/warmup_record.h"
#include "core/calibration/whiteness.h"
#include "core/geometry/angle.h"
#include "core/robot/report.h"
#include "core/robot/vehicle.h"

namespace hedr {

struct WarmupOptions {
    double on_before_s = 0.0;                  // switched on so long before the record begins
    double matters_rad_s = radFromDeg(0.005);  // a slower drift matters to nobody: 0.3° in a minute
    RoomTemperature room = RoomTemperature::kSteady;
};

struct Warmup {
    double stood_s = 0.0;
    double on_s = 0.0;                     // since it was switched on
    std::optional<WarmupFit> fit{};        // none: too little
    Whiteness whiteness{};                 // of what the fit leaves
    bool warms_up = false;                 // the bias changes, and enough to matter
    bool known = false;                    // the curve bends enough to tell its time constant
    bool room_shows = false;               // a steady room is not what the record looks like
    bool follows = false;                  // the curve: what it leaves is noise, the room included
    std::optional<double> known_in_s{};    // as far as can be said
    std::optional<double> settled_in_s{};  // until what is left of the drift does not matter
    std::optional<WarmupCost> cost{};      // as soon as the curve is seen to bend
    std::optional<WarmupMotion> motion{};  // what ended the standing
    Calibration calibration{};
};

// The drift of a gyro that has been standing since it was switched on: C1 (1 - exp(-t / T)) + C2,
// as Barshan and Durrant-Whyte 1994 fit it, "gyro_drift_c1_rad_s" and its two siblings of the
// vehicle file. Refused, with the reason, are a gyro that is warm, one whose drift is no such curve
// (the residuals are not white) or cannot be told yet, a room that changed although it was told to
// be steady, a gyro that was on for too long before, and the usual bad readings. Motion ends the
// record.
Warmup calibrateWarmup(std::span<const SensorReport> reports, const Vehicle& believed,
                       const WarmupOptions& options = {});

}  // namespace hedr
