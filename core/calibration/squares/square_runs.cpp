#include "core/calibration/squares/square_runs.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/calibration/median.h"
#include "core/calibration/short_number.h"
#include "core/calibration/squares/square_shape.h"
#include "core/robot/motion.h"

namespace hedr {

namespace {

constexpr double kStandsWithin_m = 0.003;  // a wheel; encoders may flicker at a count
constexpr double kStep_m = 0.005;          // of a wheel; finer ones are put together
constexpr double kMostAstray_m = 0.05;     // by one step that both drove and turned
constexpr double kShortestWay_m = 2.0;     // of a square worth driving
constexpr std::size_t kFewestCorners = 2;  // of what was meant to be a square
constexpr double kMostOtherSize = 0.2;     // side over that of the others

// From standing to standing.
struct Drive {
    std::size_t first = 0;
    std::size_t last = 0;
    std::vector<WheelTravel> steps{};
    bool restarted = false;
    bool sparse = false;
    bool open = false;  // it did not stand at the end
};

// Cuts reports into drives.
class DriveCutter {
  public:
    explicit DriveCutter(const Vehicle& believed)
        : builder_(believed), wheelbase_m_(believed.geometry.wheelbase_m) {}

    void add(const SensorReport& report, std::size_t index) {
        const std::uint64_t restarts = builder_.restarts();
        const auto motion = builder_.add(report);
        if (moves_ && builder_.restarts() != restarts) drive_.restarted = true;
        if (!motion) return;
        (motion->odometry_turn_rad ? told_apart_ : untold_) = true;
        if (!motion->odometry_turn_rad) return;
        roll(motion->distance_m, *motion->odometry_turn_rad);
        drive_.last = index;
        if (hasMovedOn()) {
            anchor_ = wheels_;
            stands_since_s_ = motion->t_s;
            moves_ = true;
        } else if (moves_ && motion->t_s - stands_since_s_ > kLongestCornerStop_s) {
            endDrive();
        }
    }

    bool toldApart() const { return told_apart_ || !untold_; }

    std::vector<Drive> finish() {
        if (moves_) {
            drive_.open = true;
            endDrive();
        }
        return std::move(drives_);
    }

  private:
    void roll(double distance_m, double turn_rad) {
        const double half_turn_m = 0.5 * turn_rad * wheelbase_m_;
        const WheelTravel step{distance_m - half_turn_m, distance_m + half_turn_m};
        wheels_.left_m += step.left_m;
        wheels_.right_m += step.right_m;
        if (0.5 * std::abs(distance_m * turn_rad) > kMostAstray_m) drive_.sparse = true;
        pending_.left_m += step.left_m;
        pending_.right_m += step.right_m;
        if (std::max(std::abs(pending_.left_m), std::abs(pending_.right_m)) < kStep_m) return;
        drive_.steps.push_back(std::exchange(pending_, {}));
    }

    bool hasMovedOn() const {
        return std::max(std::abs(wheels_.left_m - anchor_.left_m),
                        std::abs(wheels_.right_m - anchor_.right_m)) > kStandsWithin_m;
    }

    void endDrive() {
        drive_.steps.push_back(std::exchange(pending_, {}));
        drives_.push_back(std::exchange(drive_, {.first = drive_.last, .last = drive_.last}));
        moves_ = false;
    }

    MotionBuilder builder_;
    double wheelbase_m_;
    std::vector<Drive> drives_{};
    Drive drive_{};
    WheelTravel wheels_{};   // since the beginning
    WheelTravel pending_{};  // not yet a step
    WheelTravel anchor_{};   // where the wheels were when they last moved on
    double stands_since_s_ = 0.0;
    bool moves_ = false;
    bool told_apart_ = false;
    bool untold_ = false;
};

std::string complaintAbout(const Drive& drive, const SquareShape& shape) {
    if (drive.restarted) return "was broken: the robot started again in it";
    if (drive.sparse) return "cannot be followed: reports are missing in it";
    return complaintAbout(shape);
}

std::size_t nextNumber(const SquareRuns& found) {
    return found.runs.size() + found.left_out.size() + 1;
}

void sortIn(SquareRuns& found, Drive drive, std::size_t set, double wheelbase_m) {
    const SquareShape shape = shapeOf(drive.steps, wheelbase_m);
    const std::string complaint = complaintAbout(drive, shape);
    if (drive.open && !complaint.empty()) {
        found.unfinished = true;
        return;
    }
    if (shape.corners_rad.size() < kFewestCorners || shape.way_m < kShortestWay_m) {
        ++found.moves;
        return;
    }
    const std::size_t number = nextNumber(found);
    if (!complaint.empty()) {
        found.left_out.push_back({number, complaint});
        return;
    }
    found.runs.push_back(
        {.number = number,
         .turning = shape.turn_rad() > 0.0 ? Turning::kCounterClockwise : Turning::kClockwise,
         .side_m = std::abs(shape.side_m()),
         .corner_rad = shape.corner_rad(),
         .set = set,
         .first = drive.first,
         .last = drive.last,
         .steps = std::move(drive.steps)});
}

bool isALogOfItsOwn(std::span<const SampleSet> sets, std::size_t set) {
    return sets.size() > 1 && std::ranges::count(sets, sets[set].origin, &SampleSet::origin) == 1;
}

void addRunsOf(SquareRuns& found, std::span<const SampleSet> sets, std::size_t set,
               const Vehicle& believed) {
    DriveCutter cutter(believed);
    const std::vector<SensorReport>& reports = sets[set].reports;
    for (std::size_t i = 0; i < reports.size(); ++i) cutter.add(reports[i], i);
    found.wheels_told_apart &= cutter.toldApart();
    const std::size_t number = nextNumber(found);
    found.unfinished = false;
    for (Drive& drive : cutter.finish()) {
        sortIn(found, std::move(drive), set, believed.geometry.wheelbase_m);
    }
    if (nextNumber(found) == number && isALogOfItsOwn(sets, set)) {
        found.left_out.push_back({number, "has no whole square in its log"});
    }
}

double medianSide_m(const std::vector<SquareRun>& runs) {
    std::vector<double> sides_m;
    sides_m.reserve(runs.size());
    for (const SquareRun& run : runs) sides_m.push_back(run.side_m);
    return medianOf(std::move(sides_m));
}

void leaveOutOtherSizes(SquareRuns& found) {
    if (found.runs.empty()) return;
    const double usual_m = medianSide_m(found.runs);
    std::erase_if(found.runs, [&](const SquareRun& run) {
        if (std::abs(run.side_m / usual_m - 1.0) <= kMostOtherSize) return false;
        found.left_out.push_back({run.number, "has sides of " + shortNumber(run.side_m) +
                                                  " m where others have " + shortNumber(usual_m) +
                                                  " m"});
        return true;
    });
    std::ranges::sort(found.left_out, {}, &LeftOutRun::number);
}

}  // namespace

std::string_view nameOf(Turning turning) {
    return turning == Turning::kClockwise ? "clockwise" : "counter-clockwise";
}

SquareRuns squareRunsOf(std::span<const SampleSet> sets, const Vehicle& believed) {
    SquareRuns found;
    for (std::size_t set = 0; set < sets.size(); ++set) addRunsOf(found, sets, set, believed);
    leaveOutOtherSizes(found);
    return found;
}

}  // namespace hedr
