#include "core/simulation/romi_rectangle.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/simulation/manoeuvre.h"
#include "core/simulation/wheels.h"

namespace hedr {

namespace {

using Setting = ScenarioSetting<RomiRectangle>;
constexpr double kMm = 1e-3;
constexpr double kDeg = radFromDeg(1.0);

// clang-format off
constexpr std::array kSettings{
    Setting{"wheelbase_error_mm", "of the wheelbase in the vehicle file", [](RomiRectangle& s) -> double& { return s.wheelbase_error_m; }, kMm, -20.0, 20.0},
    Setting{"left_wheel_error_mm", "of the real left wheel's diameter", [](RomiRectangle& s) -> double& { return s.left_wheel_error_m; }, kMm, -10.0, 10.0},
    Setting{"right_wheel_error_mm", "of the real right wheel's diameter", [](RomiRectangle& s) -> double& { return s.right_wheel_error_m; }, kMm, -10.0, 10.0},
    Setting{"unevenness_mm_sqrtm", "rms error of a wheel's travel after one metre", [](RomiRectangle& s) -> double& { return s.unevenness_m_sqrtm; }, kMm, 0.0, 10.0},
    Setting{"gyro_bias_deg_s", "largest bias", [](RomiRectangle& s) -> double& { return s.gyro_bias_rad_s; }, kDeg, 0.0, 20.0},
    Setting{"gyro_noise_deg_sqrts", "angle random walk", [](RomiRectangle& s) -> double& { return s.gyro_noise_rad_s_sqrthz; }, kDeg, 0.0, 1.0},
    Setting{"gyro_scale_error", "share of the rate", [](RomiRectangle& s) -> double& { return s.gyro_scale_error; }, 1.0, -0.5, 0.5},
    Setting{"hard_iron_ut", "field of the robot itself, microtesla", [](RomiRectangle& s) -> double& { return s.hard_iron; }, 1.0, 0.0, 100.0},
    Setting{"soft_iron", "share by which the magnetometer's axes differ", [](RomiRectangle& s) -> double& { return s.soft_iron; }, 1.0, 0.0, 0.5},
    Setting{"magnetic_noise_ut", "rms of a sample, microtesla", [](RomiRectangle& s) -> double& { return s.magnetic_noise; }, 1.0, 0.0, 10.0},
    Setting{"disturbance_ut", "of the field on one side of the rectangle, microtesla", [](RomiRectangle& s) -> double& { return s.disturbance; }, 1.0, -50.0, 50.0},
};
// clang-format on

constexpr VehicleGeometry kRomi{0.070, 0.070, 0.140, 1440.0};
constexpr double kRate_hz = 100.0;
constexpr double kStanding_s = 2.5;  // 50 readings of the gyro, one every 50 ms
constexpr double kAcross_m = 0.6;
constexpr double kAlong_m = 1.0;
// About 2,000 samples for the whole rectangle.
constexpr Pace kPace{.speed_m_s = 0.25, .turn_rate_rad_s = radFromDeg(75.0), .ramp_s = 0.2};

constexpr double kNorth_rad = radFromDeg(90.0);  // along the first side
constexpr double kHorizontalField = 20.0;        // microtesla
constexpr double kDownwardField = 45.0;
constexpr Point<World> kIron{kAcross_m, 0.5 * kAlong_m};
constexpr double kIronReach_m = 0.3;

std::vector<MotionStep> rectangle() {
    std::vector<Manoeuvre> way{{.pause_s = kStanding_s}};
    for (const double side_m : {kAlong_m, kAcross_m, kAlong_m, kAcross_m}) {
        way.push_back({.distance_m = side_m});
        way.push_back({.turn_rad = -0.5 * kPi});
    }
    way.push_back({.pause_s = 1.0});
    return stepsOf(way, kPace, kRate_hz);
}

// A magnetometer in a robot of iron, x ahead and y left.
class Magnetometer {
  public:
    explicit Magnetometer(const RomiRectangle& scenario) : scenario_(scenario) {}

    MagneticField measure(const Pose<World>& pose, Random& random) const {
        const Vector<World> from_iron = pose.position - kIron;
        const double near = std::exp(-(from_iron.x * from_iron.x + from_iron.y * from_iron.y) /
                                     (kIronReach_m * kIronReach_m));
        // The iron beside the way pulls the field to the east.
        const double east = scenario_.disturbance * near;
        const double off_north = pose.heading_rad - kNorth_rad;
        const double c = std::cos(off_north);
        const double s = std::sin(off_north);
        const double ahead = kHorizontalField * c - east * s;
        const double left = -kHorizontalField * s - east * c;
        const auto noise = [&] { return scenario_.magnetic_noise * random.normal(); };
        return {.x = centreX() + (1.0 + scenario_.soft_iron) * ahead + crosswise() * left + noise(),
                .y = centreY() + crosswise() * ahead + (1.0 - scenario_.soft_iron) * left + noise(),
                .z = -kDownwardField + noise()};
    }

    // As a full rotation far from the iron beside the way shows it.
    MagnetometerRange range() const {
        return {.centre_x = centreX(),
                .centre_y = centreY(),
                .range_x = kHorizontalField * std::hypot(1.0 + scenario_.soft_iron, crosswise()),
                .range_y = kHorizontalField * std::hypot(1.0 - scenario_.soft_iron, crosswise())};
    }

  private:
    double centreX() const { return scenario_.hard_iron; }
    double centreY() const { return -0.6 * scenario_.hard_iron; }
    double crosswise() const { return 0.5 * scenario_.soft_iron; }

    RomiRectangle scenario_;
};

Vehicle believed(const RomiRectangle& scenario) {
    VehicleGeometry geometry = kRomi;
    geometry.wheelbase_m += scenario.wheelbase_error_m;
    return {.name = "romi",
            .geometry = geometry,
            .gyro_noise_rad_s_sqrthz = scenario.gyro_noise_rad_s_sqrthz,
            .magnetometer = Magnetometer(scenario).range(),
            .max_speed_m_s = 1.0};
}

}  // namespace

std::span<const ScenarioSetting<RomiRectangle>> settingsOf(const RomiRectangle&) {
    return kSettings;
}

SimulatedMission simulate(const RomiRectangle& scenario, std::uint64_t seed) {
    Random random(seed);
    SimulatedMission mission{.vehicle = believed(scenario), .start = {{}, kNorth_rad}};
    VehicleGeometry real = kRomi;
    real.left_wheel_diameter_m += scenario.left_wheel_error_m;
    real.right_wheel_diameter_m += scenario.right_wheel_error_m;
    Wheels wheels(real, scenario.unevenness_m_sqrtm);
    const Magnetometer magnetometer(scenario);
    const double bias = random.uniform(-scenario.gyro_bias_rad_s, scenario.gyro_bias_rad_s);
    const double noise = scenario.gyro_noise_rad_s_sqrthz * std::sqrt(kRate_hz);
    Pose<World> pose = mission.start;
    const auto note = [&](double turn_rad) {
        const double t_s = static_cast<double>(mission.truth.size()) / kRate_hz;
        const double rate = (1.0 + scenario.gyro_scale_error) * turn_rad * kRate_hz;
        mission.sensors.push_back({.robot_time_s = t_s,
                                   .odometry = wheels.ticks(),
                                   .gyro = GyroRate{rate + bias + noise * random.normal()},
                                   .magnetic_field = magnetometer.measure(pose, random)});
        mission.truth.push_back({t_s, pose});
    };
    note(0.0);
    for (const MotionStep& step : rectangle()) {
        pose = after(pose, step);
        wheels.move(step.distance_m, step.turn_rad, random);
        note(step.turn_rad);
    }
    return mission;
}

}  // namespace hedr
