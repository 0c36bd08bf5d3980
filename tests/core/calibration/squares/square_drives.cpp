#include "tests/core/calibration/squares/square_drives.h"

#include <algorithm>
#include <cmath>

#include "core/calibration/squares/umbmark.h"
#include "core/geometry/angle.h"
#include "core/simulation/manoeuvre.h"
#include "core/simulation/wheels.h"

namespace hedr {

namespace {

constexpr int kStepsOfASide = 16;
constexpr int kStepsOfACorner = 6;

// The steps of a square, to the left or to the right.
std::vector<MotionStep> squareSteps(double side_m, double sign) {
    std::vector<MotionStep> steps;
    for (int corner = 0; corner < 4; ++corner) {
        steps.insert(steps.end(), kStepsOfASide, {side_m / kStepsOfASide, 0.0});
        steps.insert(steps.end(), kStepsOfACorner, {0.0, sign * 0.5 * kPi / kStepsOfACorner});
    }
    return steps;
}

Pose<World> endOf(const std::vector<MotionStep>& steps) {
    Pose<World> pose;
    for (const MotionStep& step : steps) pose = after(pose, step);
    return pose;
}

// What encoders of wheels that are believed so count on these steps, and what really happens.
class SquareDriver {
  public:
    SquareDriver(const SquareDrives& drives, Random& random)
        : drives_(drives), real_(realWheels(drives)), random_(random) {
        note();
    }

    void stand(double seconds) {
        for (double t = 0.0; t < seconds; t += 0.5) {
            time_s_ += 0.5;
            note();
        }
    }

    Pose<World> drive(const std::vector<MotionStep>& steps) {
        // The wheels begin anywhere within a count, or all squares would be rounded alike.
        constexpr double kCount_m = 2.4e-4;
        left_m_ += kCount_m * random_.uniform();
        right_m_ += kCount_m * random_.uniform();
        Pose<World> pose;
        for (const MotionStep& step : steps) {
            const VehicleGeometry& by = drives_.along_tape ? real_ : kLabmate;
            const double half_turn_m = 0.5 * step.turn_rad * by.wheelbase_m;
            const double left =
                rolled(step.distance_m - half_turn_m, left_m_, real_.left_wheel_diameter_m);
            const double right =
                rolled(step.distance_m + half_turn_m, right_m_, real_.right_wheel_diameter_m);
            pose = after(pose, {0.5 * (left + right), (right - left) / real_.wheelbase_m});
            time_s_ += 1.0;
            note();
        }
        return pose;
    }

    std::vector<SensorReport> reports{};

  private:
    // Along the tape the way is given and the encoder follows, else the other way round.
    double rolled(double way_m, double& counted_m, double diameter_m) {
        const double real_over_believed = diameter_m / kLabmate.left_wheel_diameter_m;
        counted_m += drives_.along_tape ? way_m / real_over_believed : way_m;
        const double wanted_m = drives_.along_tape ? way_m : way_m * real_over_believed;
        const bool slips = random_.uniform() < drives_.slip_share;
        const double uneven_m =
            drives_.unevenness_m_sqrtm * std::sqrt(std::abs(way_m)) * random_.normal();
        return wanted_m * (slips ? 1.0 - drives_.slip : 1.0) + uneven_m;
    }

    void note() {
        reports.push_back(
            {.robot_time_s = time_s_, .odometry = wheelCounts(kLabmate, left_m_, right_m_)});
    }

    SquareDrives drives_;
    VehicleGeometry real_;
    Random& random_;
    double time_s_ = 0.0;
    double left_m_ = 0.0;
    double right_m_ = 0.0;
};

bool isClockwise(const SquareDrives& drives, int square) {
    if (!drives.in_turns) return square < drives.clockwise;
    const int pairs = std::min(drives.clockwise, drives.counter_clockwise);
    return square < 2 * pairs ? square % 2 == 0 : drives.clockwise > pairs;
}

}  // namespace

Vehicle labmate() { return {.name = "labmate", .geometry = kLabmate}; }

VehicleGeometry realWheels(const SquareDrives& drives) {
    return correctedGeometry(kLabmate, drives.diameter_ratio, drives.wheelbase_ratio);
}

DrivenSquares drive(const SquareDrives& drives, Random& random) {
    SquareDriver robot(drives, random);
    DrivenSquares driven;
    robot.stand(drives.pause_s);
    for (int i = 0; i < drives.clockwise + drives.counter_clockwise; ++i) {
        const double sign = isClockwise(drives, i) ? -1.0 : 1.0;
        const Pose<World> end = robot.drive(squareSteps(drives.side_m, sign));
        robot.stand(drives.pause_s);
        const auto number = static_cast<std::size_t>(i) + 1;
        driven.ends.push_back({number,
                               {end.position.x + drives.tape_m * random.normal(),
                                end.position.y + drives.tape_m * random.normal()},
                               {}});
    }
    driven.sets.push_back({"simulated", std::move(robot.reports)});
    return driven;
}

double returnError_m(const VehicleGeometry& believed, const VehicleGeometry& real, double side_m) {
    double largest_m = 0.0;
    for (const double sign : {-1.0, 1.0}) {
        std::vector<MotionStep> steps = squareSteps(side_m, sign);
        for (MotionStep& step : steps) {
            const double half_turn_m = 0.5 * step.turn_rad * believed.wheelbase_m;
            const double left_m = (step.distance_m - half_turn_m) * real.left_wheel_diameter_m /
                                  believed.left_wheel_diameter_m;
            const double right_m = (step.distance_m + half_turn_m) * real.right_wheel_diameter_m /
                                   believed.right_wheel_diameter_m;
            step = {0.5 * (left_m + right_m), (right_m - left_m) / real.wheelbase_m};
        }
        const Pose<World> end = endOf(steps);
        largest_m = std::max(largest_m, std::hypot(end.position.x, end.position.y));
    }
    return largest_m;
}

}  // namespace hedr
