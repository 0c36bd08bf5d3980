#include "core/simulation/drive.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hedr {
namespace {

double clearance_m(const Wall& wall, Point<Floor> p) {
    const Vector<Floor> along = wall.to - wall.from;
    const Vector<Floor> d = p - wall.from;
    const double share = (d.x * along.x + d.y * along.y) / (along.x * along.x + along.y * along.y);
    const Point<Floor> nearest = wall.from + std::clamp(share, 0.0, 1.0) * along;
    return (p - nearest).length() - 0.5 * wall.thickness_m;
}

bool inside(const Room& room, Point<Floor> p) {
    return p.x > room.min.x && p.x < room.max.x && p.y > room.min.y && p.y < room.max.y;
}

std::vector<Pose<Floor>> drive(std::uint64_t seed, const DriveStyle& style = {}) {
    Random random(seed);
    return driveThrough(sampleBuilding(), style, random).poses;
}

TEST(Drive, NeverLeavesTheCorridors) {
    const FloorPlan floor = sampleBuilding().floor;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const auto poses = drive(seed, {.rate_hz = 5.0});
        for (const Pose<Floor>& pose : poses) {
            for (const Wall& wall : floor.walls) {
                ASSERT_GT(clearance_m(wall, pose.position), 0.4) << "seed " << seed;
            }
            for (const Room& room : floor.rooms) ASSERT_FALSE(inside(room, pose.position));
        }
    }
}

TEST(Drive, TouchesNoWallInAnyBuilding) {
    for (const Building& building :
         {buildingWithHall(), buildingWithTask(), buildingWithDiagonalWing(),
          buildingEnteredAslant(radFromDeg(-37.0)), buildingEnteredAslant(radFromDeg(37.0))}) {
        for (std::uint64_t seed = 0; seed < 10; ++seed) {
            Random random(seed);
            const Drive drive = driveThrough(building, {.rate_hz = 5.0}, random);
            for (const Pose<Floor>& pose : drive.poses)
                for (const Wall& wall : building.floor.walls)
                    ASSERT_GT(clearance_m(wall, pose.position), 0.3)
                        << "seed " << seed << " at " << pose.position.x << ' ' << pose.position.y;
        }
    }
}

TEST(Drive, WorksFiveMinutesAtATaskNearOnePlaceAndGoesOnAfterwards) {
    const Building building = buildingWithTask();
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        Random random(seed);
        const Drive drive = driveThrough(building, {.rate_hz = 5.0}, random);
        EXPECT_NEAR(drive.task_end_s - drive.task_begin_s, 300.0, 0.5) << "seed " << seed;
        int reversing = 0;
        double driven_after_m = 0.0;
        for (std::size_t i = 1; i < drive.poses.size(); ++i) {
            const double t_s = static_cast<double>(i) / 5.0;
            const Pose<Floor>& before = drive.poses[i - 1];
            const Pose<Floor>& pose = drive.poses[i];
            const Vector<Floor> step = pose.position - before.position;
            if (t_s > drive.task_end_s) driven_after_m += step.length();
            if (t_s < drive.task_begin_s || t_s > drive.task_end_s) continue;
            const auto from_task = pose.position - building.corridors.nodes[building.goal.value()];
            ASSERT_LT(from_task.length(), 8.0);
            const double forward =
                step.x * std::cos(before.heading_rad) + step.y * std::sin(before.heading_rad);
            if (forward < -0.01) ++reversing;
        }
        EXPECT_GT(reversing, 100) << "seed " << seed;
        EXPECT_GT(driven_after_m, 80.0) << "seed " << seed;
    }
}

TEST(Drive, StandsForTenSecondsAtTheStart) {
    const auto poses = drive(1);
    for (std::size_t i = 0; i < 500; ++i) ASSERT_EQ(poses[i], poses[0]);
    EXPECT_NE(poses[600], poses[0]);
}

// Rms of the heading off the corridors where the robot drives at speed and turns slowly.
double snakingDeg(const std::vector<Pose<Floor>>& poses) {
    double squares = 0.0;
    double count = 0.0;
    for (std::size_t i = 1; i < poses.size(); ++i) {
        const double rate = 50.0 * (poses[i].heading_rad - poses[i - 1].heading_rad);
        const double speed = 50.0 * (poses[i].position - poses[i - 1].position).length();
        if (speed < 0.55 || std::abs(rate) > radFromDeg(10.0)) continue;
        const double deviation = deviationFromGrid(poses[i].heading_rad, kPi / 2.0);
        squares += deviation * deviation;
        count += 1.0;
    }
    return degFromRad(std::sqrt(squares / count));
}

TEST(Drive, SnakesByTheZigzagBetweenCorners) {
    EXPECT_NEAR(std::sqrt(2.0) * snakingDeg(drive(2)), 3.0, 0.6);
}

TEST(Drive, TurnsAtMostBySixtyDegreesPerSecondAndDrivesAtMostAtItsSpeed) {
    const auto poses = drive(3);
    double fastest_turn = 0.0;
    double fastest = 0.0;
    for (std::size_t i = 1; i < poses.size(); ++i) {
        fastest_turn = std::max(fastest_turn,
                                50.0 * std::abs(poses[i].heading_rad - poses[i - 1].heading_rad));
        fastest = std::max(fastest, 50.0 * (poses[i].position - poses[i - 1].position).length());
    }
    EXPECT_LE(degFromRad(fastest_turn), 60.1);
    EXPECT_GT(degFromRad(fastest_turn), 45.0);
    EXPECT_NEAR(fastest, 0.6, 0.001);
}

TEST(Drive, TakesSomeCornersOnTheSpotAndSomeInAnArc) {
    const auto poses = drive(4);
    int spinning = 0;
    int curving = 0;
    for (std::size_t i = 1; i < poses.size(); ++i) {
        if (50.0 * std::abs(poses[i].heading_rad - poses[i - 1].heading_rad) < radFromDeg(25.0)) {
            continue;
        }
        const double speed = 50.0 * (poses[i].position - poses[i - 1].position).length();
        ++(speed < 0.05 ? spinning : curving);
    }
    EXPECT_GT(spinning, 100);
    EXPECT_GT(curving, 100);
}

TEST(Drive, ComesHomeAndWaitsThere) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const auto poses = drive(seed, {.rate_hz = 10.0});
        EXPECT_LT((poses.back().position - poses.front().position).length(), 1.0) << seed;
        EXPECT_EQ(poses.back(), *(poses.end() - 2)) << seed;
    }
}

TEST(Drive, ByALaggingVideoStaysOffTheWallsAndComesHome) {
    const FloorPlan floor = sampleBuilding().floor;
    int late = 0;
    for (const double lag_s : {0.3, 1.0}) {
        for (std::uint64_t seed = 0; seed < 10; ++seed) {
            const auto poses = drive(seed, {.rate_hz = 5.0, .video_lag_s = lag_s});
            double nearest_m = 10.0;
            for (const Pose<Floor>& pose : poses)
                for (const Wall& wall : floor.walls)
                    nearest_m = std::min(nearest_m, clearance_m(wall, pose.position));
            EXPECT_GT(nearest_m, 0.25) << "lag " << lag_s << " s, seed " << seed;
            late += (poses.back().position - poses.front().position).length() > 1.5 ? 1 : 0;
        }
    }
    EXPECT_LE(late, 1);
}

// Rms of the mean deviation from the corridors over stretches of five seconds.
double slowDeviationDeg(const std::vector<Pose<Floor>>& poses) {
    constexpr int kStretch = 250;
    double squares = 0.0;
    double count = 0.0;
    double sum = 0.0;
    int length = 0;
    for (const Pose<Floor>& pose : poses) {
        const double deviation = deviationFromGrid(pose.heading_rad, kPi / 2.0);
        const bool straight = std::abs(deviation) < radFromDeg(12.0);
        sum = straight ? sum + deviation : 0.0;
        length = straight ? length + 1 : 0;
        if (length < kStretch) continue;
        squares += sum * sum / (kStretch * kStretch);
        count += 1.0;
        sum = 0.0;
        length = 0;
    }
    return degFromRad(std::sqrt(squares / count));
}

TEST(Drive, ByALaggingVideoIsCorrectedLater) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        EXPECT_GT(slowDeviationDeg(drive(seed, {.video_lag_s = 1.0})),
                  1.15 * slowDeviationDeg(drive(seed, {.video_lag_s = 0.0})));
    }
}

TEST(Drive, HaltsNowAndThen) {
    const auto poses = drive(5);
    int halts = 0;
    for (std::size_t i = 2; i < poses.size(); ++i) {
        halts += poses[i] == poses[i - 1] && poses[i - 1] != poses[i - 2] ? 1 : 0;
    }
    EXPECT_GE(halts, 4);
}

}  // namespace
}  // namespace hedr
