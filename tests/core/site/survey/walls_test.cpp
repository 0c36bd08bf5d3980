#include "core/site/survey/walls.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "core/geometry/angle.h"
#include "core/simulation/building.h"
#include "core/text/csv.h"
#include "core/text/text_file.h"
#include "tests/core/site/survey/drawn_sheet.h"

namespace hedr {
namespace {

namespace fs = std::filesystem;

const fs::path kData = fs::path(HEDR_SOURCE_DIR) / "../shared/data";

bool isIn(const Wall& wall, Point<Floor> p, double margin_m) {
    const Vector<Floor> along = (1.0 / (wall.to - wall.from).length()) * (wall.to - wall.from);
    const Vector<Floor> d = p - wall.from;
    const double half_m = 0.5 * wall.thickness_m + margin_m;
    const double way_m = along.x * d.x + along.y * d.y;
    return std::abs(along.x * d.y - along.y * d.x) <= half_m && way_m >= -half_m &&
           way_m <= (wall.to - wall.from).length() + half_m;
}

bool isWall(const FloorPlan& floor, Point<Floor> p, double margin_m = 0.0) {
    return std::ranges::any_of(floor.walls,
                               [&](const Wall& wall) { return isIn(wall, p, margin_m); });
}

struct Agreement {
    double walls_iou = 0.0;  // walls found and true: intersection over union
    int stray = 0;           // wall cells more than 0.4 m from any wall
};

Agreement agreementOf(const FreeSpace& space, const FloorPlan& floor,
                      const Transform<Plan, Floor>& plan_from_floor) {
    const Transform<Floor, Plan> floor_from_plan = plan_from_floor.inverse();
    double both = 0.0;
    double either = 0.0;
    Agreement agreement;
    for (int row = 0; row < space.height; ++row) {
        for (int column = 0; column < space.width; ++column) {
            const Point<Plan> p{(column + 0.5) * space.plan_px_per_cell,
                                (row + 0.5) * space.plan_px_per_cell};
            const Point<Floor> at = floor_from_plan * p;
            const bool found = space.at(p) == Cell::kWall;
            const bool near = isWall(floor, at, 0.4);
            const bool is = near && isWall(floor, at);
            both += found && is ? 1.0 : 0.0;
            either += found || is ? 1.0 : 0.0;
            agreement.stray += found && !near ? 1 : 0;
        }
    }
    agreement.walls_iou = both / either;
    return agreement;
}

// Whether a robot gets through the wall between the rooms and the corridors: the middles of all
// corridors and of all gaps of up to 2 m.
int closedDoors(const FreeSpace& space, const FloorPlan& floor,
                const Transform<Plan, Floor>& plan_from_floor) {
    int closed = 0;
    for (std::size_t i = 0; i + 1 < floor.walls.size(); ++i) {
        const Vector<Floor> gap = floor.walls[i + 1].from - floor.walls[i].to;
        if (gap.length() > 2.1 || isWall(floor, floor.walls[i].to + 0.5 * gap)) continue;
        const Vector<Floor> across = (1.0 / gap.length()) * Vector<Floor>{-gap.y, gap.x};
        bool open = true;
        for (double way_m = -1.5; way_m <= 1.5; way_m += 0.05) {
            const Point<Floor> at = floor.walls[i].to + 0.5 * gap + way_m * across;
            open = open && space.at(plan_from_floor * at) != Cell::kWall;
        }
        closed += open ? 0 : 1;
    }
    return closed;
}

struct Sheet {
    const char* name;
    SheetStyle style;
};

void PrintTo(const Sheet& sheet, std::ostream* stream) { *stream << sheet.name; }

class FreeSpaceOfSheet : public testing::TestWithParam<Sheet> {};

TEST_P(FreeSpaceOfSheet, HasTheWallsOfTheBuildingAndItsDoorsOpen) {
    const SheetStyle& style = GetParam().style;
    const FloorPlan floor = style.resolution_m < 0.04 ? office() : sampleBuilding().floor;
    const auto space = freeSpaceOf(drawnSheet(floor, style));
    ASSERT_TRUE(space) << space.error().detail;
    const Transform<Plan, Floor> plan_from_floor = sheetFromFloor(floor, style);
    const Agreement agreement = agreementOf(*space, floor, plan_from_floor);
    RecordProperty("walls_iou", std::to_string(agreement.walls_iou));
    EXPECT_GE(agreement.walls_iou, 0.75);
    EXPECT_EQ(agreement.stray, 0) << "text, furniture and doors are no walls";
    EXPECT_EQ(closedDoors(*space, floor, plan_from_floor), 0);
    for (const Room& room : floor.rooms) {
        const Point<Floor> middle = room.min + 0.5 * (room.max - room.min);
        EXPECT_EQ(space->at(plan_from_floor * middle), Cell::kFree) << room.name;
    }
    EXPECT_EQ(space->at({3.0, 3.0}), Cell::kUnknown) << "outside of the building";
}

INSTANTIATE_TEST_SUITE_P(
    Sheets, FreeSpaceOfSheet,
    testing::Values(
        Sheet{"building", {.resolution_m = 0.06}}, Sheet{"doors", {.resolution_m = 0.02}},
        Sheet{"turned", {.resolution_m = 0.02, .turned_rad = 0.3, .furniture = true}},
        Sheet{"office", {.resolution_m = 0.02, .furniture = true}},
        Sheet{"hollow", {.resolution_m = 0.02, .hollow = true, .furniture = true}},
        Sheet{"hollow_turned", {.resolution_m = 0.02, .turned_rad = 0.2, .hollow = true}},
        Sheet{"night", {.resolution_m = 0.02, .furniture = true, .light_on_dark = true}},
        Sheet{"night_hollow", {.resolution_m = 0.02, .hollow = true, .light_on_dark = true}},
        Sheet{"scan", {.resolution_m = 0.02, .furniture = true, .noise = 8.0, .jpeg_quality = 60}},
        Sheet{"photo", {.resolution_m = 0.02, .turned_rad = 0.05, .noise = 6.0, .shade = 0.5}},
        Sheet{"photo_hollow",
              {.resolution_m = 0.015,
               .hollow = true,
               .noise = 6.0,
               .shade = 0.5,
               .photographed = false}},
        Sheet{"hatched", {.resolution_m = 0.02, .hatched_rad = 0.8}},
        Sheet{"hatched_hollow", {.resolution_m = 0.02, .hollow = true, .hatched_rad = 0.8}}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(FreeSpaceOf, KeepsPillars) {
    FloorPlan floor = office();
    floor.walls.push_back({{10.0, 6.0}, {10.01, 6.0}, 0.5});  // 0.5 m x 0.5 m in the corridor
    const SheetStyle style{.resolution_m = 0.02};
    const auto space = freeSpaceOf(drawnSheet(floor, style));
    ASSERT_TRUE(space);
    EXPECT_EQ(space->at(sheetFromFloor(floor, style) * Point<Floor>{10.0, 6.0}), Cell::kWall);
    EXPECT_EQ(space->at(sheetFromFloor(floor, style) * Point<Floor>{10.0, 6.6}), Cell::kFree);
}

struct RobotMap {
    const char* name;
    const char* path_file;  // where the robot has been, from the folder of recordings
};

void PrintTo(const RobotMap& map, std::ostream* stream) { *stream << map.name; }

class FreeSpaceOfMap : public testing::TestWithParam<RobotMap> {};

TEST_P(FreeSpaceOfMap, HoldsTheWayOfTheRobot) {
    const fs::path map = kData / "maps" / GetParam().name / "map.yaml";
    if (!fs::exists(map)) GTEST_SKIP() << "no " << map;
    const auto plan = loadPlan(map);
    ASSERT_TRUE(plan) << plan.error().detail;
    const auto space = freeSpaceOf(*plan);
    ASSERT_TRUE(space);
    const fs::path path = kData / GetParam().path_file;
    const auto text = readTextFile(path);
    ASSERT_TRUE(text);
    auto rows = CsvReader::open(*text, path.string());
    ASSERT_TRUE(rows);
    const auto x = rows->require("x_m");
    const auto y = rows->require("y_m");
    ASSERT_TRUE(x && y);
    const Transform<Plan, World> plan_from_world = plan->worldFromPlan().inverse();
    int count = 0;
    int free = 0;
    while (rows->next().value()) {
        const Point<World> at{rows->number(*x).value(), rows->number(*y).value()};
        ++count;
        free += space->at(plan_from_world * at) == Cell::kFree ? 1 : 0;
    }
    ASSERT_GT(count, 100);
    RecordProperty("share", std::to_string(static_cast<double>(free) / count));
    EXPECT_GE(free, 0.99 * count) << free << " of " << count;
}

INSTANTIATE_TEST_SUITE_P(Maps, FreeSpaceOfMap,
                         testing::Values(RobotMap{"aces", "maps/aces/path.csv"},
                                         RobotMap{"belgioioso", "maps/belgioioso/path.csv"},
                                         RobotMap{"csail", "maps/csail/path.csv"},
                                         RobotMap{"fr079", "maps/fr079/path.csv"},
                                         RobotMap{"intel_lab", "maps/intel_lab/path.csv"},
                                         RobotMap{"seattle", "maps/seattle/path.csv"},
                                         RobotMap{"wean_hall", "wean_1/truth.csv"}),
                         [](const auto& test) { return std::string(test.param.name); });

PlanImage greyPlan(int width, int height, std::vector<std::uint8_t> pixels) {
    const PlanLevel level{width, height, 1,
                          std::make_shared<std::vector<std::uint8_t>>(std::move(pixels))};
    return {{}, {level}, {1.0, {}}};
}

TEST(FreeSpaceOf, TakesTheGreysOfARobotsMapAsTheyAre) {
    std::vector<std::uint8_t> pixels(100, 205);
    std::fill(pixels.begin(), pixels.begin() + 40, 254);
    pixels[5] = 0;
    const auto space = freeSpaceOf(greyPlan(10, 10, pixels));
    ASSERT_TRUE(space);
    EXPECT_EQ(space->at({5.5, 0.5}), Cell::kWall);
    EXPECT_EQ(space->at({5.5, 1.5}), Cell::kFree);
    EXPECT_EQ(space->at({5.5, 9.5}), Cell::kUnknown);
}

TEST(FreeSpaceOf, KnowsNothingOfAPhotoOfLand) {
    for (const char* name : {"spot_chicago_utm.tiff", "drone_ortho_center100.tif"}) {
        const fs::path file = kData / "maps/aerial" / name;
        if (!fs::exists(file)) GTEST_SKIP() << "no " << file;
        const auto plan = loadPlan(file);
        ASSERT_TRUE(plan);
        const auto space = freeSpaceOf(*plan);
        ASSERT_TRUE(space);
        EXPECT_EQ(std::ranges::count(space->cells, Cell::kUnknown), std::ssize(space->cells));
    }
}

// The finest levels of a large tiled plan stay in their file.
TEST(FreeSpaceOf, NeedsOnlyTheLevelThatItLooksAt) {
    PlanImage plan = drawnSheet(sampleBuilding().floor, {.resolution_m = 0.12});
    const auto small = freeSpaceOf(plan);
    const PlanLevel& drawn = plan.levels.front();
    plan.levels.insert(plan.levels.begin(), {16 * drawn.width_px, 16 * drawn.height_px, 1});
    const auto large = freeSpaceOf(plan);
    ASSERT_TRUE(small && large);
    EXPECT_EQ(large->cells, small->cells);
    EXPECT_EQ(large->plan_px_per_cell, 16.0 * small->plan_px_per_cell);
}

TEST(FreeSpaceOf, SaysWhatIsWrong) {
    const auto none = freeSpaceOf({});
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, ErrorCode::kNoData);
    const PlanImage plan = drawnSheet(sampleBuilding().floor, {.resolution_m = 0.4});
    const auto canceled = freeSpaceOf(plan, [](double share) { return share < 0.5; });
    ASSERT_FALSE(canceled);
    EXPECT_EQ(canceled.error().code, ErrorCode::kCanceled);
}

TEST(FreeSpaceOf, SurvivesOddPictures) {
    for (const auto& [width, height] : {std::array{1, 1}, std::array{1, 700}, std::array{2, 3}}) {
        for (const int grey : {0, 128, 255}) {
            const auto count = static_cast<std::size_t>(width * height);
            const auto space = freeSpaceOf(
                greyPlan(width, height, std::vector(count, static_cast<std::uint8_t>(grey))));
            ASSERT_TRUE(space);
            EXPECT_EQ(space->cells.size(), count);
        }
    }
}

TEST(WithStrokes, PaintsInTheOrderOfDrawing) {
    FreeSpace space{40, 20, 2.0, std::vector<Cell>(800, Cell::kUnknown)};
    const PlanPlacement placement{0.05, {{10.0, 20.0}, 0.0}};  // 80 x 40 px: 4 m x 2 m
    const std::vector<WallStroke> strokes{{WallPen::kWall, 0.4, {{10.5, 21.0}, {13.5, 21.0}}},
                                          {WallPen::kEraser, 0.8, {{12.0, 21.0}}}};
    space = withStrokes(std::move(space), placement, 40, strokes);
    const Transform<Plan, World> plan_from_world = worldFromPlan(placement, 40).inverse();
    const auto at = [&](double x, double y) {
        return space.at(plan_from_world * Point<World>{x, y});
    };
    EXPECT_EQ(at(11.0, 21.0), Cell::kWall);
    EXPECT_EQ(at(11.0, 21.15), Cell::kWall);
    EXPECT_EQ(at(11.0, 21.35), Cell::kUnknown);
    EXPECT_EQ(at(12.0, 21.0), Cell::kFree);
    EXPECT_EQ(at(12.0, 21.3), Cell::kFree);
    EXPECT_EQ(at(13.0, 21.0), Cell::kWall);
}

TEST(WithStrokes, LeavesNoGapInAThinSlantingLine) {
    FreeSpace space{50, 50, 1.0, std::vector<Cell>(2500, Cell::kFree)};
    const WallStroke stroke{WallPen::kWall, 0.001, {{0.0, 0.3}, {5.0, 3.9}}};
    space = withStrokes(std::move(space), {0.1, {}}, 50, std::array{stroke});
    for (int column = 1; column < 49; ++column) {
        const double middle = 50.0 - (3.0 + 0.72 * (column + 0.5));
        EXPECT_EQ(space.at({column + 0.5, middle}), Cell::kWall) << column;
    }
}

TEST(WithStrokes, PassesOverWhatLiesBesideThePlan) {
    const FreeSpace space{4, 4, 1.0, std::vector<Cell>(16, Cell::kFree)};
    const double nan = std::nan("");
    const std::vector<WallStroke> strokes{{WallPen::kWall, 0.2, {{1e12, -1e12}, {1e13, 0.0}}},
                                          {WallPen::kWall, 0.2, {{nan, nan}, {0.1, 0.1}}},
                                          {WallPen::kWall, 0.2, {}}};
    EXPECT_EQ(withStrokes(space, {0.1, {}}, 4, std::span(strokes).first(1)).cells, space.cells);
    EXPECT_EQ(withStrokes(space, {0.1, {}}, 4, strokes).cells.size(), 16U);
}

}  // namespace
}  // namespace hedr
