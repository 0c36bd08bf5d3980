#include "core/simulation/building.h"

#include <string>
#include <utility>

#include "core/site/floor_drawing.h"

namespace hedr {

namespace {

constexpr double kWidth_m = 90.0;
constexpr double kHeight_m = 54.0;
constexpr double kRoomDepth_m = 9.0;
constexpr int kRoomsPerRow = 8;
constexpr double kOuterWall_m = 0.32;
constexpr double kInnerWall_m = 0.20;
constexpr double kPlanResolution_m = 0.04;

struct Door {
    double middle_m;  // along the wall
    double width_m;
};

// A straight wall with gaps for its doors, which come in order.
void addWall(FloorPlan& floor, Point<Floor> from, Point<Floor> to, double thickness_m,
             const std::vector<Door>& doors = {}) {
    const Vector<Floor> along = (1.0 / (to - from).length()) * (to - from);
    Point<Floor> begin = from;
    for (const Door& door : doors) {
        floor.walls.push_back(
            {begin, from + (door.middle_m - 0.5 * door.width_m) * along, thickness_m});
        begin = from + (door.middle_m + 0.5 * door.width_m) * along;
    }
    floor.walls.push_back({begin, to, thickness_m});
}

void addOuterWalls(FloorPlan& floor) {
    const double corridor_middle_m = kRoomDepth_m + 1.5;
    addWall(floor, {0, 0}, {kWidth_m, 0}, kOuterWall_m);
    addWall(floor, {0, kHeight_m}, {kWidth_m, kHeight_m}, kOuterWall_m);
    addWall(floor, {0, 0}, {0, kHeight_m}, kOuterWall_m, {{corridor_middle_m, 2.0}});
    addWall(floor, {kWidth_m, 0}, {kWidth_m, kHeight_m}, kOuterWall_m,
            {{kHeight_m - corridor_middle_m, 2.0}});
}

// Rooms side by side between the outer wall and a corridor, each with a door to the corridor.
void addRoomRow(FloorPlan& floor, int first_number, double outer_y_m, double corridor_y_m) {
    const double room_width_m = kWidth_m / kRoomsPerRow;
    std::vector<Door> doors;
    for (int i = 0; i < kRoomsPerRow; ++i) {
        const double left = i * room_width_m;
        floor.rooms.push_back({std::to_string(first_number + i),
                               {left, std::min(outer_y_m, corridor_y_m)},
                               {left + room_width_m, std::max(outer_y_m, corridor_y_m)}});
        if (i > 0) addWall(floor, {left, outer_y_m}, {left, corridor_y_m}, kInnerWall_m);
        doors.push_back({left + (i % 2 == 0 ? 0.72 : 0.28) * room_width_m, 1.3});
    }
    addWall(floor, {0, corridor_y_m}, {kWidth_m, corridor_y_m}, kInnerWall_m, doors);
}

// A block between corridors with doors in its lower and upper wall.
void addBlock(FloorPlan& floor, const Room& room, const std::vector<Door>& lower,
              const std::vector<Door>& upper) {
    floor.rooms.push_back(room);
    const auto [left, bottom] = room.min;
    const auto [right, top] = room.max;
    addWall(floor, {left, bottom}, {right, bottom}, kInnerWall_m, lower);
    addWall(floor, {left, top}, {right, top}, kInnerWall_m, upper);
    addWall(floor, {left, bottom}, {left, top}, kInnerWall_m);
    addWall(floor, {right, bottom}, {right, top}, kInnerWall_m);
}

FloorPlan sampleFloor() {
    FloorPlan floor;
    addRoomRow(floor, 101, 0.0, kRoomDepth_m);
    addRoomRow(floor, 121, kHeight_m, kHeight_m - kRoomDepth_m);
    addBlock(floor, {"Lab A", {3.0, 12.0}, {27.25, 25.75}}, {}, {{18.0, 1.3}});
    addBlock(floor, {"Lab B", {3.0, 28.25}, {27.25, 42.0}}, {{6.0, 1.3}}, {});
    addBlock(floor, {"Atrium", {29.75, 12.0}, {60.25, 42.0}}, {{15.25, 3.0}}, {{15.25, 3.0}});
    addBlock(floor, {"Store", {62.75, 12.0}, {87.0, 25.75}}, {}, {{6.0, 2.0}});
    addBlock(floor, {"Workshop", {62.75, 28.25}, {87.0, 42.0}}, {{18.0, 2.0}}, {});
    addOuterWalls(floor);
    return floor;
}

CorridorGraph sampleCorridors() {
    CorridorGraph graph;
    graph.nodes = {{1.5, 10.5},  {28.5, 10.5}, {61.5, 10.5}, {88.5, 10.5}, {1.5, 27.0},
                   {28.5, 27.0}, {61.5, 27.0}, {88.5, 27.0}, {1.5, 43.5},  {28.5, 43.5},
                   {61.5, 43.5}, {88.5, 43.5}, {5.0, 10.5}};
    graph.edges = {{0, 12}, {12, 1}, {1, 2}, {2, 3},  {8, 9}, {9, 10}, {10, 11}, {0, 4}, {4, 8},
                   {1, 5},  {5, 9},  {2, 6}, {6, 10}, {3, 7}, {7, 11}, {4, 5},   {6, 7}};
    return graph;
}

}  // namespace

std::vector<std::size_t> CorridorGraph::neighbours(std::size_t node) const {
    std::vector<std::size_t> found;
    for (const auto& [a, b] : edges) {
        if (a == node) found.push_back(b);
        if (b == node) found.push_back(a);
    }
    return found;
}

double CorridorGraph::length_m(std::size_t from, std::size_t to) const {
    return (nodes[to] - nodes[from]).length();
}

Building sampleBuilding() {
    return {.floor = sampleFloor(),
            .corridors = sampleCorridors(),
            .home = 12,
            .first_towards = 1,
            .origin = {}};
}

PlanImage planOf(const Building& building) {
    return drawFloorPlan(building.floor, kPlanResolution_m, building.origin);
}

}  // namespace hedr
