#include "core/simulation/building.h"

#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "core/geometry/angle.h"
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

struct Doors {
    std::vector<Door> atrium_lower{{15.25, 3.0}};
    std::vector<Door> atrium_upper{{15.25, 3.0}};
    std::vector<Door> east{{kHeight_m - kRoomDepth_m - 1.5, 2.0}};
};

void addOuterWalls(FloorPlan& floor, const Doors& doors) {
    const double corridor_middle_m = kRoomDepth_m + 1.5;
    addWall(floor, {0, 0}, {kWidth_m, 0}, kOuterWall_m);
    addWall(floor, {0, kHeight_m}, {kWidth_m, kHeight_m}, kOuterWall_m);
    addWall(floor, {0, 0}, {0, kHeight_m}, kOuterWall_m, {{corridor_middle_m, 2.0}});
    addWall(floor, {kWidth_m, 0}, {kWidth_m, kHeight_m}, kOuterWall_m, doors.east);
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

FloorPlan sampleFloor(const Doors& doors = {}) {
    FloorPlan floor;
    addRoomRow(floor, 101, 0.0, kRoomDepth_m);
    addRoomRow(floor, 121, kHeight_m, kHeight_m - kRoomDepth_m);
    addBlock(floor, {"Lab A", {3.0, 12.0}, {27.25, 25.75}}, {}, {{18.0, 1.3}});
    addBlock(floor, {"Lab B", {3.0, 28.25}, {27.25, 42.0}}, {{6.0, 1.3}}, {});
    addBlock(floor, {"Atrium", {29.75, 12.0}, {60.25, 42.0}}, doors.atrium_lower,
             doors.atrium_upper);
    addBlock(floor, {"Store", {62.75, 12.0}, {87.0, 25.75}}, {}, {{6.0, 2.0}});
    addBlock(floor, {"Workshop", {62.75, 28.25}, {87.0, 42.0}}, {{18.0, 2.0}}, {});
    addOuterWalls(floor, doors);
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

// A new node on the way from `a` to `b`.
std::size_t splitEdge(CorridorGraph& graph, std::size_t a, std::size_t b, Point<Floor> at) {
    const std::size_t node = graph.nodes.size();
    graph.nodes.push_back(at);
    std::erase_if(graph.edges, [a, b](const auto& edge) {
        return (edge[0] == a && edge[1] == b) || (edge[0] == b && edge[1] == a);
    });
    graph.edges.push_back({a, node});
    graph.edges.push_back({node, b});
    return node;
}

std::size_t addNode(CorridorGraph& graph, std::size_t from, Point<Floor> at) {
    graph.nodes.push_back(at);
    graph.edges.push_back({from, graph.nodes.size() - 1});
    return graph.nodes.size() - 1;
}

constexpr double kAtriumLeft_m = 29.75;
constexpr double kInside_m = 1.5;  // from a door's corridor node to the wall, and on into the hall

// Nodes in the corridor and in the atrium, at a door in its lower or upper wall.
struct Entrance {
    std::size_t corridor;
    std::size_t inside;
};

Entrance addLowerEntrance(CorridorGraph& graph, std::size_t a, std::size_t b, double x) {
    const std::size_t corridor = splitEdge(graph, a, b, {x, 10.5});
    return {corridor, addNode(graph, corridor, {x, 12.0 + kInside_m})};
}

Entrance addUpperEntrance(CorridorGraph& graph, std::size_t a, std::size_t b, double x) {
    const std::size_t corridor = splitEdge(graph, a, b, {x, 43.5});
    return {corridor, addNode(graph, corridor, {x, 42.0 - kInside_m})};
}

// A corridor's two walls, without their ends, where other corridors begin.
void addCorridorWalls(FloorPlan& floor, Point<Floor> from, double from_end_m, Point<Floor> to,
                      double to_end_m) {
    const Vector<Floor> along = (1.0 / (to - from).length()) * (to - from);
    const Vector<Floor> side{-1.5 * along.y, 1.5 * along.x};
    for (const double sign : {-1.0, 1.0})
        addWall(floor, from + sign * side + from_end_m * along,
                to + sign * side + (-to_end_m) * along, kInnerWall_m);
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
            .start = 12,
            .first_towards = 1,
            .home = 12,
            .origin = {}};
}

Building buildingWithHall() {
    Building building = sampleBuilding();
    const std::array<double, 2> lower{33.0, 57.0};
    const std::array<double, 2> upper{44.0, 48.0};
    Doors doors;
    doors.atrium_lower = {{lower[0] - kAtriumLeft_m, 2.0}, {lower[1] - kAtriumLeft_m, 2.0}};
    doors.atrium_upper = {{upper[0] - kAtriumLeft_m, 2.0}, {upper[1] - kAtriumLeft_m, 2.0}};
    building.floor = sampleFloor(doors);
    CorridorGraph& graph = building.corridors;
    const Entrance west = addLowerEntrance(graph, 1, 2, lower[0]);
    const Entrance east = addLowerEntrance(graph, west.corridor, 2, lower[1]);
    const Entrance north_west = addUpperEntrance(graph, 9, 10, upper[0]);
    const Entrance north_east = addUpperEntrance(graph, north_west.corridor, 10, upper[1]);
    graph.edges.push_back({west.inside, north_west.inside});
    graph.edges.push_back({east.inside, north_east.inside});
    return building;
}

Building buildingWithTask() {
    Building building = sampleBuilding();
    const double upper_m = 48.0;
    Doors doors;
    doors.atrium_upper = {{upper_m - kAtriumLeft_m, 2.0}};
    building.floor = sampleFloor(doors);
    CorridorGraph& graph = building.corridors;
    const Entrance south = addLowerEntrance(graph, 1, 2, 45.0);
    const Entrance north = addUpperEntrance(graph, 9, 10, upper_m);
    building.goal = addNode(graph, south.inside, {40.0, 24.0});
    building.task_at_goal = true;
    graph.edges.push_back({*building.goal, north.inside});
    return building;
}

Building buildingWithDiagonalWing() {
    Building building = sampleBuilding();
    Doors doors;
    doors.east = {{27.0, 5.5}, {43.5, 2.0}};
    building.floor = sampleFloor(doors);
    CorridorGraph& graph = building.corridors;
    constexpr std::size_t kHub = 7;
    const std::size_t north = addNode(graph, kHub, {110.5, 49.0});
    const std::size_t east = addNode(graph, north, {132.5, 27.0});
    const std::size_t south = addNode(graph, east, {110.5, 5.0});
    graph.edges.push_back({south, kHub});
    building.goal = east;
    const auto end_m = [](std::size_t node) { return node == kHub ? 4.8 : 1.5; };
    for (const auto& [a, b] : {std::pair{kHub, north}, {north, east}, {east, south}, {south, kHub}})
        addCorridorWalls(building.floor, graph.nodes[a], end_m(a), graph.nodes[b], end_m(b));
    return building;
}

Building buildingEnteredAslant(double offset_rad) {
    Building building = sampleBuilding();
    CorridorGraph& graph = building.corridors;
    const Entrance door = addLowerEntrance(graph, 1, 2, 45.0);
    const double heading_rad = offset_rad - 0.5 * kPi;
    const Vector<Floor> way{12.0 * std::cos(heading_rad), 12.0 * std::sin(heading_rad)};
    building.start = addNode(graph, door.inside, graph.nodes[door.inside] + (-1.0) * way);
    building.first_towards = door.inside;
    return building;
}

PlanImage planOf(const Building& building) {
    return drawFloorPlan(building.floor, kPlanResolution_m, building.origin);
}

}  // namespace hedr
