#include "core/track/track.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "core/geometry/angle.h"

namespace hedr {
namespace {

constexpr WorldBox kEverywhere = {{-1e9, -1e9}, {1e9, 1e9}};

using Line = std::vector<Point<World>>;

// A drive that goes straight, turns and now and then stands, with noise in its positions.
Line wander(std::size_t count, double step_m, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    Line line;
    Point<World> at{3.0, -2.0};
    double heading = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        if (i % 97 == 0) heading += unit(random) * kPi;
        if (i / 200 % 5 != 4)
            at = at + step_m * Vector<World>{std::cos(heading), std::sin(heading)};
        line.push_back(at + 0.3 * step_m * Vector<World>{unit(random), unit(random)});
    }
    return line;
}

Track trackOf(const Line& line) {
    Track track;
    double t = 0.0;
    for (const auto& point : line) track.append({t += 0.01, {point, 0.0}, 0.0});
    return track;
}

// The drawn runs, those that continue one another put together.
std::vector<Line> drawn(const Track& track, const WorldBox& area, double tolerance_m) {
    std::vector<Line> lines;
    track.simplified(area, tolerance_m, [&lines](std::span<const Point<World>> run) {
        EXPECT_FALSE(run.empty());
        EXPECT_LE(run.size(), Track::kRunPoints);
        if (!lines.empty() && lines.back().back() == run.front()) {
            lines.back().insert(lines.back().end(), run.begin() + 1, run.end());
        } else {
            lines.emplace_back(run.begin(), run.end());
        }
    });
    return lines;
}

double distance(Point<World> p, Point<World> a, Point<World> b) {
    const auto ab = b - a;
    const auto ap = p - a;
    const double length2 = ab.x * ab.x + ab.y * ab.y;
    const double along =
        length2 > 0.0 ? std::clamp((ap.x * ab.x + ap.y * ab.y) / length2, 0.0, 1.0) : 0.0;
    return (ap - along * ab).length();
}

double distance(Point<World> p, const Line& line) {
    double least = (p - line.front()).length();
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        least = std::min(least, distance(p, line[i], line[i + 1]));
    return least;
}

double distance(Point<World> p, const std::vector<Line>& lines) {
    double least = std::numeric_limits<double>::infinity();
    for (const Line& line : lines) least = std::min(least, distance(p, line));
    return least;
}

bool contains(const WorldBox& box, Point<World> p) {
    return p.x >= box.min.x && p.x <= box.max.x && p.y >= box.min.y && p.y <= box.max.y;
}

TEST(Track, KeepsEveryPointInOrder) {
    const Line line = wander(5000, 0.01, 1);
    const Track track = trackOf(line);
    ASSERT_EQ(track.size(), line.size());
    for (std::size_t i = 0; i < line.size(); ++i)
        ASSERT_EQ(track.at(i).pose.position, line[i]) << i;
    EXPECT_EQ(track.back(), track.at(4999));
}

TEST(Track, KnowsItsBounds) {
    const Line line = wander(3000, 0.5, 2);
    const WorldBox bounds = trackOf(line).bounds();
    const auto by_x = [](auto a, auto b) { return a.x < b.x; };
    const auto by_y = [](auto a, auto b) { return a.y < b.y; };
    EXPECT_EQ(bounds.min.x, std::min_element(line.begin(), line.end(), by_x)->x);
    EXPECT_EQ(bounds.max.x, std::max_element(line.begin(), line.end(), by_x)->x);
    EXPECT_EQ(bounds.min.y, std::min_element(line.begin(), line.end(), by_y)->y);
    EXPECT_EQ(bounds.max.y, std::max_element(line.begin(), line.end(), by_y)->y);
}

TEST(Track, DrawsNothingOfAnEmptyOneAndAPointOfOnePoint) {
    EXPECT_TRUE(drawn(Track(), kEverywhere, 0.1).empty());
    EXPECT_EQ(drawn(trackOf({{1.0, 2.0}}), kEverywhere, 0.1),
              std::vector<Line>{Line({{1.0, 2.0}})});
}

TEST(Track, DrawsEveryPointWhereTheToleranceIsZero) {
    const Line line = wander(3000, 0.01, 3);
    EXPECT_EQ(drawn(trackOf(line), kEverywhere, 0.0), std::vector<Line>{line});
}

RC_GTEST_PROP(Track, DrawnLiesWithinTheToleranceOfTheExactTrailAndTheTrailOfIt, ()) {
    const auto count = *rc::gen::inRange<std::size_t>(1, 4000);
    const double step_m = std::pow(10.0, *rc::gen::inRange(-30, 10) / 10.0);
    const double tolerance_m = std::pow(10.0, *rc::gen::inRange(-40, 30) / 10.0);
    const Line line = wander(count, step_m, *rc::gen::arbitrary<unsigned>());
    const auto lines = drawn(trackOf(line), kEverywhere, tolerance_m);
    RC_ASSERT(lines.size() == 1U);
    const double limit = tolerance_m * (1.0 + 1e-9) + 1e-12;
    for (std::size_t i = 0; i < line.size(); i += 7) RC_ASSERT(distance(line[i], lines) <= limit);
    const Line& simple = lines.front();
    for (std::size_t i = 0; i + 1 < simple.size(); i += 5) {
        const Point<World> middle = simple[i] + 0.5 * (simple[i + 1] - simple[i]);
        RC_ASSERT(distance(middle, line) <= limit);
    }
}

RC_GTEST_PROP(Track, DrawsAllThatLiesInTheAreaAndCullsTheRest, ()) {
    const Line line =
        wander(*rc::gen::inRange<std::size_t>(1, 6000), 0.1, *rc::gen::arbitrary<unsigned>());
    const Point<World> corner{*rc::gen::inRange(-400, 400) * 0.1,
                              *rc::gen::inRange(-400, 400) * 0.1};
    const WorldBox area{corner, corner + Vector<World>{5.0, 5.0}};
    const auto lines = drawn(trackOf(line), area, 0.02);
    for (std::size_t i = 0; i < line.size(); i += 3) {
        if (contains(area, line[i])) RC_ASSERT(distance(line[i], lines) <= 0.02 + 1e-9);
        if (i + 1 >= line.size()) continue;
        const Point<World> middle = line[i] + 0.5 * (line[i + 1] - line[i]);
        if (contains(area, middle)) RC_ASSERT(distance(middle, lines) <= 0.02 + 1e-9);
    }
}

TEST(Track, DrawsNothingFarOutsideTheArea) {
    const Track track = trackOf(wander(20000, 0.01, 4));
    EXPECT_TRUE(drawn(track, {{1e6, 1e6}, {2e6, 2e6}}, 0.01).empty());
}

TEST(Track, DrawsAFewPointsOfAManyTimesSmallerTrail) {
    const Track track = trackOf(wander(100000, 0.005, 5));
    const auto lines = drawn(track, kEverywhere, 1000.0);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_LE(lines.front().size(), track.size() / 1024 + 3);
}

TEST(Track, EndsWhereTheRobotIs) {
    for (const std::size_t count : {1U, 2U, 1000U, 1025U, 3000U}) {
        const Line line = wander(count, 0.01, 6);
        EXPECT_EQ(drawn(trackOf(line), kEverywhere, 0.02).back().back(), line.back()) << count;
    }
}

TEST(Track, IsACheapSnapshotWhereItIsCopied) {
    Track original = trackOf(wander(5000, 0.01, 7));
    const Track snapshot = original;
    const auto before = drawn(snapshot, kEverywhere, 0.0);
    for (int i = 0; i < 3000; ++i) original.append({100.0, {{1e3, 1e3}, 0.0}, 0.0});
    EXPECT_EQ(snapshot.size(), 5000U);
    EXPECT_EQ(drawn(snapshot, kEverywhere, 0.0), before);
    EXPECT_LT(snapshot.bounds().max.x, 1e3);
}

TEST(Track, NeedsAtMostSixtyBytesForAPoint) {
    const Track track = trackOf(wander(100000, 0.005, 8));
    EXPECT_LE(track.memoryBytes(), 60U * track.size());
}

TEST(Track, BearsPointsThatAreNoNumbers) {
    Line line = wander(3000, 0.01, 9);
    for (std::size_t i = 100; i < 1200; ++i) line[i].x = std::nan("");
    EXPECT_FALSE(drawn(trackOf(line), kEverywhere, 0.001).empty());
}

}  // namespace
}  // namespace hedr
