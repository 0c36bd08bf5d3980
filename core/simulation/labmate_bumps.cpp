#include "core/simulation/labmate_bumps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/simulation/manoeuvre.h"
#include "core/simulation/wheels.h"

namespace hedr {

namespace {

using Setting = ScenarioSetting<LabmateBumps>;
constexpr double kDeg = radFromDeg(1.0);

// clang-format off
constexpr std::array kSettings{
    Setting{"residual_6mm_deg", "left of a bump of 6 mm", [](LabmateBumps& s) -> double& { return s.residual_6mm_rad; }, kDeg, 0.0, 5.0},
    Setting{"residual_9mm_deg", "left of a bump of 9 mm", [](LabmateBumps& s) -> double& { return s.residual_9mm_rad; }, kDeg, 0.0, 5.0},
    Setting{"residual_12mm_deg", "left of a bump of 12 mm", [](LabmateBumps& s) -> double& { return s.residual_12mm_rad; }, kDeg, 0.0, 5.0},
    Setting{"swerve_deg", "to and fro at a bump, seen by the encoders too", [](LabmateBumps& s) -> double& { return s.swerve_rad; }, kDeg, 0.0, 5.0},
    Setting{"held_share", "of its speed that a wheel loses at a bump until it climbs", [](LabmateBumps& s) -> double& { return s.held_share; }, 1.0, 0.05, 1.0},
    Setting{"gyro_drift_deg_s", "of the gyro, to either side", [](LabmateBumps& s) -> double& { return s.gyro_drift_rad_s; }, kDeg, 0.0, 1.0},
    Setting{"gyro_noise_deg_sqrts", "angle random walk", [](LabmateBumps& s) -> double& { return s.gyro_noise_rad_s_sqrthz; }, kDeg, 0.0, 1.0},
    Setting{"unevenness_mm_sqrtm", "rms error of a wheel's travel after one metre", [](LabmateBumps& s) -> double& { return s.unevenness_m_sqrtm; }, 1e-3, 0.0, 10.0},
};
// clang-format on

constexpr VehicleGeometry kLabmate{0.150, 0.150, 0.340, 2000.0};
constexpr double kDuration_s = 140.0;
constexpr double kSpeed_m_s = 0.1;
constexpr double kRate_hz = 10.0;
constexpr int kStepsPerSample = 20;
constexpr std::size_t kBumps = 15;
constexpr double kFirstBump_m = 0.5;
constexpr double kBumpEvery_m = 0.9;
constexpr double kBumpJitter_m = 0.05;
constexpr double kSwerve_m = 0.08;  // twice the square root of 2 x 9 mm x 75 mm, about

struct Bump {
    double at_m = 0.0;
    double lost_m = 0.0;      // of the right wheel's way
    double swerve_rad = 0.0;  // towards the bump at most
};

std::array<Bump, kBumps> bumpsOf(const LabmateBumps& scenario, Random& random) {
    struct Cable {
        double residual_rad;
        double share_of_9mm;
    };
    const std::array cables{Cable{scenario.residual_6mm_rad, 2.0 / 3.0},
                            Cable{scenario.residual_9mm_rad, 1.0},
                            Cable{scenario.residual_12mm_rad, 4.0 / 3.0}};
    std::array<Bump, kBumps> bumps;
    for (std::size_t i = 0; i < kBumps; ++i) {
        bumps[i].at_m = kFirstBump_m + kBumpEvery_m * static_cast<double>(i) +
                        random.uniform(-kBumpJitter_m, kBumpJitter_m);
        const Cable& cable = cables[i / 5];
        bumps[i].lost_m = cable.residual_rad * kLabmate.wheelbase_m;
        bumps[i].swerve_rad = cable.share_of_9mm * scenario.swerve_rad;
    }
    return bumps;
}

// Towards the bump and back, `way_m` after it was struck.
double swerve(const Bump& bump, double way_m) {
    const double share = std::clamp(way_m / kSwerve_m, 0.0, 1.0);
    return -16.0 * bump.swerve_rad * share * share * (1.0 - share) * (1.0 - share);
}

// The robot on the floor: what its encoders count, and where it really is.
class Labmate {
  public:
    Labmate(const LabmateBumps& scenario, Random& random)
        : scenario_(scenario), random_(random), bumps_(bumpsOf(scenario, random)) {}

    void drive(double way_m) {
        const double before = encoderTurn();
        driven_m_ += way_m;
        const double half_turn_m = 0.5 * (encoderTurn() - before) * kLabmate.wheelbase_m;
        const double left = way_m - half_turn_m;
        const double right = way_m + half_turn_m;
        left_encoder_m_ += left;
        right_encoder_m_ += right;
        const double real_left = left + unevenness(left);
        const double real_right = right - lost(right) + unevenness(right);
        pose_ = after(pose_, {0.5 * (real_left + real_right),
                              (real_right - real_left) / kLabmate.wheelbase_m});
    }
    const Pose<World>& pose() const { return pose_; }
    WheelTicks ticks() const { return wheelCounts(kLabmate, left_encoder_m_, right_encoder_m_); }

  private:
    double encoderTurn() const {
        double turn = 0.0;
        for (const Bump& bump : bumps_) turn += swerve(bump, driven_m_ - bump.at_m);
        return turn;
    }
    double unevenness(double way_m) {
        return scenario_.unevenness_m_sqrtm * std::sqrt(std::abs(way_m)) * random_.normal();
    }
    double lost(double way_m) {
        for (Bump& bump : bumps_) {
            if (driven_m_ < bump.at_m || bump.lost_m == 0.0) continue;
            const double now = std::min(bump.lost_m, scenario_.held_share * std::max(way_m, 0.0));
            bump.lost_m -= now;
            return now;
        }
        return 0.0;
    }

    LabmateBumps scenario_;
    Random& random_;
    std::array<Bump, kBumps> bumps_;
    double driven_m_ = 0.0;
    double left_encoder_m_ = 0.0;
    double right_encoder_m_ = 0.0;
    Pose<World> pose_{};
};

}  // namespace

std::span<const ScenarioSetting<LabmateBumps>> settingsOf(const LabmateBumps&) { return kSettings; }

SimulatedMission simulate(const LabmateBumps& scenario, std::uint64_t seed) {
    Random random(seed);
    // Its bias was taken off before the run; the drift is what is left.
    SimulatedMission mission{
        .vehicle = {.name = "labmate",
                    .geometry = kLabmate,
                    .gyro_bias_rad_s = 0.0,
                    .gyro_noise_rad_s_sqrthz = scenario.gyro_noise_rad_s_sqrthz,
                    .max_speed_m_s = 1.5}};
    const double drift = (random.uniform() < 0.5 ? -1.0 : 1.0) * scenario.gyro_drift_rad_s;
    const double noise = scenario.gyro_noise_rad_s_sqrthz * std::sqrt(kRate_hz);
    Labmate labmate(scenario, random);
    const auto samples = static_cast<std::size_t>(kDuration_s * kRate_hz);
    for (std::size_t i = 0; i <= samples; ++i) {
        const double before = labmate.pose().heading_rad;
        for (int step = 0; i > 0 && step < kStepsPerSample; ++step) {
            labmate.drive(kSpeed_m_s / (kRate_hz * kStepsPerSample));
        }
        const double rate = (labmate.pose().heading_rad - before) * kRate_hz;
        const double t_s = static_cast<double>(i) / kRate_hz;
        mission.sensors.push_back({.robot_time_s = t_s,
                                   .odometry = labmate.ticks(),
                                   .gyro = GyroRate{rate + drift + noise * random.normal()}});
        mission.truth.push_back({t_s, labmate.pose()});
    }
    return mission;
}

}  // namespace hedr
