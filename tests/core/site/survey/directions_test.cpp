#include "core/site/survey/directions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <sstream>
#include <vector>

#include "core/geometry/angle.h"
#include "core/simulation/building.h"
#include "core/simulation/random.h"
#include "tests/core/site/survey/aimless_sheets.h"
#include "tests/core/site/survey/direction_error.h"
#include "tests/core/site/survey/drawn_sheet.h"

namespace hedr {
namespace {

// What happens to plans, by chance.
SheetStyle styleOf(std::uint64_t seed) {
    Random random(7919 * seed);
    const auto sometimes = [&](double share) { return random.uniform() < share; };
    SheetStyle style;
    style.seed = seed;
    style.resolution_m = random.uniform(0.1, 0.15);
    style.turned_rad = random.uniform(-kPi, kPi);
    style.hollow = sometimes(0.4);
    style.furniture = sometimes(0.5);
    style.hatched_rad = sometimes(0.3) ? kPi / 4 : sometimes(0.2) ? random.uniform(0.3, 1.2) : 0.0;
    style.light_on_dark = sometimes(0.2);
    style.noise = sometimes(0.5) ? random.uniform(0.0, 25.0) : 0.0;
    style.jpeg_quality = sometimes(0.4) ? static_cast<int>(random.uniform(20.0, 90.0)) : 0;
    style.shade = sometimes(0.3) ? 0.6 : 0.0;
    style.photographed = sometimes(0.3);
    return style;
}

FloorPlan floorOf(std::uint64_t seed) {
    switch (seed % 3) {
        case 0:
            return buildingWithDiagonalWing().floor;
        case 1:
            return sampleBuilding().floor;
        default:
            return buildingWithHall().floor;
    }
}

std::string described(std::uint64_t seed, const SheetStyle& style) {
    std::ostringstream text;
    text << "seed " << seed << (seed % 3 == 0 ? ", wing at 45" : "")
         << (style.hollow ? ", hollow walls" : "") << (style.furniture ? ", furniture" : "");
    if (style.hatched_rad != 0.0) text << ", hatched at " << degFromRad(style.hatched_rad);
    if (style.noise > 0.0) text << ", noise " << style.noise;
    if (style.jpeg_quality > 0) text << ", JPEG " << style.jpeg_quality;
    if (style.light_on_dark) text << ", night";
    if (style.shade > 0.0) text << ", shade";
    if (style.photographed) text << ", photo";
    return text.str();
}

double measuredError_deg(std::uint64_t seed) {
    const SheetStyle style = styleOf(seed);
    const auto directions = findDirections(drawnSheet(floorOf(seed), style));
    const double error = error_deg(*directions, style.turned_rad);
    std::cout << described(seed, style) << ": error " << error << " deg, sigma "
              << degFromRad(directions->sigma_rad) << " deg, confidence " << directions->confidence
              << '\n';
    return error;
}

class DirectionsOfSheet : public testing::TestWithParam<int> {};

TEST_P(DirectionsOfSheet, AreRightToATenthOfADegree) {
    EXPECT_NEAR(measuredError_deg(static_cast<std::uint64_t>(GetParam())), 0.0, 0.1);
}

INSTANTIATE_TEST_SUITE_P(Seeds, DirectionsOfSheet, testing::Range(1, 25));

// The same of many more: --gtest_also_run_disabled_tests.
TEST(FindDirections, DISABLED_MeasuresManySheets) {
    int wrong = 0;
    for (std::uint64_t seed = 10'000; seed < 10'300; ++seed) {
        wrong += std::abs(measuredError_deg(seed)) <= 0.5 ? 0 : 1;
    }
    EXPECT_EQ(wrong, 0);
}

// The finest levels of a large tiled plan stay in their file.
TEST(FindDirections, NeedsOnlyTheLevelThatItLooksAt) {
    PlanImage plan = drawnSheet(sampleBuilding().floor, {.resolution_m = 0.12});
    const PlanLevel& drawn = plan.levels.front();
    plan.levels.insert(plan.levels.begin(), {16 * drawn.width_px, 16 * drawn.height_px, 1});
    const auto directions = findDirections(plan);
    ASSERT_TRUE(directions && directions->direction_rad);
    EXPECT_NEAR(error_deg(*directions, 0.0), 0.0, 0.1);
}

TEST(FindDirections, TakesTheMiddleOfAScannersSkew) {
    const SheetStyle style{.resolution_m = 0.12, .skewed_rad = radFromDeg(0.4)};
    const auto directions = findDirections(drawnSheet(sampleBuilding().floor, style));
    ASSERT_TRUE(directions && directions->direction_rad);
    EXPECT_NEAR(error_deg(*directions, 0.0), 0.0, 0.45);
}

// How often the direction is right to 0.5 degrees, by the confidence that it comes with.
TEST(FindDirections, DISABLED_MeasuresConfidence) {
    struct Tenth {
        int count = 0;
        double confidence = 0.0;
        int right = 0;
    };
    std::array<Tenth, 10> tenths;
    for (std::uint64_t seed = 50'000; seed < 50'400; ++seed) {
        const MixedSheet sheet = mixedSheet(seed);
        const auto found = findDirections(sheet.plan);
        auto& tenth = tenths[static_cast<std::size_t>(std::min(9.0, 10.0 * found->confidence))];
        ++tenth.count;
        tenth.confidence += found->confidence;
        const bool right = std::abs(error_deg(*found, sheet.direction_rad)) <= 0.5;
        tenth.right += right && !sheet.aimless ? 1 : 0;
    }
    for (const Tenth& tenth : tenths) {
        std::cout << tenth.count << " sheets: mean confidence " << tenth.confidence / tenth.count
                  << ", right " << static_cast<double>(tenth.right) / tenth.count << '\n';
    }
    EXPECT_GE(100 * (tenths[8].right + tenths[9].right), 85 * (tenths[8].count + tenths[9].count))
        << "confident, and wrong";
}

struct AimlessKind {
    const char* name;
    Aimless kind;
};

void PrintTo(const AimlessKind& kind, std::ostream* stream) { *stream << kind.name; }

class DirectionsOfAimless : public testing::TestWithParam<AimlessKind> {};

TEST_P(DirectionsOfAimless, AreNone) {
    const auto directions = findDirections(aimlessSheet(GetParam().kind, 1));
    ASSERT_TRUE(directions);
    EXPECT_FALSE(directions->direction_rad) << "confidence " << directions->confidence;
    std::cout << GetParam().name << ": confidence " << directions->confidence << '\n';
}

INSTANTIATE_TEST_SUITE_P(Kinds, DirectionsOfAimless,
                         testing::Values(AimlessKind{"rings", Aimless::kRings},
                                         AimlessKind{"spiral", Aimless::kSpiral},
                                         AimlessKind{"curves", Aimless::kCurves},
                                         AimlessKind{"round_building", Aimless::kRoundBuilding},
                                         AimlessKind{"text", Aimless::kText},
                                         AimlessKind{"fields", Aimless::kFields},
                                         AimlessKind{"star_of_walls", Aimless::kStarOfWalls},
                                         AimlessKind{"noise", Aimless::kNoise}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(FindDirections, SaysWhatIsWrong) {
    const auto none = findDirections({});
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, ErrorCode::kNoData);
    const auto canceled =
        findDirections(aimlessSheet(Aimless::kRings, 1), [](double share) { return share < 0.5; });
    ASSERT_FALSE(canceled);
    EXPECT_EQ(canceled.error().code, ErrorCode::kCanceled);
}

TEST(FindDirections, SurvivesOddPictures) {
    for (const auto& [width, height] : {std::array{1, 1}, std::array{1, 700}, std::array{3, 2}}) {
        const auto count = static_cast<std::size_t>(width * height);
        const PlanLevel level{width, height, 1,
                              std::make_shared<std::vector<std::uint8_t>>(count, std::uint8_t{9})};
        const auto directions = findDirections({{}, {level}, {}});
        ASSERT_TRUE(directions);
        EXPECT_FALSE(directions->direction_rad);
    }
}

TEST(PlacementsAlong, TurnAboutTheMiddleTheNearestFirst) {
    const PlanPlacement placement{0.1, {{5.0, -2.0}, radFromDeg(20.0)}};
    const Point<Plan> middle{200.0, 100.0};
    const PlanDirections directions{.direction_rad = radFromDeg(80.0)};
    // The plan's direction lies at 100 degrees, the world's at 3: 7 degrees clockwise at least.
    const auto placements = placementsAlong(placement, 400, 200, directions, radFromDeg(3.0));
    const std::array turns_deg{-7.0, 83.0, -97.0, 173.0};
    for (std::size_t i = 0; i < placements.size(); ++i) {
        const double turn = placements[i].origin.heading_rad - placement.origin.heading_rad;
        EXPECT_NEAR(degFromRad(turn), turns_deg[i], 1e-9);
        const Vector<World> moved =
            worldFromPlan(placements[i], 200) * middle - worldFromPlan(placement, 200) * middle;
        EXPECT_NEAR(moved.length(), 0.0, 1e-9);
        EXPECT_EQ(placements[i].resolution_m, placement.resolution_m);
    }
}

TEST(PlacementsAlong, KeepThePlacementWhereThereIsNoDirection) {
    const PlanPlacement placement{0.1, {{5.0, -2.0}, 0.3}};
    const auto placements = placementsAlong(placement, 400, 200, {}, 1.0);
    EXPECT_NEAR(placements[0].origin.heading_rad, 0.3, 1e-12);
    EXPECT_NEAR(placements[0].origin.position.x, 5.0, 1e-9);
}

}  // namespace
}  // namespace hedr
