#include "core/site/survey/trail_placement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "core/geometry/angle.h"
#include "tests/core/site/survey/corridors.h"

namespace hedr {
namespace {

struct Example {
    FreeSpace space{};
    std::vector<Point<PlanGround>> drive{};
};

// No part of it looks like another.
Example crookedSite() {
    return {carved(40.0, 26.0,
                   {{{4, -4}, {35, -4}, 2.5},
                    {{35, -4}, {35, -20}, 2.0},
                    {{12, -4}, {12, -22}, 2.0},
                    {{12, -15}, {24, -15}, 3.0},
                    {{24, -15}, {24, -22}, 2.0}}),
            drivenAlong({{5, -4},
                         {12, -4},
                         {12, -15},
                         {24, -15},
                         {24, -21},
                         {24, -15},
                         {12, -15},
                         {12, -4},
                         {30, -4}})};
}

// The same after half a turn.
Example ringSite() {
    return {carved(40.0, 25.0,
                   {{{5, -5}, {35, -5}},
                    {{35, -5}, {35, -20}},
                    {{35, -20}, {5, -20}},
                    {{5, -20}, {5, -5}}}),
            drivenAlong({{10, -5}, {35, -5}, {35, -20}, {5, -20}, {5, -10}})};
}

// A straight corridor with the same bar at both ends.
Example doubleTeeSite() {
    return {carved(46.0, 20.0, {{{3, -10}, {43, -10}}, {{3, -4}, {3, -16}}, {{43, -4}, {43, -16}}}),
            drivenAlong({{12, -10}, {43, -10}, {43, -15}})};
}

int heightOf(const Example& example) { return example.space.height; }

const Pose<World> kWhereGroundLies{{-31.0, 57.0}, radFromDeg(123.0)};
const PlanPlacement kNow{kCorridorPx_m, {{400.0, -70.0}, 2.0}};

Transform<World, PlanGround> worldFromGround() {
    return rigidTransform<World, PlanGround>(kWhereGroundLies);
}

std::vector<Point<World>> trailOf(const Example& example) {
    std::vector<Point<World>> trail;
    for (const Point<PlanGround>& place : example.drive) trail.push_back(worldFromGround() * place);
    return trail;
}

// How far a placement puts the drive from where it was, root mean square.
double missOf(const PlanPlacement& placement, const Example& example,
              const std::vector<Point<World>>& trail) {
    const auto plan_from_world = worldFromPlan(placement, heightOf(example)).inverse();
    double sum = 0.0;
    for (std::size_t i = 0; i < trail.size(); ++i) {
        const Point<Plan> px = plan_from_world * trail[i];
        const Point<PlanGround> found{px.x * kCorridorPx_m, -px.y * kCorridorPx_m};
        sum += std::pow((found - example.drive[i]).length(), 2);
    }
    return std::sqrt(sum / static_cast<double>(trail.size()));
}

double rotationMiss_deg(const PlanPlacement& placement) {
    return std::abs(
        degFromRad(wrapAngle(placement.origin.heading_rad - kWhereGroundLies.heading_rad)));
}

Result<TrailPlacements> place(const Example& example, const std::vector<Point<World>>& trail,
                              const PlanPlacement& now = kNow) {
    return placeByTrail(example.space, now, heightOf(example), trail);
}

TEST(TrailPlacement, FindsWhereACrookedBuildingLies) {
    const Example example = crookedSite();
    const auto trail = trailOf(example);
    const TrailPlacements found = place(example, trail).value();
    EXPECT_LT(missOf(found.best.front().placement, example, trail), 0.1);
    EXPECT_LT(rotationMiss_deg(found.best.front().placement), 0.3);
    EXPECT_EQ(found.best.front().placement.resolution_m, kCorridorPx_m);
    EXPECT_GT(found.best.front().score, 0.8);
    EXPECT_FALSE(found.ambiguous);
}

TEST(TrailPlacement, FindsItForATrailThatDrifts) {
    const Example example = crookedSite();
    auto trail = trailOf(example);
    Point<World> place_of_robot = trail.front();
    std::vector<Point<World>> drifted{place_of_robot};
    for (std::size_t i = 1; i < trail.size(); ++i) {
        const double turn =
            radFromDeg(1.5) * static_cast<double>(i) / static_cast<double>(trail.size());
        const Vector<World> step = 1.01 * (trail[i] - trail[i - 1]);
        place_of_robot =
            place_of_robot + Vector<World>{step.x - turn * step.y, step.y + turn * step.x};
        drifted.push_back(place_of_robot);
    }
    const TrailPlacements found = place(example, drifted).value();
    EXPECT_LT(missOf(found.best.front().placement, example, drifted), 0.5);
    EXPECT_LT(rotationMiss_deg(found.best.front().placement), 1.5);
    EXPECT_FALSE(found.ambiguous);
}

TEST(TrailPlacement, SaysThatARingIsTheSameAfterHalfATurn) {
    const Example example = ringSite();
    const auto trail = trailOf(example);
    const TrailPlacements found = place(example, trail).value();
    EXPECT_TRUE(found.ambiguous);
    ASSERT_GE(found.best.size(), 2U);
    const auto misses = std::minmax({missOf(found.best[0].placement, example, trail),
                                     missOf(found.best[1].placement, example, trail)});
    EXPECT_LT(misses.first, 0.2);
    EXPECT_GT(misses.second, 10.0);
    EXPECT_NEAR(found.best[0].score, found.best[1].score, 0.03);
}

TEST(TrailPlacement, SaysThatACorridorWithTwoLikeEndsIsAmbiguous) {
    const Example example = doubleTeeSite();
    EXPECT_TRUE(place(example, trailOf(example)).value().ambiguous);
}

TEST(TrailPlacement, PutsTheTwinFirstThatIsLessTurnedFromWhereThePlanLies) {
    const Example example = ringSite();
    const auto trail = trailOf(example);
    for (const double off_deg : {-70.0, 70.0, 180.0}) {
        PlanPlacement now = kNow;
        now.origin.heading_rad = kWhereGroundLies.heading_rad + radFromDeg(off_deg);
        const TrailPlacements found = place(example, trail, now).value();
        const double turn =
            wrapAngle(found.best.front().placement.origin.heading_rad - now.origin.heading_rad);
        EXPECT_LT(std::abs(degFromRad(turn)), 75.0) << off_deg;
    }
}

TEST(TrailPlacement, KeepsTheScaleAndBearsThatItIsAPercentOff) {
    const Example example = crookedSite();
    const auto trail = trailOf(example);
    for (const double wrong : {0.99, 1.01}) {
        PlanPlacement now = kNow;
        now.resolution_m *= wrong;
        const TrailPlacements found = place(example, trail, now).value();
        EXPECT_EQ(found.best.front().placement.resolution_m, now.resolution_m);
        EXPECT_LT(missOf(found.best.front().placement, example, trail), 0.3) << wrong;
        EXPECT_FALSE(found.ambiguous) << wrong;
    }
}

TEST(TrailPlacement, HaltsAndWaysDrivenAgainChangeLittle) {
    const Example example = crookedSite();
    const auto trail = trailOf(example);
    std::vector<Point<World>> slow;
    for (const Point<World>& p : trail) slow.insert(slow.end(), 3, p);
    slow.insert(slow.end(), 20000, trail.back());
    slow.insert(slow.end(), trail.rbegin(), trail.rend());
    const TrailPlacement once = place(example, trail).value().best.front();
    const TrailPlacement again = place(example, slow).value().best.front();
    EXPECT_LT(missOf(again.placement, example, trail), 0.1);
    EXPECT_NEAR(again.score, once.score, 0.05);
}

struct Bad {
    const char* why;
    std::vector<Point<World>> trail;
    ErrorCode code;
};

TEST(TrailPlacement, RefusesATrailThatTellsNothing) {
    const Example example = crookedSite();
    const auto good = trailOf(example);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    auto with_nan = good;
    with_nan[100].y = nan;
    auto with_infinity = good;
    with_infinity.back().x = -std::numeric_limits<double>::infinity();
    auto beyond = good;
    beyond[3].x = 1e200;
    const std::vector<Point<World>> still(5000, Point<World>{1.0, 2.0});
    const std::vector<Point<World>> straight{{0.0, 0.0}, {60.0, 5.0}};
    const std::vector<Point<World>> few(good.begin(), good.begin() + 380);
    for (const auto& [why, trail, code] :
         {Bad{"empty", {}, ErrorCode::kNoData}, Bad{"still", still, ErrorCode::kNoData},
          Bad{"short", few, ErrorCode::kNoData}, Bad{"straight", straight, ErrorCode::kNoData},
          Bad{"NaN", with_nan, ErrorCode::kBadValue},
          Bad{"infinity", with_infinity, ErrorCode::kBadValue},
          Bad{"beyond", beyond, ErrorCode::kBadValue}}) {
        const auto found = place(example, trail);
        ASSERT_FALSE(found) << why;
        EXPECT_EQ(found.error().code, code) << why;
        EXPECT_FALSE(found.error().detail.empty()) << why;
    }
    EXPECT_EQ(place(example, few).error().detail, "it is 19 m long, must be at least 20 m");
}

TEST(TrailPlacement, RefusesAPlanThatTellsNothing) {
    const Example example = crookedSite();
    const auto trail = trailOf(example);
    FreeSpace solid = example.space;
    std::ranges::replace(solid.cells, Cell::kFree, Cell::kUnknown);
    EXPECT_EQ(placeByTrail(solid, kNow, 100, trail).error().code, ErrorCode::kNoData);
    EXPECT_EQ(placeByTrail({}, kNow, 0, trail).error().code, ErrorCode::kNoData);
    for (const double scale : {0.0, -0.05, std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::infinity()}) {
        PlanPlacement now = kNow;
        now.resolution_m = scale;
        EXPECT_EQ(place(example, trail, now).error().code, ErrorCode::kBadValue) << scale;
    }
}

TEST(TrailPlacement, SaysWhenTheTrailFitsNowhere) {
    const Example example = crookedSite();
    const auto trail = trailOf(example);
    for (const double wrong : {0.02, 0.4, 5.0}) {
        PlanPlacement now = kNow;
        now.resolution_m *= wrong;
        const auto found = place(example, trail, now);
        ASSERT_FALSE(found) << wrong << ' ' << found->best.front().score;
        EXPECT_EQ(found.error().code, ErrorCode::kNoData) << wrong;
    }
}

TEST(TrailPlacement, TellsItsProgressAndStopsWhenToldTo) {
    const Example example = crookedSite();
    const auto trail = trailOf(example);
    std::vector<double> shares;
    const auto watch = [&](double share) {
        shares.push_back(share);
        return true;
    };
    ASSERT_TRUE(placeByTrail(example.space, kNow, heightOf(example), trail, watch));
    EXPECT_TRUE(std::ranges::is_sorted(shares));
    EXPECT_GE(shares.front(), 0.0);
    EXPECT_EQ(shares.back(), 1.0);
    ASSERT_GT(shares.size(), 100U);
    for (const std::size_t calls : {std::size_t{1}, shares.size() / 2, shares.size()}) {
        std::size_t left = calls;
        const auto stop = [&](double) { return --left > 0; };
        const auto stopped = placeByTrail(example.space, kNow, heightOf(example), trail, stop);
        ASSERT_FALSE(stopped) << calls;
        EXPECT_EQ(stopped.error().code, ErrorCode::kCanceled);
    }
}

}  // namespace
}  // namespace hedr
