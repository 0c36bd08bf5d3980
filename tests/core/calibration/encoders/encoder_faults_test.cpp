// Faults of encoders, each in many robots.
#include <gtest/gtest.h>

#include <cstdio>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tests/core/calibration/encoders/handled_robot.h"

namespace hedr {
namespace {

using test::checked;
using test::EncoderFaultCase;

using Found = std::vector<std::pair<EncoderFault, EncoderSide>>;

// How many of so many robots were told exactly what they have.
int rightlyTold(const EncoderFaultCase& fault, int robots) {
    int right = 0;
    std::map<std::string, int> wrong;
    for (int seed = 1; seed <= robots; ++seed) {
        const EncoderCheck check = checked(fault, static_cast<std::uint64_t>(seed));
        Found found;
        std::string text;
        for (const EncoderFinding& finding : check.findings) {
            found.emplace_back(finding.fault, finding.side);
            text += finding.sentence + ' ';
        }
        if (found == fault.findings)
            ++right;
        else
            ++wrong[text.empty() ? check.calibration.reason : text];
    }
    std::printf("%d of %d\n", right, robots);
    for (const auto& [text, count] : wrong) std::printf("  %d times: %s\n", count, text.c_str());
    return right;
}

class EncoderFaults : public testing::TestWithParam<EncoderFaultCase> {};

TEST_P(EncoderFaults, DISABLED_AreNamedIn97PercentOf1000Robots) {
    EXPECT_GE(rightlyTold(GetParam(), 1000), 970);
}

TEST_P(EncoderFaults, AreNamedInAlmostAllOf40Robots) { EXPECT_GE(rightlyTold(GetParam(), 40), 38); }

using enum EncoderFault;
using enum EncoderSide;

INSTANTIATE_TEST_SUITE_P(
    All, EncoderFaults,
    testing::Values(
        EncoderFaultCase{"healthy", {}, {}}, EncoderFaultCase{"healthy_far", {}, {}, true},
        EncoderFaultCase{"swapped", {.swapped = true}, {{kSwapped, kBoth}}},
        EncoderFaultCase{"left_reversed", {.left = -1.0}, {{kReversed, kLeft}}},
        EncoderFaultCase{"right_reversed", {.right = -1.0}, {{kReversed, kRight}}},
        EncoderFaultCase{"both_reversed",
                         {.left = -1.0, .right = -1.0},
                         {{kReversed, kLeft}, {kReversed, kRight}}},
        EncoderFaultCase{"left_dead", {.left = 0.0}, {{kSilent, kLeft}}},
        EncoderFaultCase{"right_dead", {.right = 0.0}, {{kSilent, kRight}}},
        EncoderFaultCase{"four_times", {.left = 4.0, .right = 4.0}, {{kWrongRatio, kBoth}}},
        EncoderFaultCase{"half", {.left = 0.5, .right = 0.5}, {{kWrongRatio, kBoth}}},
        EncoderFaultCase{"a_tenth", {.left = 0.1, .right = 0.1}, {{kWrongRatio, kBoth}}},
        EncoderFaultCase{"a_quarter_more", {.left = 1.25, .right = 1.25}, {{kWrongRatio, kBoth}}},
        EncoderFaultCase{"left_half", {.left = 0.5}, {{kWrongRatio, kLeft}}},
        EncoderFaultCase{"right_three_tenths_more", {.right = 1.3}, {{kWrongRatio, kRight}}},
        EncoderFaultCase{"wheelbase", {.wheelbase = 1.4}, {{kWrongWheelbase, kBoth}}},
        EncoderFaultCase{"gyro_reversed", {.gyro = -1.0}, {{kGyroReversed, kBoth}}},
        EncoderFaultCase{"left_gap", {.left_gap = 0.05}, {{kMissingCounts, kLeft}}, true},
        EncoderFaultCase{"right_gap", {.right_gap = 0.05}, {{kMissingCounts, kRight}}, true}),
    [](const auto& one) { return one.param.name; });

}  // namespace
}  // namespace hedr
