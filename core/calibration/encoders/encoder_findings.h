#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/calibration/encoders/encoder_period.h"
#include "core/calibration/encoders/encoder_travel.h"
#include "core/robot/vehicle.h"

namespace hedr {

enum class EncoderFault : unsigned char {
    kSilent,           // counts nothing
    kSometimesSilent,  // counted nothing in one of the tests
    kReversed,         // counts backwards
    kSwapped,          // left is right
    kWrongRatio,       // counts too much or too little
    kWrongWheelbase,
    kMissingCounts,  // at one place of each revolution
    kGyroReversed,
    // The test was not as it should have been, as far as can be told.
    kPushedBackwards,  // or front and back are mixed up
    kSpunBackwards,
    kSpunByOtherAngle,
    kNotOnTheSpot
};

enum class EncoderSide : unsigned char { kBoth, kLeft, kRight };

struct EncoderFinding {
    EncoderFault fault = EncoderFault::kSilent;
    EncoderSide side = EncoderSide::kBoth;  // as it is called now
    // kWrongRatio, kWrongWheelbase: so many times too much; kMissingCounts: share of a revolution.
    double factor = 1.0;
    std::string sentence{};
    std::string advice{};  // what to change, to what
};

// What the operator did.
struct EncoderTests {
    EncoderTravel push{};        // straight on
    EncoderTravel spin{};        // on the spot
    double distance_m = 1.0;     // of the push, negative: backwards
    double tape_error_m = 0.01;  // standard deviation
    double turn_rad = 0.0;       // of the spin, counter-clockwise positive
};

// What the encoders measured in the tests over what it was, where there was such a test.
struct EncoderRatios {
    std::optional<double> left{};  // of the push, negative: counts backwards
    std::optional<double> right{};
    std::optional<double> turn{};  // of the spin, with the signs and ratios of the push put right
    std::optional<double> gyro{};  // of the spin
};

EncoderRatios encoderRatiosOf(const EncoderTests& tests, const Vehicle& vehicle);

// The wheels while it was pushed, by their own counts, forwards positive whatever their signs are.
WheelPairRun pushedWheels(const EncoderTravel& push, const Vehicle& vehicle);

// Whether the push went far enough, and was read often enough, for missing magnets to show.
bool looksForMissingCounts(const EncoderTests& tests, const Vehicle& vehicle);

// A whole number or one over it that is near, within 5 %.
std::optional<double> nearbyFactor(double factor);

// All that is wrong, what comes first explains most. Nothing where there has been no test yet.
std::vector<EncoderFinding> encoderFindingsIn(const EncoderTests& tests, const Vehicle& vehicle);

}  // namespace hedr
