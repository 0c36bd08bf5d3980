#pragma once

#include <cstdint>
#include <span>

#include "core/geometry/angle.h"
#include "core/simulation/scenario_setting.h"
#include "core/simulation/simulated_mission.h"

namespace hedr {

// The experiment of Zimoch, Giobazolias, Girousis, Mozhaev, "Investigating effects of sensor fusion
// of multiple combinations of sensors on robotic localisation uncertainty", University of Bristol,
// 2019: a Romi follows the line of a rectangle of 600 mm x 1,000 mm once, clockwise. Errors are put
// into what the software believes of its wheelbase, and into the wheels by a tape around them.
struct RomiRectangle {
    double wheelbase_error_m = 0.0;            // of the vehicle file
    double left_wheel_error_m = 0.0;           // of the real wheel's diameter
    double right_wheel_error_m = 0.0;          // the same
    double unevenness_m_sqrtm = 3e-4;          // rms error of a wheel's travel after one metre
    double gyro_bias_rad_s = radFromDeg(1.0);  // drawn from plus minus this
    double gyro_noise_rad_s_sqrthz = radFromDeg(0.01);
    double gyro_scale_error = 0.075;  // it overestimates turns
    double hard_iron = 12.0;          // microtesla, of the robot itself
    double soft_iron = 0.1;           // share by which its axes differ, and half of it crosswise
    double magnetic_noise = 0.4;      // microtesla rms per sample
    double disturbance = 18.0;        // microtesla, at the middle of the side beside iron
};

std::span<const ScenarioSetting<RomiRectangle>> settingsOf(const RomiRectangle& scenario);
SimulatedMission simulate(const RomiRectangle& scenario, std::uint64_t seed);

}  // namespace hedr
