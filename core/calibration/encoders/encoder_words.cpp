#include "core/calibration/encoders/encoder_words.h"

#include <cmath>

#include "core/calibration/short_number.h"
#include "core/geometry/angle.h"

namespace hedr {

namespace {

struct Words {
    std::string sentence;
    std::string advice;
};

std::string nameOf(EncoderSide side) { return side == EncoderSide::kLeft ? "left" : "right"; }

std::string gyroNote(const EncoderTests& tests) {
    return tests.spin.has_gyro ? "" : " If it was turned the other way round, spin it again.";
}

Words silentWords(const EncoderFinding& finding) {
    if (finding.side == EncoderSide::kBoth) {
        return {"Neither encoder counted while it was pushed.",
                "Check the encoders' plugs and supply, or push it again."};
    }
    return {"The " + nameOf(finding.side) + " encoder does not count.",
            "Check its plug, its supply and that its disc turns with the wheel."};
}

Words reversedWords(const EncoderFinding& finding) {
    return {"The " + nameOf(finding.side) + " encoder counts backwards.",
            "Exchange its two signal wires, or change its sign in the robot's firmware."};
}

std::string ratioAdviceOfOne(const EncoderFinding& finding, double diameter_m) {
    const std::string key = nameOf(finding.side) + "_wheel_diameter_m";
    return "If one of its two signal wires is broken, it counts half; else check its disc and "
           "gear, or set " +
           key + " to " + shortNumber(diameter_m / finding.factor, 4) + ".";
}

std::string ratioAdvice(const EncoderFinding& finding, const VehicleGeometry& geometry) {
    if (const auto whole = nearbyFactor(finding.factor)) {
        return "Set ticks_per_revolution to " +
               shortNumber(geometry.ticks_per_revolution * *whole, 6) +
               ": each line of a disc may count 1, 2 or 4 times, and a motor's encoder counts a "
               "gear's ratio more.";
    }
    const double mean_m = 0.5 * (geometry.left_wheel_diameter_m + geometry.right_wheel_diameter_m);
    return "Measure a wheel: its diameter should be " +
           shortNumber(1e3 * mean_m / finding.factor, 4) +
           " mm. If it is not, ticks_per_revolution should be " +
           shortNumber(geometry.ticks_per_revolution * finding.factor, 4) + ".";
}

Words ratioWords(const EncoderFinding& finding, const VehicleGeometry& geometry) {
    const std::string times = factorText(finding.factor) + " times what it should.";
    if (finding.side == EncoderSide::kBoth) {
        return {"The distance by the encoders is " + times, ratioAdvice(finding, geometry)};
    }
    const double diameter_m = finding.side == EncoderSide::kLeft ? geometry.left_wheel_diameter_m
                                                                 : geometry.right_wheel_diameter_m;
    return {"The " + nameOf(finding.side) + " encoder counts " + times,
            ratioAdviceOfOne(finding, diameter_m)};
}

Words missingWords(const EncoderFinding& finding, const VehicleGeometry& geometry) {
    const double counts = finding.factor * geometry.ticks_per_revolution;
    return {"The " + nameOf(finding.side) + " encoder misses about " + shortNumber(counts) +
                " counts at one place of each revolution.",
            "Look for a missing magnet, a broken tooth or dirt on its disc."};
}

// `asked_backwards`: the operator said that he would push it so.
Words pushWords(bool asked_backwards) {
    const std::string asked = asked_backwards ? "backwards" : "forwards";
    return {"It was pushed " + std::string(asked_backwards ? "forwards" : "backwards") +
                ", or its front and back are mixed up.",
            "Push it " + asked +
                "; if the same is said, exchange left and right and change the signs of both."};
}

Words spinWords(const EncoderFinding& finding, const EncoderTests& tests) {
    const std::string asked = shortNumber(degFromRad(std::abs(tests.turn_rad)), 3) + "°";
    switch (finding.fault) {
        case EncoderFault::kSpunBackwards:
            return {"Encoders and gyro say that it was turned the other way round.",
                    std::string("Spin it again, ") +
                        (tests.turn_rad < 0.0 ? "clockwise" : "counter-clockwise") +
                        " as seen from above."};
        case EncoderFault::kSpunByOtherAngle:
            return {"Encoders and gyro say that it was turned by " +
                        shortNumber(degFromRad(finding.factor * std::abs(tests.turn_rad)), 3) +
                        "°, not by " + asked + ".",
                    "Spin it again, or say how many turns it was."};
        default:
            return {
                "It was not turned on the spot, or an encoder does not tell backwards from "
                "forwards.",
                "Spin it again; if the same is said, check both signal wires of each encoder."};
    }
}

Words wordsOf(const EncoderFinding& finding, const Vehicle& vehicle, const EncoderTests& tests) {
    switch (finding.fault) {
        case EncoderFault::kSilent:
            return silentWords(finding);
        case EncoderFault::kSometimesSilent:
            return {"The " + nameOf(finding.side) + " encoder counted in one of the tests only.",
                    "Check its plug; turn the robot on the spot, not about a wheel."};
        case EncoderFault::kReversed:
            return reversedWords(finding);
        case EncoderFault::kSwapped:
            return {"Left and right are swapped.",
                    "Exchange the encoders' plugs, or the two in the robot's firmware." +
                        gyroNote(tests)};
        case EncoderFault::kWrongRatio:
            return ratioWords(finding, vehicle.geometry);
        case EncoderFault::kWrongWheelbase:
            return {"The turning by the encoders is " + factorText(finding.factor) +
                        " times what it was.",
                    "Measure between the wheels' middles: wheelbase_m should be about " +
                        shortNumber(vehicle.geometry.wheelbase_m * finding.factor, 2) + "."};
        case EncoderFault::kMissingCounts:
            return missingWords(finding, vehicle.geometry);
        case EncoderFault::kGyroReversed:
            return {"The gyro turns the other way round than the robot.",
                    "Mount it the other way up, or change its sign in the robot's firmware."};
        case EncoderFault::kPushedBackwards:
            return pushWords(tests.distance_m < 0.0);
        case EncoderFault::kSpunBackwards:
        case EncoderFault::kSpunByOtherAngle:
        case EncoderFault::kNotOnTheSpot:
            break;
    }
    return spinWords(finding, tests);
}

}  // namespace

std::string factorText(double factor) {
    if (const auto whole = nearbyFactor(factor)) {
        return *whole < 1.0 ? "1/" + shortNumber(1.0 / *whole) : shortNumber(*whole);
    }
    return shortNumber(factor, 3);
}

void addWords(EncoderFinding& finding, const Vehicle& vehicle, const EncoderTests& tests) {
    Words words = wordsOf(finding, vehicle, tests);
    finding.sentence = std::move(words.sentence);
    finding.advice = std::move(words.advice);
}

}  // namespace hedr
