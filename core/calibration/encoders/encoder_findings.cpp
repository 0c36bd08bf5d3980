#include "core/calibration/encoders/encoder_findings.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/calibration/encoders/encoder_words.h"
#include "core/geometry/angle.h"

namespace hedr {

namespace {

constexpr double kSilentShare = 0.02;  // of the other wheel
constexpr double kNear = 0.05;         // a factor that is meant to be whole
// What tape, eye and file are usually off by; more is a fault.
constexpr double kRatioOff = 0.06;
constexpr double kSidesOff = 0.05;
constexpr double kTurnOff = 0.15;
constexpr double kTapeErrors = 2.0;
constexpr double kWander_rad = radFromDeg(2.5);  // standard deviation of "straight on"
constexpr double kWanders = 3.0;
constexpr double kCounts = 2.0;          // that may be too many or too few, as they are whole
constexpr double kFewestWithGap = 0.85;  // counts of a wheel of which some are missing
constexpr double kGyroTurned = 0.25;     // of the spin: it answers
constexpr double kBesideSpot = 0.7;      // way of the middle over that of the wheels

bool isOff(double ratio, double by) { return std::abs(std::log(std::abs(ratio))) > by; }

struct Silence {
    bool left = false;
    bool right = false;
};

Silence silenceIn(const EncoderTravel& test) {
    const double left_m = std::abs(test.left_m());
    const double right_m = std::abs(test.right_m());
    return {left_m < kSilentShare * right_m, right_m < kSilentShare * left_m};
}

// Looks through two tests for what is wrong.
class FaultSearch {
  public:
    FaultSearch(const EncoderTests& tests, const Vehicle& vehicle)
        : tests_(tests), vehicle_(vehicle), ratios_(encoderRatiosOf(tests, vehicle)) {
        if (tests.push.moved()) push_ = silenceIn(tests.push);
        if (tests.spin.moved()) spin_ = silenceIn(tests.spin);
    }

    std::vector<EncoderFinding> result() {
        lookForSilence();
        lookForDirections();
        lookForRatios();
        lookForMissingCounts();
        lookAtTheSpin();
        for (EncoderFinding& finding : findings_) addWords(finding, vehicle_, tests_);
        return std::move(findings_);
    }

  private:
    void add(EncoderFault fault, EncoderSide side = EncoderSide::kBoth, double factor = 1.0) {
        findings_.push_back({.fault = fault, .side = side, .factor = factor});
    }

    void lookForSilence() {
        const bool spun_only = tests_.spin.moved() && !tests_.push.moved();
        if (spun_only && !tests_.push.moments.empty()) add(EncoderFault::kSilent);
        if (!tests_.push.moved()) return;
        lookForSilence(EncoderSide::kLeft, push_.left, spin_.left);
        lookForSilence(EncoderSide::kRight, push_.right, spin_.right);
    }
    void lookForSilence(EncoderSide side, bool in_push, bool in_spin) {
        if (!in_push && !in_spin) return;
        const bool in_all = in_push && (in_spin || !tests_.spin.moved());
        add(in_all ? EncoderFault::kSilent : EncoderFault::kSometimesSilent, side);
    }

    void lookForDirections() {
        const bool left = ratios_.left.value_or(1.0) < 0.0 && !push_.left;
        const bool right = ratios_.right.value_or(1.0) < 0.0 && !push_.right;
        const double turn = ratios_.turn.value_or(0.0);
        const bool gyro_answers = std::abs(ratios_.gyro.value_or(0.0)) > kGyroTurned;
        const bool gyro_against = gyro_answers && *ratios_.gyro < 0.0;
        if (left && right && turn < 0.0 && !gyro_against)
            return add(EncoderFault::kPushedBackwards);
        if (left) add(EncoderFault::kReversed, EncoderSide::kLeft);
        if (right) add(EncoderFault::kReversed, EncoderSide::kRight);
        if (turn < 0.0) {
            add(gyro_against ? EncoderFault::kSpunBackwards : EncoderFault::kSwapped);
        } else if (turn > 0.0 && gyro_against) {
            add(EncoderFault::kGyroReversed);
        }
    }

    void lookForRatios() {
        if (!ratios_.left || !ratios_.right) return;
        const double distance_m = std::abs(tests_.distance_m);
        const double off =
            kRatioOff + kTapeErrors * tests_.tape_error_m / distance_m + roundingOf(tests_.push);
        const double wander = kWanders * kWander_rad * vehicle_.geometry.wheelbase_m / distance_m +
                              roundingOf(tests_.push);
        const double left = std::abs(*ratios_.left);
        const double right = std::abs(*ratios_.right);
        if (push_.left || push_.right) {
            const bool is_left = push_.right;
            lookForRatio(is_left ? EncoderSide::kLeft : EncoderSide::kRight, is_left ? left : right,
                         off + 0.5 * wander);
        } else if (isOff(left / right, kSidesOff + wander)) {
            const double larger = std::max(std::abs(std::log(left)), std::abs(std::log(right)));
            const double limit = std::min(off + 0.5 * wander, 0.99 * larger);
            lookForRatio(EncoderSide::kLeft, left, limit);
            lookForRatio(EncoderSide::kRight, right, limit);
        } else {
            lookForRatio(EncoderSide::kBoth, 0.5 * (left + right), off);
        }
    }
    // Share of the travel of a wheel that does not count for want of finer counts.
    double roundingOf(const EncoderTravel& test) const {
        const VehicleGeometry& geometry = vehicle_.geometry;
        const double count_m = kPi * geometry.left_wheel_diameter_m / geometry.ticks_per_revolution;
        return kCounts * count_m / std::max(std::abs(test.left_m()), std::abs(test.right_m()));
    }
    void lookForRatio(EncoderSide side, double ratio, double off) {
        if (isOff(ratio, off)) add(EncoderFault::kWrongRatio, side, ratio);
    }

    // By a straight run of two wheels that count nearly as much as each other.
    void lookForMissingCounts() {
        const bool explained =
            std::any_of(findings_.begin(), findings_.end(), [](const auto& each) {
                return each.fault == EncoderFault::kSilent ||
                       each.fault == EncoderFault::kSometimesSilent ||
                       (each.fault == EncoderFault::kWrongRatio && !mayBeMissing(each));
            });
        if (explained || !tests_.push.moved()) return;
        const auto missing = missingCountsIn(pushedWheels(tests_.push, vehicle_));
        if (!missing || missing->strength <= 1.0) return;
        const EncoderSide side = missing->left ? EncoderSide::kLeft : EncoderSide::kRight;
        // What counts a little too little for them is explained.
        std::erase_if(findings_, [side](const EncoderFinding& each) {
            return each.fault == EncoderFault::kWrongRatio && each.side == side;
        });
        add(EncoderFault::kMissingCounts, side, missing->share);
    }
    static bool mayBeMissing(const EncoderFinding& ratio) {
        return ratio.side != EncoderSide::kBoth && ratio.factor < 1.0 &&
               ratio.factor > kFewestWithGap;
    }

    void lookAtTheSpin() {
        if (!ratios_.turn || push_.left || push_.right || spin_.left || spin_.right) return;
        const double beside = besideSpot();
        const double turn = std::abs(*ratios_.turn);
        const double gyro = std::abs(ratios_.gyro.value_or(0.0));
        const double off = kTurnOff + roundingOf(tests_.push) + roundingOf(tests_.spin);
        if (beside > kBesideSpot + roundingOf(tests_.spin)) {
            add(EncoderFault::kNotOnTheSpot);
        } else if (gyro > kGyroTurned && isOff(gyro, kTurnOff) && !isOff(turn / gyro, off)) {
            add(EncoderFault::kSpunByOtherAngle, EncoderSide::kBoth, gyro);
        } else if (isOff(turn, off)) {
            add(EncoderFault::kWrongWheelbase, EncoderSide::kBoth, turn);
        }
    }
    double besideSpot() const {
        const double left_m = tests_.spin.left_m() / ratios_.left.value_or(1.0);
        const double right_m = tests_.spin.right_m() / ratios_.right.value_or(1.0);
        return std::abs(right_m + left_m) / std::abs(right_m - left_m);
    }

    const EncoderTests& tests_;
    const Vehicle& vehicle_;
    EncoderRatios ratios_;
    Silence push_{};
    Silence spin_{};
    std::vector<EncoderFinding> findings_{};
};

}  // namespace

EncoderRatios encoderRatiosOf(const EncoderTests& tests, const Vehicle& vehicle) {
    EncoderRatios ratios;
    Silence silent;
    if (tests.push.moved()) {
        silent = silenceIn(tests.push);
        ratios.left = tests.push.left_m() / tests.distance_m;
        ratios.right = tests.push.right_m() / tests.distance_m;
    }
    if (!tests.spin.moved()) return ratios;
    const double full_m = vehicle.geometry.wheelbase_m * tests.turn_rad;
    const double left_m = tests.spin.left_m() / (silent.left ? 1.0 : ratios.left.value_or(1.0));
    const double right_m = tests.spin.right_m() / (silent.right ? 1.0 : ratios.right.value_or(1.0));
    ratios.turn = (right_m - left_m) / full_m;
    if (silent.left) ratios.turn = 2.0 * right_m / full_m;
    if (silent.right) ratios.turn = -2.0 * left_m / full_m;
    if (tests.spin.has_gyro) ratios.gyro = tests.spin.gyro_rad() / tests.turn_rad;
    return ratios;
}

std::optional<double> nearbyFactor(double factor) {
    constexpr std::array kWhole{2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0, 12.0, 16.0, 20.0, 100.0};
    for (const double whole : kWhole) {
        if (!isOff(factor / whole, kNear)) return whole;
        if (!isOff(factor * whole, kNear)) return 1.0 / whole;
    }
    return std::nullopt;
}

std::vector<EncoderFinding> encoderFindingsIn(const EncoderTests& tests, const Vehicle& vehicle) {
    return FaultSearch(tests, vehicle).result();
}

WheelPairRun pushedWheels(const EncoderTravel& push, const Vehicle& vehicle) {
    const VehicleGeometry& geometry = vehicle.geometry;
    WheelPairRun run{.ticks_per_revolution = geometry.ticks_per_revolution};
    const double left_m = std::copysign(kPi * geometry.left_wheel_diameter_m, push.left_m());
    const double right_m = std::copysign(kPi * geometry.right_wheel_diameter_m, push.right_m());
    for (const EncoderMoment& moment : push.moments) {
        if (moment.t_s < push.moved_from_s || moment.t_s > push.moved_until_s) continue;
        run.moments.push_back(
            {moment.t_s, moment.left_m / left_m, moment.right_m / right_m, moment.gyro_rad});
    }
    return run;
}

bool looksForMissingCounts(const EncoderTests& tests, const Vehicle& vehicle) {
    return missingCountsIn(pushedWheels(tests.push, vehicle)).has_value();
}

}  // namespace hedr
