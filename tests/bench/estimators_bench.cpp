// Samples per second of each estimator, beside a plain filter of three states (x, y, heading) in
// Eigen in the same run: "ratio_to_plain_filter" is our speed over its speed.
#include <benchmark/benchmark.h>

#include <Eigen/Core>
#include <chrono>
#include <cmath>
#include <vector>

#include "core/fusion/estimators.h"
#include "core/simulation/scenario.h"

namespace hedr {
namespace {

std::vector<Motion> motionsOfAMission() {
    const SimulatedMission mission = simulate(scenarioByName("packbot-corridors").value(), 1);
    MotionBuilder builder(mission.vehicle);
    std::vector<Motion> motions;
    for (const SensorReport& report : mission.sensors) {
        if (const auto motion = builder.add(report)) motions.push_back(*motion);
    }
    // A magnetometer that nothing disturbs.
    double heading_rad = 0.0;
    for (Motion& motion : motions) {
        heading_rad += *motion.odometry_turn_rad;
        motion.magnetic_field = {std::cos(heading_rad), -std::sin(heading_rad), 0.0};
    }
    return motions;
}

// Dead reckoning with its covariance: what a textbook writes down.
struct PlainFilter {
    Eigen::Vector3d state = Eigen::Vector3d::Zero();
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity() * 1e-6;

    void update(const Motion& motion) {
        const double middle = state.z() + 0.5 * *motion.gyro_turn_rad;
        const double dx = motion.distance_m * std::cos(middle);
        const double dy = motion.distance_m * std::sin(middle);
        Eigen::Matrix3d jacobian = Eigen::Matrix3d::Identity();
        jacobian(0, 2) = -dy;
        jacobian(1, 2) = dx;
        state += Eigen::Vector3d(dx, dy, *motion.gyro_turn_rad);
        covariance = jacobian * covariance * jacobian.transpose();
        covariance.diagonal() += Eigen::Vector3d(1e-6, 1e-6, 1e-7);
    }
};

double secondsOfPlainFilter(const std::vector<Motion>& motions) {
    const auto begin = std::chrono::steady_clock::now();
    PlainFilter filter;
    for (const Motion& motion : motions) filter.update(motion);
    benchmark::DoNotOptimize(filter.covariance);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

template <class Make>
void updateAll(benchmark::State& state, Make make) {
    const std::vector<Motion> motions = motionsOfAMission();
    double ours_s = 0.0;
    double plain_s = 0.0;
    for (auto _ : state) {
        const auto begin = std::chrono::steady_clock::now();
        auto estimator = make();
        for (const Motion& motion : motions) estimator.update(motion);
        benchmark::DoNotOptimize(estimator.pose());
        ours_s += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        state.PauseTiming();
        plain_s += secondsOfPlainFilter(motions);
        state.ResumeTiming();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(motions.size()));
    state.counters["ratio_to_plain_filter"] = plain_s / ours_s;
}

void odometry(benchmark::State& state) {
    updateAll(state, [] { return OdometryEstimator(Pose<World>{}, {}); });
}
void gyro(benchmark::State& state) {
    updateAll(state, [] { return GyroEstimator(Pose<World>{}, {}, {}); });
}
void gyrodometry(benchmark::State& state) {
    updateAll(state, [] { return Gyrodometry(Pose<World>{}, {}); });
}
void gyro_kalman(benchmark::State& state) {
    updateAll(state, [] { return GyroKalman(Pose<World>{}, {}); });
}
void gh_gyro(benchmark::State& state) {
    updateAll(state, [] { return GhFilter(Pose<World>{}, GhHeading::kGyro, {}); });
}
void gh_combined(benchmark::State& state) {
    updateAll(state, [] { return GhFilter(Pose<World>{}, GhHeading::kCombined, {}); });
}
void hedr(benchmark::State& state) {
    updateAll(state, [] { return Hedr(Pose<World>{}, {}); });
}

void hedr_bayes(benchmark::State& state) {
    updateAll(state, [] { return HedrBayes(Pose<World>{}, {}); });
}

void motionsFromReports(benchmark::State& state) {
    const SimulatedMission mission = simulate(scenarioByName("packbot-corridors").value(), 1);
    for (auto _ : state) {
        MotionBuilder builder(mission.vehicle);
        for (const SensorReport& report : mission.sensors) {
            benchmark::DoNotOptimize(builder.add(report));
        }
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(mission.sensors.size()));
}

BENCHMARK(odometry);
BENCHMARK(gyro);
BENCHMARK(gyrodometry);
BENCHMARK(gyro_kalman);
BENCHMARK(gh_gyro);
BENCHMARK(gh_combined);
BENCHMARK(hedr);
BENCHMARK(hedr_bayes);
BENCHMARK(motionsFromReports);

}  // namespace
}  // namespace hedr
