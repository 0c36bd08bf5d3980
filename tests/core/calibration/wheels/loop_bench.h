#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/calibration/sample_set.h"
#include "core/geometry/angle.h"
#include "core/robot/vehicle.h"
#include "core/simulation/random.h"
#include "core/simulation/wheels.h"

namespace hedr::test {

// Rectangles of different sizes, driven back to the mark with little care.
struct LoopBench {
    double right_larger = 0.01;
    double wheelbase_ratio = 1.03;  // real over believed
    double unevenness_m_sqrtm = 3e-4;
    double mark_m = 0.005;
    double mark_rad = radFromDeg(0.5);
    int each_way = 5;
    bool both_ways = true;
    bool gyro = false;
};

inline Vehicle believedRobot() {
    return {.geometry = {.left_wheel_diameter_m = 0.15,
                         .right_wheel_diameter_m = 0.15,
                         .wheelbase_m = 0.34,
                         .ticks_per_revolution = 2000.0}};
}

class LoopDrive {
  public:
    LoopDrive(const LoopBench& bench, Random& random)
        : bench_(bench), random_(random), wheels_(real(bench), bench.unevenness_m_sqrtm) {}

    SampleSet drive(double length_m, double width_m, double way) {
        stand();
        for (int side = 0; side < 4; ++side) {
            move(side % 2 == 0 ? length_m : width_m, 0.0);
            move(0.0, way * 0.5 * kPi);
        }
        // How far it stands beside its mark.
        move(bench_.mark_m * random_.normal(), bench_.mark_rad * random_.normal());
        stand();
        return {"loop", std::move(reports_)};
    }

  private:
    static VehicleGeometry real(const LoopBench& bench) {
        VehicleGeometry geometry = believedRobot().geometry;
        geometry.left_wheel_diameter_m *= 1.0 - 0.5 * bench.right_larger;
        geometry.right_wheel_diameter_m *= 1.0 + 0.5 * bench.right_larger;
        geometry.wheelbase_m *= bench.wheelbase_ratio;
        return geometry;
    }
    void stand() {
        for (int i = 0; i < 60; ++i) step(0.0, 0.0);
    }
    void move(double way_m, double turn_rad) {
        const int steps =
            1 + static_cast<int>(20.0 * std::max(std::abs(way_m) / 0.4, std::abs(turn_rad) / 0.6));
        for (int i = 0; i < steps; ++i) step(way_m / steps, turn_rad / steps);
    }
    void step(double way_m, double turn_rad) {
        wheels_.move(way_m, turn_rad, random_);
        SensorReport report{.robot_time_s = 0.05 * static_cast<double>(reports_.size()),
                            .odometry = wheels_.ticks()};
        if (bench_.gyro) report.gyro = GyroRate{turn_rad / 0.05 + 0.001 * random_.normal()};
        reports_.push_back(report);
    }

    LoopBench bench_;
    Random& random_;
    Wheels wheels_;
    std::vector<SensorReport> reports_{};
};

inline std::vector<SampleSet> loopsOf(const LoopBench& bench, std::uint64_t seed) {
    Random random(seed);
    std::vector<SampleSet> sets;
    for (int i = 0; i < 2 * bench.each_way; ++i) {
        const double way = i % 2 == 0 || !bench.both_ways ? 1.0 : -1.0;
        LoopDrive drive(bench, random);
        sets.push_back(drive.drive(random.uniform(3.0, 9.0), random.uniform(2.0, 5.0), way));
    }
    return sets;
}

}  // namespace hedr::test
