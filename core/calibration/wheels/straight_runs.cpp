#include "core/calibration/wheels/straight_runs.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/calibration/encoders/encoder_travel.h"
#include "core/calibration/jackknife.h"
#include "core/calibration/short_number.h"
#include "core/geometry/angle.h"

namespace hedr {

namespace {

constexpr double kLeastRunShare = 0.5;  // of the length; shorter, it was not driven
constexpr double kMostShare = 2.0;
constexpr double kStraight_rad = radFromDeg(15.0);  // by so much more it is longer than its chord
constexpr std::size_t kEnoughRuns = 6;
constexpr double kWantedScale = 0.001;

struct RunsRead {
    std::vector<StraightRun> runs{};
    std::vector<std::string> remarks{};
    std::size_t last_number = 0;
    bool has_encoders = false;
};

double largestTurn_rad(const EncoderTravel& travel, double wheelbase_m) {
    double most_rad = 0.0;
    for (const EncoderMoment& moment : travel.moments) {
        const double wheels_rad = (moment.right_m - moment.left_m) / wheelbase_m;
        most_rad = std::max(
            most_rad,
            std::abs(travel.has_gyro && travel.knows_gyro_bias ? moment.gyro_rad : wheels_rad));
    }
    return most_rad;
}

void addRun(RunsRead& read, std::span<const SensorReport> reports, const Vehicle& vehicle,
            double distance_m) {
    const EncoderTravel travel = readEncoderTravel(reports, vehicle);
    if (travel.moments.size() < 2) return;
    read.has_encoders = true;
    const double way_m = 0.5 * (travel.left_m() + travel.right_m());
    const std::string name = "Run " + std::to_string(++read.last_number);
    if (std::abs(way_m) < kLeastRunShare * distance_m ||
        std::abs(way_m) > kMostShare * distance_m) {
        read.remarks.push_back(name + " was left out: by the wheels it went " +
                               shortNumber(std::abs(way_m), 3) + " m.");
    } else if (largestTurn_rad(travel, vehicle.geometry.wheelbase_m) > kStraight_rad) {
        read.remarks.push_back(name + " was left out: it was not straight.");
    } else {
        read.runs.push_back({read.last_number, way_m});
    }
}

RunsRead readRuns(std::span<const SampleSet> sets, const Vehicle& vehicle, double distance_m) {
    RunsRead read;
    for (const SampleSet& set : sets) {
        for (const auto& reports : encoderTestsIn(set, vehicle, kLeastRunShare * distance_m))
            addRun(read, reports, vehicle, distance_m);
    }
    return read;
}

std::string complaintAbout(const RunsRead& read, double distance_m) {
    if (!(distance_m > 0.0) || !std::isfinite(distance_m))
        return "The length of the runs has to be more than nothing.";
    if (!read.has_encoders) return "No encoder counts came. Check that the robot sends them.";
    if (read.runs.size() < 2) {
        return "Two straight runs of " + shortNumber(distance_m, 4) + " m are the least; " +
               std::to_string(read.runs.size()) + " can be used.";
    }
    return {};
}

double meanWay_m(std::span<const StraightRun> runs, std::size_t without) {
    double sum_m = 0.0;
    for (std::size_t i = 0; i < runs.size(); ++i)
        sum_m += i == without ? 0.0 : std::abs(runs[i].way_m);
    return sum_m / static_cast<double>(runs.size() - (without < runs.size() ? 1 : 0));
}

FoundParameter scaled(std::string_view key, double was, const Estimate& scale) {
    return {key, was, {was * scale.value, was * scale.standard_error, scale.degrees_of_freedom}};
}

Calibration scaleFrom(std::span<const StraightRun> runs, const VehicleGeometry& was,
                      double distance_m, Calibration calibration) {
    std::vector<double> without;
    std::vector<HeldOutError> errors;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const double way_m = std::abs(runs[i].way_m);
        without.push_back(distance_m / meanWay_m(runs, i));
        errors.push_back({way_m - distance_m, without.back() * way_m - distance_m});
    }
    const Estimate scale = jackknifed(distance_m / meanWay_m(runs, runs.size()), without);
    calibration.found = {scaled("left_wheel_diameter_m", was.left_wheel_diameter_m, scale),
                         scaled("right_wheel_diameter_m", was.right_wheel_diameter_m, scale),
                         scaled("wheelbase_m", was.wheelbase_m, scale)};
    calibration.found.back().follows = true;  // so that it turns as before
    calibration.proof = proofOf(errors, "length of each run", "m");
    const double known = scale.standard_error > kWantedScale
                             ? std::pow(kWantedScale / scale.standard_error, 2)
                             : 1.0;
    calibration.progress.share =
        std::min(known, static_cast<double>(runs.size()) / static_cast<double>(kEnoughRuns));
    calibration.progress.known = "Known to ±" + percentText(scale.margin());
    if (runs.size() < kEnoughRuns) calibration.progress.more = "Six runs are a good start";
    return judged(std::move(calibration));
}

EvidencePlot runPlot(std::span<const StraightRun> runs, double distance_m) {
    EvidencePlot plot{
        "Length of each run by the wheels, less the true one", {"Run", ""}, {"Error", "m"}};
    EvidenceSeries before{"Old wheels", EvidenceSeries::Shape::kDots};
    EvidenceSeries after{"New wheels", EvidenceSeries::Shape::kSquares};
    const double scale = distance_m / meanWay_m(runs, runs.size());
    for (const StraightRun& run : runs) {
        const auto number = static_cast<double>(run.number);
        before.x.push_back(number);
        before.y.push_back(std::abs(run.way_m) - distance_m);
        after.x.push_back(number);
        after.y.push_back(scale * std::abs(run.way_m) - distance_m);
    }
    plot.series = {std::move(before), std::move(after)};
    return plot;
}

}  // namespace

StraightRuns calibrateByStraightRuns(std::span<const SampleSet> sets, const Vehicle& believed,
                                     double distance_m) {
    StraightRuns straight;
    RunsRead read = readRuns(sets, believed, distance_m);
    std::string complaint = complaintAbout(read, distance_m);
    straight.runs = std::move(read.runs);
    Calibration& calibration = straight.calibration;
    calibration.procedure = "wheels";
    calibration.remarks = std::move(read.remarks);
    const bool enough = straight.runs.size() >= kEnoughRuns;
    calibration.steps = {{"Drive the measured way",
                          "Straight, from mark to mark, to and fro; stand for 2 s at each. Six "
                          "times or more.",
                          enough}};
    calibration.figures = {{"Runs used", static_cast<double>(straight.runs.size())}};
    if (!straight.runs.empty()) calibration.plots = {runPlot(straight.runs, distance_m)};
    straight.calibration =
        complaint.empty()
            ? scaleFrom(straight.runs, believed.geometry, distance_m, std::move(calibration))
            : refused(std::move(calibration), std::move(complaint));
    return straight;
}

}  // namespace hedr
