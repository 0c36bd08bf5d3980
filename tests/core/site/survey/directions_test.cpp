#include "core/site/survey/directions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <vector>

#include "core/geometry/angle.h"
#include "core/simulation/building.h"
#include "core/simulation/random.h"
#include "tests/core/site/survey/aimless_sheets.h"
#include "tests/core/site/survey/drawn_sheet.h"

namespace hedr {
namespace {

namespace fs = std::filesystem;

const fs::path kMaps = fs::path(HEDR_SOURCE_DIR) / "../shared/data/maps";

// Degrees from the nearest right angle to the truth; NaN where no direction was found.
double error_deg(const PlanDirections& directions, double truth_rad) {
    if (!directions.direction_rad) return std::nan("");
    return degFromRad(deviationFromGrid(*directions.direction_rad - truth_rad, kPi / 2));
}

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

// Two points near one face of a long straight wall, picked by eye in the picture.
struct PickedWall {
    Point<Plan> from{};
    Point<Plan> to{};
};

struct RobotMap {
    const char* name;
    std::vector<PickedWall> walls;
};

void PrintTo(const RobotMap& map, std::ostream* stream) { *stream << map.name; }

// The wall's own angle: the straight line by least squares through the wall cells
// within a few pixels of the picked line, narrowed in steps.
struct WallLine {
    double angle_rad = 0.0;
    double length_px = 0.0;
    double scatter_px = 0.0;
};

int greyAt(const PlanLevel& map, int column, int row) {
    return (*map.pixels)[static_cast<std::size_t>(row) * static_cast<std::size_t>(map.width_px) +
                         static_cast<std::size_t>(column)];
}

// Dark cells beside free ones.
std::vector<Point<Plan>> rimOf(const PlanLevel& map) {
    const auto isFree = [&](int column, int row) { return greyAt(map, column, row) >= 206; };
    std::vector<Point<Plan>> rim;
    for (int row = 1; row + 1 < map.height_px; ++row) {
        for (int column = 1; column + 1 < map.width_px; ++column) {
            const bool beside = isFree(column - 1, row) || isFree(column + 1, row) ||
                                isFree(column, row - 1) || isFree(column, row + 1);
            if (beside && greyAt(map, column, row) < 130) rim.push_back({column + 0.5, row + 0.5});
        }
    }
    return rim;
}

WallLine lineAt(const std::vector<Point<Plan>>& rim, const PickedWall& wall) {
    const Vector<Plan> way = wall.to - wall.from;
    const double length_px = way.length();
    const Vector<Plan> along = (1.0 / length_px) * way;
    double offset = 0.0;
    double slope = 0.0;
    double scatter = 0.0;
    for (double reach = 6.0; reach > 2.5; reach *= 0.85) {
        Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
        Eigen::Vector2d right = Eigen::Vector2d::Zero();
        double squares = 0.0;
        for (const Point<Plan>& p : rim) {
            const Vector<Plan> d = p - wall.from;
            const double t = along.x * d.x + along.y * d.y;
            const double aside = along.x * d.y - along.y * d.x;
            const double rest = aside - (offset + slope * t);
            if (t < 0.0 || t > length_px || std::abs(rest) > reach) continue;
            const Eigen::Vector2d row(1.0, t);
            normal += row * row.transpose();
            right += aside * row;
            squares += rest * rest;
        }
        if (normal(0, 0) < 0.3 * length_px) return {};
        scatter = std::sqrt(squares / normal(0, 0));
        const Eigen::Vector2d line = normal.inverse() * right;
        offset = line(0);
        slope = line(1);
    }
    return {-std::atan2(along.y + slope * along.x, along.x - slope * along.y), length_px, scatter};
}

// The mean of the walls' angles by the squares of their lengths, without those that are not
// straight to 1.2 px.
double pickedDirection_rad(const PlanLevel& map, const std::vector<PickedWall>& walls) {
    const std::vector<Point<Plan>> rim = rimOf(map);
    double reference = std::nan("");
    double sum = 0.0;
    double moment = 0.0;
    for (const PickedWall& wall : walls) {
        const WallLine line = lineAt(rim, wall);
        if (line.length_px == 0.0 || line.scatter_px > 1.2) continue;
        if (std::isnan(reference)) reference = line.angle_rad;
        const double weight = line.length_px * line.length_px;
        sum += weight;
        moment += weight * deviationFromGrid(line.angle_rad - reference, kPi / 2);
    }
    return reference + moment / sum;
}

class DirectionsOfMap : public testing::TestWithParam<RobotMap> {};

TEST_P(DirectionsOfMap, AreThoseOfItsLongWalls) {
    const fs::path file = kMaps / GetParam().name / "map.yaml";
    if (!fs::exists(file)) GTEST_SKIP() << "no " << file;
    const auto plan = loadPlan(file);
    ASSERT_TRUE(plan);
    const auto directions = findDirections(*plan);
    ASSERT_TRUE(directions && directions->direction_rad) << "confidence " << directions->confidence;
    const double truth_rad = pickedDirection_rad(plan->levels.front(), GetParam().walls);
    const double error = error_deg(*directions, truth_rad);
    std::cout << GetParam().name << ": " << degFromRad(*directions->direction_rad)
              << " deg, off the walls picked by eye by " << error << " deg"
              << ", sigma " << degFromRad(directions->sigma_rad) << ", confidence "
              << directions->confidence << '\n';
    EXPECT_NEAR(error, 0.0, 0.5);
}

INSTANTIATE_TEST_SUITE_P(Maps, DirectionsOfMap,
                         testing::Values(RobotMap{"aces",
                                                  {{{565, 196}, {985, 204}},
                                                   {{158, 192}, {152, 513}},
                                                   {{152, 567}, {441, 572}},
                                                   {{564, 197}, {560, 420}},
                                                   {{486, 669}, {481, 938}},
                                                   {{987, 207}, {983, 524}}}},
                                         RobotMap{"belgioioso",
                                                  {{{320, 308}, {240, 924}},
                                                   {{334, 592}, {291, 942}},
                                                   {{271, 1146}, {238, 1389}},
                                                   {{219, 1409}, {201, 1549}},
                                                   {{221, 1409}, {328, 1424}},
                                                   {{180, 1133}, {361, 1158}}}},
                                         RobotMap{"csail",
                                                  {{{626, 566}, {602, 804}},
                                                   {{410, 544}, {626, 565}},
                                                   {{383, 782}, {602, 806}},
                                                   {{372, 816}, {593, 841}},
                                                   {{636, 734}, {601, 1079}},
                                                   {{612, 1082}, {760, 1098}},
                                                   {{673, 391}, {645, 682}}}},
                                         RobotMap{"fr079",
                                                  {{{390, 34}, {470, 40}},
                                                   {{560, 47}, {700, 57}},
                                                   {{400, 143}, {475, 149}},
                                                   {{490, 150}, {640, 163}},
                                                   {{365, 190}, {435, 197}},
                                                   {{460, 203}, {500, 205}},
                                                   {{520, 207}, {640, 216}},
                                                   {{655, 217}, {698, 221}},
                                                   {{435, 310}, {480, 314}},
                                                   {{530, 317}, {665, 329}},
                                                   {{20, 112}, {105, 120}},
                                                   {{205, 125}, {285, 134}},
                                                   {{140, 286}, {270, 297}},
                                                   {{18, 112}, {12, 155}},
                                                   {{305, 195}, {298, 285}},
                                                   {{437, 245}, {434, 308}},
                                                   {{545, 205}, {540, 290}},
                                                   {{108, 70}, {104, 118}},
                                                   {{140, 15}, {137, 70}}}},
                                         RobotMap{"intel_lab",
                                                  {{{205, 149}, {344, 145}},
                                                   {{228, 489}, {445, 479}},
                                                   {{188, 521}, {284, 516}},
                                                   {{66, 112}, {69, 282}},
                                                   {{493, 285}, {503, 460}},
                                                   {{238, 158}, {239, 267}},
                                                   {{85, 322}, {90, 450}}}},
                                         RobotMap{"mit_building_31",
                                                  {{{270, 549}, {650, 549}},
                                                   {{196, 93}, {279, 93}},
                                                   {{196, 174}, {281, 174}},
                                                   {{62, 306}, {160, 306}},
                                                   {{196, 357}, {281, 357}},
                                                   {{196, 438}, {281, 438}},
                                                   {{196, 519}, {281, 519}},
                                                   {{402, 225}, {402, 387}},
                                                   {{205, 54}, {340, 54}},
                                                   {{440, 55}, {640, 53}},
                                                   {{319, 415}, {398, 415}}}},
                                         RobotMap{"penn_levine_lobby",
                                                  {{{265, 425}, {410, 368}},
                                                   {{495, 152}, {596, 405}},
                                                   {{385, 198}, {495, 153}},
                                                   {{320, 567}, {440, 518}},
                                                   {{214, 522}, {300, 720}},
                                                   {{505, 445}, {596, 408}}}},
                                         RobotMap{"seattle",
                                                  {{{45, 40}, {222, 45}},
                                                   {{43, 40}, {40, 240}},
                                                   {{222, 47}, {218, 250}},
                                                   {{262, 112}, {480, 119}},
                                                   {{510, 119}, {700, 126}},
                                                   {{395, 187}, {490, 190}},
                                                   {{730, 127}, {910, 133}},
                                                   {{20, 268}, {240, 273}}}},
                                         RobotMap{"wean_hall",
                                                  {{{102, 110}, {75, 500}},
                                                   {{127, 130}, {92, 515}},
                                                   {{95, 518}, {270, 540}},
                                                   {{70, 540}, {250, 556}},
                                                   {{142, 550}, {137, 650}},
                                                   {{165, 553}, {160, 655}}}},
                                         RobotMap{"willow_garage",
                                                  {{{292, 378}, {340, 268}},
                                                   {{266, 490}, {312, 390}},
                                                   {{258, 106}, {220, 190}},
                                                   {{121, 187}, {91, 272}},
                                                   {{315, 82}, {398, 116}},
                                                   {{412, 124}, {480, 150}},
                                                   {{208, 418}, {260, 440}},
                                                   {{374, 478}, {338, 566}}}}),
                         [](const auto& test) { return std::string(test.param.name); });

// Drawn by computers, square to the sheet.
TEST(FindDirections, FindsTheSheetsOwnDirectionInFloorPlans) {
    for (const char* name : {"plan1.png", "plan3.png", "plan4.png", "plan5.png"}) {
        const fs::path file = kMaps / "floor_plans" / name;
        if (!fs::exists(file)) GTEST_SKIP() << "no " << file;
        const auto directions = findDirections(*loadPlan(file));
        ASSERT_TRUE(directions);
        EXPECT_NEAR(error_deg(*directions, 0.0), 0.0, 0.1) << name;
        EXPECT_GT(directions->confidence, 0.9) << name;
    }
}

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
