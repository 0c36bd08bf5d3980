#include "core/calibration/gyro/gyro_scale.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "core/calibration/gyro/gyro_range.h"
#include "core/calibration/gyro/gyro_scale_evidence.h"

namespace hedr {

namespace {

std::vector<TurnLog> readTurnLogs(std::span<const SampleSet> sets, const Vehicle& vehicle) {
    std::vector<TurnLog> logs;
    for (const SampleSet& set : sets) {
        if (auto log = readTurnLog(set.reports, vehicle)) logs.push_back(std::move(*log));
    }
    return logs;
}

// Of the readings as such; empty: none.
std::string complaintAbout(std::span<const TurnLog> logs) {
    if (logs.empty()) return "No gyro readings came. Check that the robot sends them.";
    for (const TurnLog& log : logs) {
        std::string useless = complaintAboutBroken(log.samples.size(), log.broken);
        if (!useless.empty()) return useless;
        if (isBeyondRange(log.samples, log.standing)) {
            return "The gyro was at the end of its range while it turned. Turn it slower.";
        }
    }
    return {};
}

bool encodersDisagree(const GyroTurn& turn) {
    constexpr double kHalfTurn_rad = kPi;  // more, so that wheels that stood still say nothing
    return turn.wheels_rad && std::abs(*turn.wheels_rad) > kHalfTurn_rad &&
           (*turn.wheels_rad > 0.0) != (turn.whole > 0);
}

// Of the turns; empty: none.
std::string complaintAbout(const TurnsFound& turns, double gyro_scale) {
    if (std::any_of(turns.whole.begin(), turns.whole.end(), encodersDisagree)) {
        return "The encoders say that it turned the other way round. Check the encoders and the "
               "sign of the gyro first.";
    }
    if (!turns.whole.empty()) return {};
    if (turns.ambiguous) return "It could be one turn more or less. Say how many turns each was.";
    if (turns.others.empty()) {
        return "It has not stood, turned and stood again. Let it stand for 5 s before and after "
               "each turn.";
    }
    return "It turned by " + degreesText(gyro_scale * turns.others.front().reported_rad, 3) +
           " between two stands, which is no whole number of turns. Turn it from the mark to the "
           "mark.";
}

Estimate times(const Estimate& estimate, double factor) {
    return {factor * estimate.value, std::abs(factor) * estimate.standard_error,
            estimate.degrees_of_freedom};
}

// What the file has of the scaled rate changes with the scale.
std::vector<FoundParameter> foundParameters(const Estimate& scale, const Vehicle& believed) {
    std::vector<FoundParameter> found{{"gyro_scale", believed.gyro_scale, scale}};
    const Estimate change = times(scale, 1.0 / believed.gyro_scale);
    const auto add = [&](std::string_view key, double was) {
        found.push_back({key, was, times(change, was)});
    };
    if (believed.gyro_bias_rad_s) add("gyro_bias_rad_s", *believed.gyro_bias_rad_s);
    if (believed.gyro_drift) {
        add("gyro_drift_c1_rad_s", believed.gyro_drift->c1_rad_s);
        add("gyro_drift_c2_rad_s", believed.gyro_drift->c2_rad_s);
    }
    return found;
}

bool isOutlier(const TurnFit& fit, std::size_t turn) {
    return std::any_of(fit.outliers.begin(), fit.outliers.end(), [turn](const auto& outlier) {
        return outlier.turn == turn || (outlier.stand && outlier.turn + 1 == turn);
    });
}

// Each turn by the scale that the others give.
std::vector<HeldOutError> heldOut(const TurnModel& model, const TurnFit& fit, double old_scale) {
    std::vector<HeldOutError> errors;
    for (Eigen::Index i = 0; i < model.reported_rad.size(); ++i) {
        const auto turn = static_cast<std::size_t>(i);
        if (isOutlier(fit, turn)) continue;
        const auto scale = scaleWithout(model, fit, turn);
        if (!scale) continue;
        errors.push_back({old_scale * model.reported_rad(i) - model.turned_rad(i),
                          *scale * model.reported_rad(i) - model.turned_rad(i)});
    }
    return errors;
}

Calibration judgedBothWays(const GyroScale& scale) {
    Calibration calibration = judged(scale.calibration);
    const bool both_ways = scale.fit->counter_clockwise && scale.fit->clockwise;
    if (calibration.verdict == Verdict::kAccepted && !both_ways) {
        calibration.verdict = Verdict::kNotProven;
        calibration.reason = "It turned one way only. Turn it the other way too.";
    }
    return calibration;
}

}  // namespace

GyroScale calibrateGyroScale(std::span<const SampleSet> sets, const Vehicle& believed,
                             const GyroScaleOptions& options) {
    GyroScale scale;
    scale.calibration.procedure = "gyro-scale";
    const std::vector<TurnLog> logs = readTurnLogs(sets, believed);
    scale.turns = turnsIn(
        logs,
        {.turns = options.turns, .closed = options.closed, .gyro_scale = believed.gyro_scale});
    if (!scale.turns.whole.empty()) {
        const TurnModel model = turnModelOf(logs, scale.turns.whole, options.usual_mark_error_rad);
        scale.fit = fitTurns(model);
        scale.held_out = heldOut(model, *scale.fit, believed.gyro_scale);
        scale.calibration.found = foundParameters(scale.fit->both, believed);
    }
    addEvidence(scale, logs, believed, options.wanted_standard_error);
    for (std::string complaint :
         {complaintAbout(logs), complaintAbout(scale.turns, believed.gyro_scale)}) {
        if (complaint.empty()) continue;
        scale.calibration = refused(std::move(scale.calibration), std::move(complaint));
        return scale;
    }
    scale.calibration.proof = proofOf(scale.held_out, "heading error after each turn", "rad");
    scale.calibration = judgedBothWays(scale);
    return scale;
}

}  // namespace hedr
