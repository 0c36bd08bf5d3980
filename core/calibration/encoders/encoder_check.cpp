#include "core/calibration/encoders/encoder_check.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "core/calibration/encoders/encoder_check_evidence.h"
#include "core/calibration/short_number.h"
#include "core/geometry/angle.h"

namespace hedr {

namespace {

constexpr double kLeastShare = 0.03;  // of the distance: a wheel that moved, if it counts little
constexpr double kSpinParts = 8.0;
constexpr double kLongestPush_s = 60.0;  // and as much for each metre
constexpr double kStraight_rad = radFromDeg(45.0);

EncoderTests readTests(std::span<const SampleSet> logs, const Vehicle& believed,
                       const EncoderCheckOptions& options) {
    EncoderTests tests{.distance_m = options.distance_m,
                       .tape_error_m = options.tape_error_m,
                       .turn_rad = 2.0 * kPi * options.turns};
    const double least_m = kLeastShare * std::abs(options.distance_m);
    const auto found = encoderTestsIn(logs, believed, least_m);
    if (!found.empty()) tests.push = readEncoderTravel(found[0], believed);
    if (found.size() > 1) tests.spin = readEncoderTravel(found[1], believed);
    return tests;
}

bool isSensible(const EncoderCheckOptions& options) {
    return std::isfinite(options.distance_m) && std::isfinite(options.turns) &&
           options.distance_m != 0.0 && options.turns != 0.0;
}

// Of the readings as such; empty: none.
std::string complaintAbout(const EncoderTests& tests) {
    if (!tests.push.has_sides || !tests.spin.has_sides) {
        return "The robot reports one distance for both wheels: they cannot be checked apart.";
    }
    constexpr double kMostBrokenShare = 0.1;
    for (const EncoderTravel* test : {&tests.push, &tests.spin}) {
        const auto all = static_cast<double>(test->moments.size() + test->broken);
        if (static_cast<double>(test->broken) > kMostBrokenShare * all) {
            return std::to_string(test->broken) + " of " + shortNumber(all, 1) +
                   " encoder readings are no numbers, or leap. Check the encoders' wiring and "
                   "encoder_counter_bits.";
        }
    }
    if (tests.push.moments.empty()) {
        return "No encoder readings came. Check that the robot sends them.";
    }
    return {};
}

// A drive is no push, and what the encoders say in it no sign of a fault. Empty: none.
std::string complaintAboutPush(const EncoderTests& tests) {
    const double moved_s = tests.push.moved_until_s - tests.push.moved_from_s;
    if (moved_s > kLongestPush_s * (1.0 + std::abs(tests.distance_m))) {
        return "It moved for " + shortNumber(moved_s / 60.0) + " min: that was no push by " +
               shortNumber(std::abs(tests.distance_m), 3) +
               " m. Let it stand, push it, let it stand, spin it, and let it stand.";
    }
    const double turned_rad = tests.push.knows_gyro_bias ? tests.push.gyro_rad() : 0.0;
    if (std::abs(turned_rad) > kStraight_rad) {
        return "By its gyro it turned by " + shortNumber(degFromRad(turned_rad)) +
               "° while it was pushed. Push it straight on.";
    }
    return {};
}

// What is still to do; empty: nothing.
std::string missingStep(const EncoderTests& tests) {
    const std::string distance = shortNumber(std::abs(tests.distance_m), 3) + " m";
    const std::string turns = shortNumber(std::abs(tests.turn_rad) / (2.0 * kPi), 3);
    if (!tests.push.moved()) return "Push it straight on by " + distance + ".";
    if (!tests.push.stands() && !tests.spin.moved()) return "Let it stand after the push.";
    if (!tests.spin.moved()) return "Now turn it on the spot, " + turns + " times.";
    return tests.spin.stands() ? std::string() : "Let it stand after the spin.";
}

// Counts or diameters that make the distance right.
std::vector<FoundParameter> foundRatio(const EncoderFinding& finding, const EncoderTests& tests,
                                       const VehicleGeometry& geometry) {
    const double relative = tests.tape_error_m / std::abs(tests.distance_m);
    const auto parameter = [&](std::string_view key, double was, double factor) {
        return FoundParameter{key, was, {was * factor, was * factor * relative}};
    };
    if (const auto whole = nearbyFactor(finding.factor)) {
        return {parameter("ticks_per_revolution", geometry.ticks_per_revolution, *whole)};
    }
    const double smaller = 1.0 / finding.factor;
    return {parameter("left_wheel_diameter_m", geometry.left_wheel_diameter_m, smaller),
            parameter("right_wheel_diameter_m", geometry.right_wheel_diameter_m, smaller)};
}

// Pieces of the spin, by encoders and by gyro.
Proof spinProof(const EncoderTests& tests, double wheelbase_m, double distance_change) {
    std::vector<HeldOutError> errors;
    const double piece_rad = std::abs(tests.spin.gyro_rad()) / kSpinParts;
    EncoderMoment since;
    for (const EncoderMoment& moment : tests.spin.moments) {
        const double gyro_rad = moment.gyro_rad - since.gyro_rad;
        if (std::abs(gyro_rad) < piece_rad) continue;
        const double wheels_rad =
            (moment.right_m - moment.left_m - since.right_m + since.left_m) / wheelbase_m;
        errors.push_back({wheels_rad - gyro_rad, distance_change * wheels_rad - gyro_rad});
        since = moment;
    }
    return proofOf(errors, "turn in pieces of the spin, against the gyro", "rad");
}

Calibration judgedRatio(EncoderCheck& check, const Vehicle& believed) {
    const EncoderFinding& finding = check.findings.front();
    check.calibration.found = foundRatio(finding, check.tests, believed.geometry);
    const FoundParameter& first = check.calibration.found.front();
    const double change = first.key == "ticks_per_revolution" ? *first.was / first.now.value
                                                              : first.now.value / *first.was;
    if (check.tests.spin.knows_gyro_bias) {
        check.calibration.proof = spinProof(check.tests, believed.geometry.wheelbase_m, change);
    }
    return judged(std::move(check.calibration));
}

bool isRatioOnly(const EncoderCheck& check) {
    return check.findings.size() == 1 &&
           check.findings.front().fault == EncoderFault::kWrongRatio &&
           check.findings.front().side == EncoderSide::kBoth;
}

Calibration verdictOn(EncoderCheck& check, const Vehicle& believed) {
    const std::string missing = missingStep(check.tests);
    if (missing.empty() && isRatioOnly(check)) return judgedRatio(check, believed);
    Calibration calibration = std::move(check.calibration);
    if (!check.findings.empty() && check.tests.push.stands()) {
        const EncoderFinding& first = check.findings.front();
        return refused(std::move(calibration), first.sentence + ' ' + first.advice);
    }
    calibration.verdict = missing.empty() ? Verdict::kUnchanged : Verdict::kNotProven;
    calibration.reason = !missing.empty() ? missing
                         : looksForMissingCounts(check.tests, believed)
                             ? "The encoders are right: sides, signs and ratio fit, and no magnet "
                               "or tooth is missing."
                             : "The encoders are right: sides, signs and ratio fit. Missing "
                               "magnets were not looked for.";
    return calibration;
}

}  // namespace

EncoderCheck checkEncoders(std::span<const SampleSet> logs, const Vehicle& believed,
                           const EncoderCheckOptions& options) {
    EncoderCheck check;
    check.calibration.procedure = "encoder-check";
    if (!isSensible(options)) {
        check.calibration = refused(std::move(check.calibration),
                                    "Say how far it is pushed and how many turns it is spun.");
        return check;
    }
    check.tests = readTests(logs, believed, options);
    std::string complaint = complaintAbout(check.tests);
    if (complaint.empty()) complaint = complaintAboutPush(check.tests);
    if (complaint.empty()) {
        check.ratios = encoderRatiosOf(check.tests, believed);
        check.findings = encoderFindingsIn(check.tests, believed);
    }
    addEvidence(check, believed);
    check.calibration = complaint.empty() ? verdictOn(check, believed)
                                          : refused(std::move(check.calibration), complaint);
    return check;
}

}  // namespace hedr
