#include "core/calibration/wheels/wheel_loops.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/calibration/encoders/encoder_travel.h"
#include "core/calibration/jackknife.h"
#include "core/calibration/wheels/wheel_loops_evidence.h"
#include "core/geometry/angle.h"

namespace hedr {

namespace {

constexpr double kLoopStep_m = 0.01;
constexpr double kShortestLoopWheelbases = 5.0;
constexpr double kUnclearTurns = 0.3;  // further from a whole number of turns
constexpr int kMostRounds = 30;
constexpr double kLoopSettled = 1e-10;

struct WheelStep {
    double left_m = 0.0;
    double right_m = 0.0;
};

// A loop as it was rolled.
struct LoopTrack {
    std::vector<WheelStep> steps{};
    double turned_rad = 0.0;  // whole turns
    double lever_m = 0.0;     // as far as the heading's error moves things, about

    // Where it ends by wheels of that shape.
    Pose<Robot> end(const WheelShape& shape) const {
        Pose<Robot> pose;
        for (const WheelStep& step : steps) {
            const double left_m = (1.0 - 0.5 * shape.right_larger) * step.left_m;
            const double right_m = (1.0 + 0.5 * shape.right_larger) * step.right_m;
            const double turn_rad = (right_m - left_m) / shape.wheelbase_m;
            const double middle_rad = pose.heading_rad + 0.5 * turn_rad;
            const double way_m = 0.5 * (left_m + right_m);
            pose.position.x += way_m * std::cos(middle_rad);
            pose.position.y += way_m * std::sin(middle_rad);
            pose.heading_rad += turn_rad;
        }
        pose.heading_rad -= turned_rad;
        return pose;
    }
    // The same in metres.
    Eigen::Vector3d miss_m(const WheelShape& shape) const {
        const Pose<Robot> pose = end(shape);
        return {pose.position.x, pose.position.y, lever_m * pose.heading_rad};
    }
};

std::vector<WheelStep> stepsOf(const EncoderTravel& travel) {
    std::vector<WheelStep> steps;
    const EncoderMoment* last = &travel.moments.front();
    for (const EncoderMoment& moment : travel.moments) {
        const WheelStep step{moment.left_m - last->left_m, moment.right_m - last->right_m};
        const bool is_last = &moment == &travel.moments.back();
        if (std::max(std::abs(step.left_m), std::abs(step.right_m)) < kLoopStep_m && !is_last)
            continue;
        steps.push_back(step);
        last = &moment;
    }
    return steps;
}

// Loops and why the others are none.
struct LoopsRead {
    std::vector<LoopTrack> tracks{};
    std::vector<DrivenLoop> loops{};
    std::vector<std::string> remarks{};
    bool has_sides = true;
};

void addLoop(LoopsRead& read, std::size_t set, const EncoderTravel& travel,
             const VehicleGeometry& geometry) {
    const std::string name = "Drive " + std::to_string(set + 1);
    LoopTrack track{.steps = stepsOf(travel)};
    DrivenLoop loop{.set = set};
    for (const WheelStep& step : track.steps)
        loop.rolled_m += 0.5 * (std::abs(step.left_m) + std::abs(step.right_m));
    if (loop.rolled_m < kShortestLoopWheelbases * geometry.wheelbase_m) {
        read.remarks.push_back(name + " was left out: it hardly moved.");
        return;
    }
    const double wheels_rad = (travel.right_m() - travel.left_m()) / geometry.wheelbase_m;
    // A gyro whose bias nobody knows counts turns that never were.
    const bool by_gyro = travel.has_gyro && travel.knows_gyro_bias;
    const double turns = (by_gyro ? travel.gyro_rad() : wheels_rad) / (2.0 * kPi);
    if (std::abs(turns - std::round(turns)) > kUnclearTurns) {
        read.remarks.push_back(name + " was left out: it did not end heading as it began.");
        return;
    }
    track.turned_rad = loop.turned_rad = 2.0 * kPi * std::round(turns);
    track.lever_m = 0.25 * loop.rolled_m;
    loop.before = track.end({geometry.wheelbase_m, 0.0});
    read.loops.push_back(loop);
    read.tracks.push_back(std::move(track));
}

LoopsRead readLoops(std::span<const SampleSet> sets, const Vehicle& vehicle) {
    LoopsRead read;
    for (std::size_t set = 0; set < sets.size(); ++set) {
        const EncoderTravel travel = readEncoderTravel(sets[set].reports, vehicle);
        read.has_sides &= travel.has_sides;
        if (travel.moments.size() < 2 || !travel.has_sides) continue;
        addLoop(read, set, travel, vehicle.geometry);
    }
    return read;
}

// What each loop misses, and how that changes with wheelbase and right_larger.
struct LoopEquation {
    Eigen::Vector3d miss_m{};
    Eigen::Matrix<double, 3, 2> change{};
};

std::vector<LoopEquation> equationsAt(std::span<const LoopTrack> tracks, const WheelShape& shape) {
    const double wheelbase_step_m = 1e-5 * shape.wheelbase_m;
    constexpr double kLargerStep = 1e-5;
    std::vector<LoopEquation> equations;
    equations.reserve(tracks.size());
    for (const LoopTrack& track : tracks) {
        LoopEquation equation{.miss_m = track.miss_m(shape)};
        equation.change.col(0) =
            (track.miss_m({shape.wheelbase_m + wheelbase_step_m, shape.right_larger}) -
             equation.miss_m) /
            wheelbase_step_m;
        equation.change.col(1) =
            (track.miss_m({shape.wheelbase_m, shape.right_larger + kLargerStep}) -
             equation.miss_m) /
            kLargerStep;
        equations.push_back(equation);
    }
    return equations;
}

// One step of Gauss and Newton, `without` left out.
Eigen::Vector2d stepFrom(std::span<const LoopEquation> equations, std::size_t without) {
    Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
    Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
    for (std::size_t i = 0; i < equations.size(); ++i) {
        if (i == without) continue;
        information += equations[i].change.transpose() * equations[i].change;
        gradient += equations[i].change.transpose() * equations[i].miss_m;
    }
    return -information.ldlt().solve(gradient);
}

WheelShape moved(const WheelShape& shape, const Eigen::Vector2d& step) {
    return {shape.wheelbase_m + step(0), shape.right_larger + step(1)};
}

// None where it does not settle.
std::optional<WheelShape> fitLoops(std::span<const LoopTrack> tracks, double wheelbase_m) {
    WheelShape shape{wheelbase_m, 0.0};
    for (int round = 0; round < kMostRounds; ++round) {
        const auto equations = equationsAt(tracks, shape);
        const Eigen::Vector2d step = stepFrom(equations, equations.size());
        shape = moved(shape, step);
        if (!step.allFinite() || !(shape.wheelbase_m > 0.1 * wheelbase_m)) return std::nullopt;
        if (std::abs(step(0)) < kLoopSettled * wheelbase_m && std::abs(step(1)) < kLoopSettled)
            return shape;
    }
    return std::nullopt;
}

bool turnBothWays(std::span<const DrivenLoop> loops) {
    const auto [least, most] = std::ranges::minmax(loops, {}, &DrivenLoop::turned_rad);
    return least.turned_rad < most.turned_rad && least.turned_rad <= 0.0 && most.turned_rad >= 0.0;
}

std::string complaintAbout(const LoopsRead& read) {
    if (!read.has_sides) return "The encoders do not tell the left side from the right one.";
    if (read.loops.size() < kFewestLoops) {
        return "Four closed drives are the least, each by itself; " +
               std::to_string(read.loops.size()) + " can be used.";
    }
    if (!turnBothWays(read.loops)) {
        return "All drives turned the same way round. Drive some the other way, or a wrong "
               "wheelbase and unequal wheels can hide each other.";
    }
    return {};
}

Estimate diameterOf(const Estimate& right_larger, double was_m, double side) {
    return {was_m * (1.0 + side * right_larger.value), 0.5 * was_m * right_larger.standard_error,
            right_larger.degrees_of_freedom};
}

Calibration withLoopsLeftOut(WheelLoops& wheels, const LoopsRead& read, const Vehicle& believed) {
    const auto equations = equationsAt(read.tracks, wheels.shape);
    std::vector<double> wheelbases_m;
    std::vector<double> rights_larger;
    std::vector<HeldOutError> errors;
    for (std::size_t i = 0; i < read.tracks.size(); ++i) {
        const WheelShape others = moved(wheels.shape, stepFrom(equations, i));
        wheels.loops[i].after = read.tracks[i].end(others);
        wheelbases_m.push_back(others.wheelbase_m);
        rights_larger.push_back(others.right_larger);
        const Point<Robot> before = wheels.loops[i].before.position;
        const Point<Robot> after = wheels.loops[i].after.position;
        errors.push_back({std::hypot(before.x, before.y), std::hypot(after.x, after.y)});
    }
    const VehicleGeometry& was = believed.geometry;
    const Estimate larger = jackknifed(wheels.shape.right_larger, rights_larger);
    wheels.calibration.found = {
        {"wheelbase_m", was.wheelbase_m, jackknifed(wheels.shape.wheelbase_m, wheelbases_m)},
        {"left_wheel_diameter_m", was.left_wheel_diameter_m,
         diameterOf(larger, was.left_wheel_diameter_m, -0.5)},
        {"right_wheel_diameter_m", was.right_wheel_diameter_m,
         diameterOf(larger, was.right_wheel_diameter_m, 0.5)}};
    wheels.calibration.proof = proofOf(errors, "return position error", "m");
    return judged(wheels.calibration);
}

}  // namespace

WheelLoops calibrateByLoops(std::span<const SampleSet> sets, const Vehicle& believed) {
    WheelLoops wheels;
    wheels.calibration.procedure = "wheels";
    LoopsRead read = readLoops(sets, believed);
    wheels.loops = read.loops;
    wheels.calibration.remarks = std::move(read.remarks);
    std::string complaint = complaintAbout(read);
    if (complaint.empty()) {
        const auto shape = fitLoops(read.tracks, believed.geometry.wheelbase_m);
        if (shape) wheels.shape = *shape;
        if (!shape)
            complaint =
                "No wheels bring the drives back to their starts. Check that each ended "
                "where it began, and run the encoder check.";
    }
    wheels.calibration = complaint.empty()
                             ? withLoopsLeftOut(wheels, read, believed)
                             : refused(std::move(wheels.calibration), std::move(complaint));
    addEvidence(wheels);
    return wheels;
}

}  // namespace hedr
