#include "core/simulation/umbmark_squares.h"

#include <array>
#include <cmath>
#include <vector>

#include "core/geometry/angle.h"
#include "core/simulation/manoeuvre.h"
#include "core/simulation/wheels.h"

namespace hedr {

namespace {

using Setting = ScenarioSetting<UmbmarkSquares>;

// clang-format off
constexpr std::array kSettings{
    Setting{"side_m", "of the squares", [](UmbmarkSquares& s) -> double& { return s.side_m; }, 1.0, 0.5, 50.0},
    Setting{"diameter_ratio", "E_d, right wheel over left", [](UmbmarkSquares& s) -> double& { return s.diameter_ratio; }, 1.0, 0.9, 1.1},
    Setting{"wheelbase_ratio", "E_b, real wheelbase over the vehicle file's", [](UmbmarkSquares& s) -> double& { return s.wheelbase_ratio; }, 1.0, 0.8, 1.25},
    Setting{"unevenness_mm_sqrtm", "rms error of a wheel's travel after one metre", [](UmbmarkSquares& s) -> double& { return s.unevenness_m_sqrtm; }, 1e-3, 0.0, 10.0},
    Setting{"speed_m_s", "along the sides", [](UmbmarkSquares& s) -> double& { return s.speed_m_s; }, 1.0, 0.05, 1.0},
    Setting{"pause_s", "before and after each square", [](UmbmarkSquares& s) -> double& { return s.pause_s; }, 1.0, 3.0, 60.0},
};
// clang-format on

constexpr VehicleGeometry kBelieved{0.150, 0.150, 0.340, 2000.0};
constexpr double kRate_hz = 10.0;
constexpr double kCornerPause_s = 0.5;

// The mean of the wheels' diameters is as believed.
VehicleGeometry realGeometry(const UmbmarkSquares& scenario) {
    VehicleGeometry real = kBelieved;
    real.left_wheel_diameter_m *= 2.0 / (scenario.diameter_ratio + 1.0);
    real.right_wheel_diameter_m *= 2.0 / (1.0 / scenario.diameter_ratio + 1.0);
    real.wheelbase_m *= scenario.wheelbase_ratio;
    return real;
}

// What the robot believes that it drives.
std::vector<MotionStep> squares(const UmbmarkSquares& scenario) {
    std::vector<Manoeuvre> way;
    for (int square = 0; square < 2 * kUmbmarkSquaresEachWay; ++square) {
        const double side = square < kUmbmarkSquaresEachWay ? -1.0 : 1.0;
        way.push_back({.pause_s = scenario.pause_s});
        for (int corner = 0; corner < 4; ++corner) {
            way.push_back({.distance_m = scenario.side_m});
            way.push_back({.pause_s = kCornerPause_s});
            way.push_back({.turn_rad = side * 0.5 * kPi});
            if (corner < 3) way.push_back({.pause_s = kCornerPause_s});
        }
    }
    way.push_back({.pause_s = scenario.pause_s});
    return stepsOf(
        way, {.speed_m_s = scenario.speed_m_s, .turn_rate_rad_s = radFromDeg(20.0), .ramp_s = 1.0},
        kRate_hz);
}

}  // namespace

std::span<const ScenarioSetting<UmbmarkSquares>> settingsOf(const UmbmarkSquares&) {
    return kSettings;
}

SimulatedMission simulate(const UmbmarkSquares& scenario, std::uint64_t seed) {
    Random random(seed);
    SimulatedMission mission{.vehicle = {.name = "labmate",
                                         .geometry = kBelieved,
                                         .heading_source = HeadingSource::kEncoders,
                                         .max_speed_m_s = 1.5}};
    const VehicleGeometry real = realGeometry(scenario);
    double left_m = 0.0;
    double right_m = 0.0;
    Pose<World> pose;
    const auto note = [&] {
        const double t_s = static_cast<double>(mission.truth.size()) / kRate_hz;
        mission.sensors.push_back(
            {.robot_time_s = t_s, .odometry = wheelCounts(kBelieved, left_m, right_m)});
        mission.truth.push_back({t_s, pose});
    };
    const auto rolled = [&](double believed_m, double diameter_m) {
        const double unevenness = scenario.unevenness_m_sqrtm * std::sqrt(std::abs(believed_m));
        return believed_m * diameter_m / kBelieved.left_wheel_diameter_m +
               unevenness * random.normal();
    };
    note();
    for (const MotionStep& step : squares(scenario)) {
        const double half_turn_m = 0.5 * step.turn_rad * kBelieved.wheelbase_m;
        const double left = rolled(step.distance_m - half_turn_m, real.left_wheel_diameter_m);
        const double right = rolled(step.distance_m + half_turn_m, real.right_wheel_diameter_m);
        left_m += step.distance_m - half_turn_m;
        right_m += step.distance_m + half_turn_m;
        pose = after(pose, {0.5 * (left + right), (right - left) / real.wheelbase_m});
        note();
    }
    return mission;
}

}  // namespace hedr
