#include <gtest/gtest.h>

#include <filesystem>
#include <iostream>
#include <vector>

#include "core/geometry/angle.h"
#include "core/site/survey/directions.h"
#include "tests/core/site/survey/direction_error.h"
#include "tests/core/site/survey/picked_walls.h"

namespace hedr {
namespace {

namespace fs = std::filesystem;

const fs::path kMaps = fs::path(HEDR_SOURCE_DIR) / "../shared/data/maps";

struct RobotMap {
    const char* name;
    std::vector<PickedWall> walls;
};

void PrintTo(const RobotMap& map, std::ostream* stream) { *stream << map.name; }

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

}  // namespace
}  // namespace hedr
