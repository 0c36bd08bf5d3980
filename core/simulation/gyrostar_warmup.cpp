#include "core/simulation/gyrostar_warmup.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/simulation/manoeuvre.h"
#include "core/simulation/wheels.h"

namespace hedr {

namespace {

using Setting = ScenarioSetting<GyrostarWarmup>;
constexpr double kDeg = radFromDeg(1.0);

// clang-format off
constexpr std::array kSettings{
    Setting{"c1_deg_s", "how much the bias changes while the gyro warms up", [](GyrostarWarmup& s) -> double& { return s.c1_rad_s; }, kDeg, -10.0, 10.0},
    Setting{"c2_deg_s", "bias of the cold gyro", [](GyrostarWarmup& s) -> double& { return s.c2_rad_s; }, kDeg, -10.0, 10.0},
    Setting{"time_constant_s", "of the warming up", [](GyrostarWarmup& s) -> double& { return s.time_constant_s; }, 1.0, 1.0, 1e5},
    Setting{"drift_spread", "share by which these differ from the vehicle file's", [](GyrostarWarmup& s) -> double& { return s.drift_spread; }, 1.0, 0.0, 0.5},
    Setting{"gyro_noise_deg_s", "rms of a sample of 30 ms", [](GyrostarWarmup& s) -> double& { return s.gyro_noise_rad_s; }, kDeg, 0.0, 10.0},
    Setting{"warm_for_s", "how long the gyro has been on before", [](GyrostarWarmup& s) -> double& { return s.warm_for_s; }, 1.0, 0.0, 1e5},
    Setting{"standing_start_s", "time to measure the gyro's bias", [](GyrostarWarmup& s) -> double& { return s.standing_start_s; }, 1.0, 0.0, 7200.0},
    Setting{"drive_s", "length of the drive", [](GyrostarWarmup& s) -> double& { return s.drive_s; }, 1.0, 1.0, 28800.0},
};
// clang-format on

constexpr double kStep_s = 0.03;
// 19 tonnes, all wheels steered. The paper's vehicle had radar; wheels with encoders are ours.
constexpr VehicleGeometry kCarrier{1.6, 1.6, 3.0, 2000.0};
constexpr double kUnevenness_m = 0.005;  // rms error of a wheel's travel after one metre
constexpr Pace kPace{.speed_m_s = 2.0, .turn_rate_rad_s = radFromDeg(12.0), .ramp_s = 3.0};
constexpr double kLine_m = 40.0;

// Forth and back along a line, then a trajectory of its own.
std::vector<MotionStep> drive(const GyrostarWarmup& scenario, Random& random) {
    std::vector<Manoeuvre> way{
        {.pause_s = scenario.standing_start_s}, {.distance_m = kLine_m}, {.distance_m = -kLine_m}};
    std::vector<MotionStep> steps = stepsOf(way, kPace, 1.0 / kStep_s);
    const auto samples = static_cast<std::size_t>(
        std::ceil((scenario.standing_start_s + scenario.drive_s) / kStep_s));
    while (steps.size() < samples) {
        const double side = random.uniform() < 0.3 ? -1.0 : 1.0;
        const double turn = radFromDeg(random.uniform(45.0, 120.0));
        const double radius_m = random.uniform(10.0, 20.0);
        way = {{.distance_m = random.uniform(10.0, 60.0)},
               {.distance_m = radius_m * turn, .turn_rad = side * turn}};
        const std::vector<MotionStep> more = stepsOf(way, kPace, 1.0 / kStep_s);
        steps.insert(steps.end(), more.begin(), more.end());
    }
    steps.resize(samples);
    return steps;
}

class WarmingGyro {
  public:
    WarmingGyro(const GyrostarWarmup& scenario, Random& random)
        : noise_(scenario.gyro_noise_rad_s) {
        const auto today = [&](double value) {
            return value * (1.0 + random.uniform(-scenario.drift_spread, scenario.drift_spread));
        };
        const double c1 = today(scenario.c1_rad_s);
        const double c2 = today(scenario.c2_rad_s);
        const double time_constant_s = today(scenario.time_constant_s);
        warm_rad_s_ = c1 + c2;
        keep_ = time_constant_s / (time_constant_s + kStep_s);  // Eq. (3)
        bias_rad_s_ = warm_rad_s_ - c1 * std::exp(-scenario.warm_for_s / time_constant_s);
    }

    GyroRate measure(double rate_rad_s, Random& random) {
        const double measured = rate_rad_s + bias_rad_s_ + noise_ * random.normal();
        bias_rad_s_ = keep_ * bias_rad_s_ + (1.0 - keep_) * warm_rad_s_;
        return {measured};
    }

  private:
    double noise_;
    double warm_rad_s_ = 0.0;
    double keep_ = 0.0;
    double bias_rad_s_ = 0.0;
};

}  // namespace

std::span<const ScenarioSetting<GyrostarWarmup>> settingsOf(const GyrostarWarmup&) {
    return kSettings;
}

SimulatedMission simulate(const GyrostarWarmup& scenario, std::uint64_t seed) {
    Random random(seed);
    SimulatedMission mission{
        .vehicle = {.name = "carrier",
                    .geometry = kCarrier,
                    .gyro_noise_rad_s_sqrthz = scenario.gyro_noise_rad_s * std::sqrt(kStep_s),
                    .gyro_drift =
                        GyroDrift{scenario.c1_rad_s, scenario.c2_rad_s, scenario.time_constant_s}}};
    WarmingGyro gyro(scenario, random);
    Wheels wheels(kCarrier, kUnevenness_m);
    Pose<World> pose;
    const auto note = [&](double turn_rad) {
        const double t_s = static_cast<double>(mission.truth.size()) * kStep_s;
        mission.sensors.push_back({.robot_time_s = t_s,
                                   .odometry = wheels.ticks(),
                                   .gyro = gyro.measure(turn_rad / kStep_s, random)});
        mission.truth.push_back({t_s, pose});
    };
    note(0.0);
    for (const MotionStep& step : drive(scenario, random)) {
        pose = after(pose, step);
        wheels.move(step.distance_m, step.turn_rad, random);
        note(step.turn_rad);
    }
    return mission;
}

}  // namespace hedr
