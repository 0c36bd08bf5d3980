#include "core/calibration/gyro/gyro_scale_evidence.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/calibration/short_number.h"

namespace hedr {

namespace {

constexpr std::ptrdiff_t kTurnsEachWay = 2;  // fewer do not tell how well it is put to its mark
constexpr double kOneWayShare = 0.5;

std::ptrdiff_t countOfWay(const GyroScale& scale, int way) {
    return std::count_if(scale.turns.whole.begin(), scale.turns.whole.end(),
                         [way](const GyroTurn& turn) { return turn.whole * way > 0; });
}

std::vector<CalibrationStep> stepsOf(const GyroScale& scale, std::span<const TurnLog> logs) {
    const bool stood = std::any_of(logs.begin(), logs.end(),
                                   [](const TurnLog& log) { return !log.standing.stands.empty(); });
    const std::string detail =
        "By whole turns and back to the mark, slowly; let it stand there for 5 s. At least twice.";
    return {{"Put it to a mark", "Let it stand for 5 s.", stood},
            {"Turn it counter-clockwise", detail, countOfWay(scale, 1) >= kTurnsEachWay},
            {"Turn it clockwise", detail, countOfWay(scale, -1) >= kTurnsEachWay}};
}

CalibrationProgress progressOf(const GyroScale& scale, double wanted) {
    if (!scale.fit) return {.more = "It has to turn first"};
    const Estimate& both = scale.fit->both;
    const double known = both.standard_error / both.value;
    const double share = known > wanted ? wanted * wanted / (known * known) : 1.0;
    const bool one_way = countOfWay(scale, 1) == 0 || countOfWay(scale, -1) == 0;
    CalibrationProgress progress{.share = one_way ? kOneWayShare * share : share,
                                 .known = "Known to ±" + percentText(both.margin() / both.value)};
    if (one_way) {
        progress.more = "Turns the other way are missing";
    } else if (share < 1.0) {
        const auto turns = static_cast<double>(scale.turns.whole.size());
        progress.more = "About " + shortNumber(std::ceil(turns / share - turns)) +
                        " turns more give ±" + percentText(Estimate{0.0, wanted}.margin());
    }
    return progress;
}

// The encoders' turning over the true one, where they turned at all.
std::optional<double> encoderShare(const GyroScale& scale) {
    double encoders_rad = 0.0;
    double true_rad = 0.0;
    for (const GyroTurn& turn : scale.turns.whole) {
        if (!turn.wheels_rad || *turn.wheels_rad == 0.0) continue;
        encoders_rad += std::abs(*turn.wheels_rad);
        true_rad += 2.0 * kPi * std::abs(turn.whole);
    }
    return true_rad > 0.0 ? std::optional(encoders_rad / true_rad) : std::nullopt;
}

std::vector<EvidenceFigure> figuresOf(const GyroScale& scale) {
    std::vector<EvidenceFigure> figures{
        {"Turns used", static_cast<double>(scale.turns.whole.size())}};
    if (!scale.fit) return figures;
    const auto add = [&figures](const char* name, const std::optional<Estimate>& estimate) {
        if (estimate) figures.push_back({name, estimate->value, "", estimate->interval()});
    };
    add("Scale counter-clockwise", scale.fit->counter_clockwise);
    add("Scale clockwise", scale.fit->clockwise);
    add("Difference of the two", scale.fit->difference);
    figures.push_back({"Put beside the mark by", scale.fit->mark_rad, "rad"});
    if (const auto share = encoderShare(scale)) {
        figures.push_back({"Turning by the encoders over the true one", *share});
    }
    return figures;
}

std::string sentenceAbout(const TurnOutlier& outlier, std::span<const GyroTurn> turns) {
    const std::string number = std::to_string(turns[outlier.turn].number);
    const std::string off = degreesText(outlier.off_rad);
    if (!outlier.stand)
        return "Turn " + number + " is " + off + " off the others; it was left out.";
    return "After turn " + number + " it stood " + off + " beside the mark; turn " + number +
           " and the next one count together only.";
}

std::string sentenceAbout(const GyroTurn& other, std::span<const TurnLog> logs, double gyro_scale) {
    const std::string number = std::to_string(other.number);
    if (other.gap_s > logs[other.log].longest_gap_s) {
        return "Turn " + number + " was left out: no gyro readings came for " +
               shortNumber(other.gap_s) + " s.";
    }
    return "Turn " + number + " was left out: " + degreesText(gyro_scale * other.reported_rad, 3) +
           " is not the whole number of turns.";
}

std::vector<std::string> remarksOn(const GyroScale& scale, std::span<const TurnLog> logs,
                                   const Vehicle& believed) {
    std::vector<std::string> remarks;
    for (const GyroTurn& other : scale.turns.others) {
        remarks.push_back(sentenceAbout(other, logs, believed.gyro_scale));
    }
    if (!scale.fit) return remarks;
    const TurnFit& fit = *scale.fit;
    for (const TurnOutlier& outlier : fit.outliers) {
        remarks.push_back(sentenceAbout(outlier, scale.turns.whole));
    }
    if (fit.difference && !fit.difference->interval().contains(0.0)) {
        remarks.push_back("The scale is " + percentText(std::abs(fit.difference->value)) +
                          " larger " +
                          (fit.difference->value > 0.0 ? "counter-clockwise than clockwise"
                                                       : "clockwise than counter-clockwise") +
                          ": one scale cannot make up for both.");
    }
    if (fit.mark_was_given) {
        remarks.push_back("There are too few turns to see how well it is put to its mark: " +
                          degreesText(fit.mark_rad) + " is assumed.");
    }
    if (believed.gyro_bias_rad_s || believed.gyro_drift) {
        remarks.emplace_back("The bias in the vehicle file changes with the scale.");
    }
    return remarks;
}

EvidencePlot turnPlot(const GyroScale& scale, double old_scale) {
    EvidencePlot plot{"Heading error after each turn", {"Turn", ""}, {"Error", "rad"}};
    EvidenceSeries before{"Old scale", EvidenceSeries::Shape::kDots};
    EvidenceSeries after{"New scale", EvidenceSeries::Shape::kSquares};
    for (const GyroTurn& turn : scale.turns.whole) {
        const double true_rad = 2.0 * kPi * turn.whole;
        for (EvidenceSeries* series : {&before, &after}) {
            series->x.push_back(static_cast<double>(turn.number));
        }
        before.y.push_back(old_scale * turn.reported_rad - true_rad);
        after.y.push_back(scale.fit->both.value * turn.reported_rad - true_rad);
    }
    plot.series = {std::move(before), std::move(after)};
    return plot;
}

}  // namespace

std::string degreesText(double angle_rad, int digits) {
    return shortNumber(std::abs(degFromRad(angle_rad)), digits) + "°";
}

void addEvidence(GyroScale& scale, std::span<const TurnLog> logs, const Vehicle& believed,
                 double wanted_standard_error) {
    Calibration& calibration = scale.calibration;
    calibration.steps = stepsOf(scale, logs);
    calibration.progress = progressOf(scale, wanted_standard_error);
    calibration.figures = figuresOf(scale);
    calibration.remarks = remarksOn(scale, logs, believed);
    calibration.plots = {turnPlot(scale, believed.gyro_scale)};
}

}  // namespace hedr
