#include "core/calibration/gyro/warmup.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "core/calibration/distributions.h"
#include "core/calibration/gyro/gyro_range.h"
#include "core/calibration/gyro/warmup_evidence.h"
#include "core/calibration/gyro_samples.h"
#include "core/calibration/short_number.h"
#include "core/robot/motion.h"

namespace hedr {

namespace {

constexpr double kLongEnoughToSee_s = 600.0;
constexpr double kChangeChiSquared = 20.0;  // noise is beyond it in one record of a thousand
constexpr double kBendsTimeError = 0.5;     // relative: the curve is seen to bend
constexpr double kSlowMisfitChance = 0.005;
constexpr std::size_t kHeldOutParts = 12;
constexpr double kFirstMinute_s = 60.0;
constexpr double kMostUnsureChange = 0.25;  // of C1, relative standard error
constexpr double kSlowestWarmup_s = 4.0 * 3600.0;

double squaresOf(std::span<const double> values) {
    return std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
}

bool sayTheSame(const GyroSamples& gyro) {
    return std::all_of(gyro.samples.begin(), gyro.samples.end(), [&](const GyroSample& each) {
        return each.rate_rad_s == gyro.samples.front().rate_rad_s;
    });
}

// Empty: none.
std::string complaintAboutReadings(const GyroSamples& gyro) {
    std::string useless = complaintAboutBroken(gyro.samples.size(), gyro.broken);
    if (!useless.empty()) return useless;
    if (sayTheSame(gyro)) {
        return "All gyro readings are equal: the gyro does not answer. Check its wiring.";
    }
    return complaintAboutClipped(gyro.samples);
}

// Whether the record rather looks like that of a room that changes: a likelihood ratio.
bool roomShows(const WarmupFit& steady, std::span<const WarmupBlock> blocks) {
    const WarmupFit changing = fitWarmup(blocks, RoomTemperature::kMayChange);
    const double rest = squaresOf(changing.residuals_rad_s);
    const double gained = squaresOf(steady.residuals_rad_s) - rest;
    const double statistic = gained * changing.degrees_of_freedom / rest;
    return statistic > 0.0 && chiSquaredTail(statistic, 1.0) < kSlowMisfitChance &&
           changing.slow_misfit_p > kSlowMisfitChance &&
           whitenessOf(changing.residuals_rad_s).isWhite();
}

// What the blocks tell.
void study(Warmup& warmup, std::span<const WarmupBlock> blocks, const WarmupOptions& options) {
    const WarmupFit& fit = warmup.fit.emplace(fitWarmup(blocks, options.room));
    warmup.room_shows = fit.room == RoomTemperature::kSteady && roomShows(fit, blocks);
    warmup.whiteness = whitenessOf(fit.residuals_rad_s);
    warmup.follows =
        !warmup.room_shows && warmup.whiteness.isWhite() && fit.slow_misfit_p > kSlowMisfitChance;
    const double change_rad_s =
        biasAt(fit.curve, warmup.on_s) - biasAt(fit.curve, options.on_before_s);
    warmup.warms_up = fit.change_chi_squared > kChangeChiSquared &&
                      std::abs(change_rad_s) > options.matters_rad_s;
    if (!warmup.warms_up) return;
    if (!fit.converged || fit.relativeErrorOfTime() > kBendsTimeError) return;
    warmup.known = fit.relativeErrorOfTime() <= kKnownTimeError;
    warmup.known_in_s = knownIn_s(fit, options.on_before_s, warmup.stood_s);
    warmup.settled_in_s = settledIn_s(fit.curve, warmup.on_s, options.matters_rad_s);
    warmup.cost = costOfStarting(fit, warmup.on_s);
}

bool roomMayChange(const Warmup& warmup) {
    return warmup.fit && warmup.fit->room == RoomTemperature::kMayChange;
}

constexpr std::string_view kStartCold =
    " Switch the gyro off until it is cold, then on again, and let the robot stand at once.";

// What was not seen, and what no gyro does. Empty: none.
std::string complaintAboutCold(const WarmupFit& fit) {
    const GyroDrift& curve = fit.curve;
    if (curve.time_s > kSlowestWarmup_s) {
        return "A warm-up time of " + spokenTime(curve.time_s) +
               " is too long for a gyro. Check that the log's times are in seconds.";
    }
    if (!(fit.c1_rad_s().standard_error <= kMostUnsureChange * std::abs(curve.c1_rad_s))) {
        return std::string("What it was when cold cannot be told: it had been on for too long.")
            .append(kStartCold);
    }
    const double most_rad_s =
        std::max(std::abs(curve.c2_rad_s), std::abs(curve.c1_rad_s + curve.c2_rad_s));
    if (!(most_rad_s <= kLargestGyroBias_rad_s)) {
        return "By the curve it reads " + shortNumber(degFromRad(most_rad_s)) +
               " °/s while it stands, too much for a bias. Check the gyro and its scale.";
    }
    return {};
}

// Empty: none.
std::string complaintAboutTime(const Warmup& warmup) {
    if (warmup.fit && warmup.known) return complaintAboutCold(*warmup.fit);
    if (warmup.motion) {
        std::string again = sentenceOf(*warmup.motion).append(kStartCold);
        if (!warmup.known_in_s) return again;
        const double needed_s = warmup.on_s + *warmup.known_in_s;
        return again.append(" It takes about " + spokenTime(needed_s) + " in all.");
    }
    if (!warmup.fit) return "It has not stood for long enough. Let it stand for many minutes.";
    if (!warmup.cost && roomMayChange(warmup)) {
        return "Its warming up cannot be told from the room's yet. Let it stand for much longer.";
    }
    if (!warmup.cost) {
        return "The bias still changes in a straight line. Let it stand until the line bends; if "
               "it never does, the gyro is not warming up.";
    }
    const std::string early = "It is too early to tell how fast it warms up.";
    if (!warmup.known_in_s) return early + " Let it stand for much longer.";
    return early + " Let it stand for about " + spokenTime(*warmup.known_in_s) + " more.";
}

// Of what the blocks tell; empty: none.
std::string complaintAboutCurve(const Warmup& warmup) {
    if (!warmup.warms_up && warmup.stood_s < kLongEnoughToSee_s) {
        return warmup.motion ? sentenceOf(*warmup.motion).append(kStartCold)
                             : "No warming up can be seen yet. Let it stand for at least " +
                                   spokenTime(kLongEnoughToSee_s) + " in all.";
    }
    if (!warmup.warms_up && roomMayChange(warmup)) {
        return "In " + spokenTime(warmup.stood_s) +
               " its bias drifted no otherwise than a changing room alone makes it. If the gyro "
               "was "
               "cold, let it stand for longer; if it was warm, measure its bias instead.";
    }
    if (!warmup.warms_up) {
        return "The gyro is already warm: in " + spokenTime(warmup.stood_s) +
               " its bias did not drift enough to need a curve. Measure its bias instead.";
    }
    if (warmup.room_shows) {
        return "The bias drifts steadily besides, as in a room that warms or cools. Say that its "
               "temperature may change, and calibrate by this record again; it may have to be "
               "longer.";
    }
    if (!warmup.follows) {
        return "The rate does not follow a warm-up curve: what the curve leaves is not noise. See "
               "that nothing moves or heats the gyro, and start again with a cold gyro.";
    }
    return {};
}

// What the robot would take for its bias without the new curve.
double oldBias_rad_s(const Vehicle& believed, std::span<const WarmupBlock> blocks,
                     const WarmupBlock& block) {
    if (believed.gyro_drift) return meanBias(block, *believed.gyro_drift);
    if (believed.gyro_bias_rad_s) return *believed.gyro_bias_rad_s;
    double turn_rad = 0.0;
    double heard_s = 0.0;
    for (const WarmupBlock& early : blocks) {
        if (heard_s > 0.0 && early.end_s > blocks.front().begin_s + kFirstMinute_s) break;
        turn_rad += early.mean_rad_s * early.heard_s;
        heard_s += early.heard_s;
    }
    return turn_rad / heard_s;
}

// Each part of the record in turn is left out of the fit, and judged by it. What the room does is
// no part of either curve, and taken from both.
Proof curveProof(const WarmupFit& fit, std::span<const WarmupBlock> blocks,
                 const Vehicle& believed) {
    std::vector<HeldOutError> errors;
    for (std::size_t part = 0; part < kHeldOutParts; ++part) {
        const auto first =
            blocks.begin() + static_cast<std::ptrdiff_t>(part * blocks.size() / kHeldOutParts);
        const auto last = blocks.begin() +
                          static_cast<std::ptrdiff_t>((part + 1) * blocks.size() / kHeldOutParts);
        std::vector<WarmupBlock> others(blocks.begin(), first);
        others.insert(others.end(), last, blocks.end());
        const WarmupFit refit = refitWarmup(others, fit);
        HeldOutError error;
        for (const WarmupBlock& block : std::span(first, last)) {
            const double old_rad_s = oldBias_rad_s(believed, blocks, block);
            const double own_rad_s = block.mean_rad_s - refit.room_drift_rad_s2 * block.middle_s();
            error.before += (own_rad_s - old_rad_s) * block.heard_s;
            error.after += (own_rad_s - meanBias(block, refit.curve)) * block.heard_s;
        }
        errors.push_back(error);
    }
    return proofOf(errors, "heading drift in each part of the time it stood", "rad");
}

std::vector<FoundParameter> foundIn(const WarmupFit& fit, const Vehicle& believed) {
    std::vector<FoundParameter> found{{"gyro_drift_c1_rad_s", {}, fit.c1_rad_s()},
                                      {"gyro_drift_c2_rad_s", {}, fit.c2_rad_s()},
                                      {"gyro_drift_time_s", {}, fit.time_s()}};
    for (FoundParameter& each : found) each.was = vehicleNumber(believed, each.key);
    return found;
}

}  // namespace

Warmup calibrateWarmup(std::span<const SensorReport> reports, const Vehicle& believed,
                       const WarmupOptions& options) {
    Warmup warmup;
    warmup.calibration.procedure = "warmup";
    const auto refuse = [&warmup](std::string reason) {
        warmup.calibration = refused(std::move(warmup.calibration), std::move(reason));
        return warmup;
    };
    const auto gyro = gyroSamplesOf(reports);
    if (!gyro) {
        addWarmupEvidence(warmup, {}, options);
        return refuse("No gyro readings came. Check that the robot sends them.");
    }
    const WarmupRecord record = warmupRecordOf(*gyro, reports, believed, options.on_before_s);
    warmup.stood_s = record.stood_s;
    warmup.on_s = options.on_before_s + record.stood_s;
    warmup.motion = record.motion;
    const std::string useless = complaintAboutReadings(*gyro);
    if (useless.empty() && record.blocks.size() >= kFewestWarmupBlocks)
        study(warmup, record.blocks, options);
    addWarmupEvidence(warmup, record.blocks, options);
    if (!useless.empty()) return refuse(useless);
    for (std::string complaint :
         {warmup.fit ? complaintAboutCurve(warmup) : "", complaintAboutTime(warmup)}) {
        if (!complaint.empty()) return refuse(std::move(complaint));
    }
    warmup.calibration.found = foundIn(*warmup.fit, believed);
    warmup.calibration.proof = curveProof(*warmup.fit, record.blocks, believed);
    warmup.calibration = judged(std::move(warmup.calibration));
    return warmup;
}

}  // namespace hedr
