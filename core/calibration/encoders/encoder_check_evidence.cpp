#include "core/calibration/encoders/encoder_check_evidence.h"

#include <cmath>
#include <string>
#include <utility>

#include "core/calibration/short_number.h"
#include "core/geometry/angle.h"

namespace hedr {

namespace {

constexpr double kSpinByEye_rad = radFromDeg(3.0);  // standard deviation

bool isDone(const EncoderTravel& test) { return test.moved() && test.stands(); }

std::vector<CalibrationStep> stepsOf(const EncoderTests& tests) {
    const std::string way = tests.turn_rad > 0.0 ? "counter-clockwise" : "clockwise";
    const std::string direction = tests.distance_m > 0.0 ? "forwards" : "backwards";
    return {{"Push it",
             shortNumber(std::abs(tests.distance_m), 3) + " m straight " + direction +
                 ", along a tape, by hand; then let it stand.",
             isDone(tests.push) || tests.spin.moved()},
            {"Spin it",
             shortNumber(std::abs(tests.turn_rad) / (2.0 * kPi), 3) + " times " + way +
                 ", on the spot, back to where it looked; then let it stand.",
             isDone(tests.spin)}};
}

CalibrationProgress progressOf(const std::vector<CalibrationStep>& steps) {
    CalibrationProgress progress;
    for (const CalibrationStep& step : steps) {
        if (step.done) progress.share += 1.0 / static_cast<double>(steps.size());
    }
    if (!steps[0].done) {
        progress.more = "The push tells signs and ratio";
    } else if (!steps[1].done) {
        progress.known = "Signs and ratio are known";
        progress.more = "The spin tells the sides";
    } else {
        progress.known = "Sides, signs and ratio are known";
    }
    return progress;
}

Estimate wheelDiameter(const EncoderCheck& check, const VehicleGeometry& geometry) {
    const double ratio = 0.5 * (std::abs(*check.ratios.left) + std::abs(*check.ratios.right));
    const double diameter_m =
        0.5 * (geometry.left_wheel_diameter_m + geometry.right_wheel_diameter_m) / ratio;
    return {diameter_m, diameter_m * check.tests.tape_error_m / std::abs(check.tests.distance_m)};
}

Estimate wheelbase(const EncoderCheck& check, const VehicleGeometry& geometry) {
    const double wheelbase_m = geometry.wheelbase_m * std::abs(*check.ratios.turn);
    return {wheelbase_m,
            wheelbase_m * std::hypot(kSpinByEye_rad / std::abs(check.tests.turn_rad),
                                     check.tests.tape_error_m / std::abs(check.tests.distance_m))};
}

std::vector<EvidenceFigure> figuresOf(const EncoderCheck& check, const VehicleGeometry& geometry) {
    std::vector<EvidenceFigure> figures;
    const auto add = [&figures](const char* name, const Estimate& estimate, const char* unit) {
        figures.push_back({name, estimate.value, unit, estimate.interval()});
    };
    if (check.ratios.left) {
        figures.push_back({"Left wheel in the push", check.tests.push.left_m(), "m"});
        figures.push_back({"Right wheel in the push", check.tests.push.right_m(), "m"});
        add("Wheel diameter by the push", wheelDiameter(check, geometry), "m");
    }
    if (check.ratios.turn) {
        figures.push_back(
            {"Spin by the encoders", *check.ratios.turn * check.tests.turn_rad, "rad"});
    }
    if (check.ratios.gyro) {
        figures.push_back({"Spin by the gyro", check.tests.spin.gyro_rad(), "rad"});
    }
    if (check.ratios.turn) add("Wheelbase by the spin", wheelbase(check, geometry), "m");
    return figures;
}

std::vector<std::string> remarksOn(const EncoderCheck& check, const Vehicle& believed) {
    std::vector<std::string> remarks;
    for (const EncoderFinding& finding : check.findings) {
        remarks.push_back(finding.sentence + ' ' + finding.advice);
    }
    if (check.tests.push.moved() && !looksForMissingCounts(check.tests, believed)) {
        const double need_m =
            std::ceil(kPi * kFewestRevolutions * believed.geometry.left_wheel_diameter_m + 0.5);
        remarks.push_back("Missing magnets or teeth could not be looked for: push it by " +
                          shortNumber(need_m) + " m or more, with 20 readings a second.");
    }
    if (check.tests.spin.moved() && !check.tests.spin.has_gyro) {
        remarks.emplace_back("There is no gyro: which way it was spun is what you say.");
    }
    return remarks;
}

EvidencePlot travelPlot(const char* title, const EncoderTravel& test) {
    EvidencePlot plot{title, {"Time", "s"}, {"Travelled", "m"}};
    EvidenceSeries left{"Left wheel"};
    EvidenceSeries right{"Right wheel", EvidenceSeries::Shape::kDashes};
    for (const EncoderMoment& moment : test.moments) {
        const double t_s = moment.t_s - test.moments.front().t_s;
        left.x.push_back(t_s);
        left.y.push_back(moment.left_m);
        right.x.push_back(t_s);
        right.y.push_back(moment.right_m);
    }
    plot.series = {std::move(left), std::move(right)};
    return plot;
}

}  // namespace

void addEvidence(EncoderCheck& check, const Vehicle& believed) {
    Calibration& calibration = check.calibration;
    calibration.steps = stepsOf(check.tests);
    calibration.progress = progressOf(calibration.steps);
    calibration.figures = figuresOf(check, believed.geometry);
    calibration.remarks = remarksOn(check, believed);
    calibration.plots = {travelPlot("Push", check.tests.push),
                         travelPlot("Spin", check.tests.spin)};
}

}  // namespace hedr
