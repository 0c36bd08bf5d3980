#include "core/simulation/scenario.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hedr {
namespace {

constexpr std::uint64_t kSeeds = 20;

Scenario corridors() { return scenarioByName("packbot-corridors").value(); }

struct DeadReckoning {
    double distance_m = 0.0;
    double out_of_building_s = 0.0;
};

DeadReckoning driveByTicks(const SimulatedMission& mission) {
    const VehicleGeometry& g = mission.vehicle.geometry;
    const double tick_m = kPi * g.left_wheel_diameter_m / g.ticks_per_revolution;
    Pose<World> pose = mission.start;
    DeadReckoning result;
    for (std::size_t i = 1; i < mission.sensors.size(); ++i) {
        const auto before = std::get<WheelTicks>(mission.sensors[i - 1].odometry);
        const auto after = std::get<WheelTicks>(mission.sensors[i].odometry);
        const double left = tick_m * static_cast<double>(after.left - before.left);
        const double right = tick_m * static_cast<double>(after.right - before.right);
        pose.heading_rad += (right - left) / g.wheelbase_m;
        const double forward = 0.5 * (left + right);
        pose.position = pose.position + forward * Vector<World>{std::cos(pose.heading_rad),
                                                                std::sin(pose.heading_rad)};
        result.distance_m += std::abs(forward);
        const auto [x, y] = pose.position;
        if (x < 0.0 || x > 90.0 || y < 0.0 || y > 54.0) result.out_of_building_s += 0.02;
    }
    return result;
}

double largestGyroErrorDeg(const SimulatedMission& mission) {
    double bias = 0.0;
    for (std::size_t i = 0; i < 500; ++i) {
        bias += std::get<GyroRate>(mission.sensors[i].gyro).rad_s / 500.0;
    }
    double heading = mission.start.heading_rad;
    double largest = 0.0;
    for (std::size_t i = 1; i < mission.sensors.size(); ++i) {
        heading += 0.02 * (std::get<GyroRate>(mission.sensors[i].gyro).rad_s - bias);
        largest = std::max(largest, std::abs(heading - mission.truth[i].pose.heading_rad));
    }
    return degFromRad(largest);
}

double trueDistance(const SimulatedMission& mission) {
    double distance_m = 0.0;
    for (std::size_t i = 1; i < mission.truth.size(); ++i) {
        distance_m +=
            (mission.truth[i].pose.position - mission.truth[i - 1].pose.position).length();
    }
    return distance_m;
}

TEST(Scenario, OfOneSeedIsAlwaysTheSameAndOfAnotherIsNot) {
    for (const ScenarioEntry& entry : scenarioTable()) {
        const Scenario scenario = scenarioByName(entry.name).value();
        const SimulatedMission once = simulate(scenario, 11);
        const SimulatedMission again = simulate(scenario, 11);
        EXPECT_EQ(once.sensors, again.sensors) << entry.name;
        EXPECT_EQ(once.truth, again.truth) << entry.name;
        const SimulatedMission other = simulate(scenario, 12);
        // What drives by its own odometry counts the same every time, and ends elsewhere.
        EXPECT_FALSE(once.sensors == other.sensors && once.truth == other.truth) << entry.name;
    }
}

// Share of the way that is driven within `within_deg` of a multiple of 45 degrees, but not of 90.
double shareOfDiagonals(const SimulatedMission& mission, double within_deg) {
    double diagonal_m = 0.0;
    for (std::size_t i = 1; i < mission.truth.size(); ++i) {
        const double heading = mission.truth[i].pose.heading_rad;
        if (std::abs(deviationFromGrid(heading - kPi / 4.0, kPi / 2.0)) > radFromDeg(within_deg))
            continue;
        diagonal_m +=
            (mission.truth[i].pose.position - mission.truth[i - 1].pose.position).length();
    }
    return diagonal_m / trueDistance(mission);
}

TEST(Scenario, With45DegreesDrivesThereLongAndTheOthersDoNot) {
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        EXPECT_GT(shareOfDiagonals(simulate(scenarioByName("packbot-45").value(), seed), 10.0),
                  0.15);
        EXPECT_LT(shareOfDiagonals(simulate(corridors(), seed), 10.0), 0.06);
    }
}

TEST(Scenario, WithAHallCrossesItOffTheCorridorsDirections) {
    int crossed = 0;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        const SimulatedMission mission = simulate(scenarioByName("packbot-hall").value(), seed);
        double off_grid_m = 0.0;
        for (std::size_t i = 1; i < mission.truth.size(); ++i) {
            const auto [x, y] = mission.truth[i].pose.position;
            const bool in_hall = x > 31.0 && x < 59.0 && y > 15.0 && y < 39.0;
            if (!in_hall) continue;
            off_grid_m +=
                (mission.truth[i].pose.position - mission.truth[i - 1].pose.position).length();
        }
        if (off_grid_m > 24.0) ++crossed;
    }
    EXPECT_GE(crossed, 19);
}

TEST(Scenario, WithAnOffsetStartsNeitherAlongNorAcrossTheCorridors) {
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        const SimulatedMission mission = simulate(scenarioByName("packbot-offset").value(), seed);
        const double off = std::abs(deviationFromGrid(mission.start.heading_rad, kPi / 2.0));
        EXPECT_GT(degFromRad(off), 7.9);
        EXPECT_LT(degFromRad(off), 37.1);
    }
}

TEST(Scenario, LastsTwentyMinutesAtFiftyHertz) {
    const SimulatedMission mission = simulate(corridors(), 1);
    ASSERT_EQ(mission.sensors.size(), 60001U);
    ASSERT_EQ(mission.truth.size(), 60001U);
    EXPECT_EQ(mission.sensors.back().robot_time_s, 1200.0);
    EXPECT_EQ(mission.truth.back().t_s, 1200.0);
    EXPECT_EQ(mission.vehicle.geometry.ticks_per_revolution, 36.0);
    EXPECT_FALSE(mission.vehicle.gyro_bias_rad_s.has_value());
}

TEST(Scenario, LeadsPlainOdometryOutOfTheBuildingOnMostSeeds) {
    int lost = 0;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        const SimulatedMission mission = simulate(corridors(), seed);
        const DeadReckoning odometry = driveByTicks(mission);
        if (odometry.out_of_building_s > 30.0) ++lost;
        EXPECT_NEAR(odometry.distance_m / trueDistance(mission), 1.0, 0.03) << "seed " << seed;
    }
    EXPECT_GE(lost, 16);
}

TEST(Scenario, LetsTheGyroDriftByTensOfDegreesOnMostSeeds) {
    int drifted = 0;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        if (largestGyroErrorDeg(simulate(corridors(), seed)) > 20.0) ++drifted;
    }
    EXPECT_GE(drifted, 16);
}

TEST(Scenario, KeepsTheEncodersStillAtTheStartAndForwardInCorridors) {
    const SimulatedMission mission = simulate(corridors(), 3);
    for (std::size_t i = 1; i < mission.sensors.size(); ++i) {
        const auto before = std::get<WheelTicks>(mission.sensors[i - 1].odometry);
        const auto after = std::get<WheelTicks>(mission.sensors[i].odometry);
        const Pose<World>& from = mission.truth[i - 1].pose;
        const Pose<World>& to = mission.truth[i].pose;
        if (from == to) {
            ASSERT_EQ(before, after);
        } else if ((to.position - from.position).length() > 0.02 * 0.5) {
            ASSERT_GE(after.left, before.left);
            ASSERT_GE(after.right, before.right);
        }
    }
}

TEST(Scenario, TurnsTheWholeMissionWithTheBuilding) {
    Scenario turned = corridors();
    ASSERT_TRUE(setScenarioValue(turned, "building_rotation_deg", "30"));
    const SimulatedMission straight = simulate(corridors(), 4);
    const SimulatedMission mission = simulate(turned, 4);
    EXPECT_NEAR(mission.start.heading_rad, radFromDeg(30.0), 1e-12);
    EXPECT_EQ(mission.sensors.size(), straight.sensors.size());
    const auto p = straight.truth.back().pose.position;
    const auto q = mission.truth.back().pose.position;
    EXPECT_NEAR(q.x, std::cos(kPi / 6.0) * p.x - std::sin(kPi / 6.0) * p.y, 1e-9);
    EXPECT_NEAR(q.y, std::sin(kPi / 6.0) * p.x + std::cos(kPi / 6.0) * p.y, 1e-9);
}

TEST(Scenario, TakesEveryKeyAtItsDefaultAndAtItsLimits) {
    for (const ScenarioEntry& entry : scenarioTable()) {
        for (const ScenarioKey& key : scenarioKeys(entry.make())) {
            EXPECT_LE(key.min, key.value) << entry.name << ' ' << key.name;
            EXPECT_GE(key.max, key.value) << entry.name << ' ' << key.name;
            Scenario scenario = entry.make();
            EXPECT_TRUE(setScenarioValue(scenario, key.name, std::to_string(key.min)));
            EXPECT_TRUE(setScenarioValue(scenario, key.name, std::to_string(key.max)));
        }
    }
}

// Short ones, of the kinds that can be.
Scenario shortened(Scenario scenario) {
    for (const char* key : {"duration_s", "drive_s"}) {
        if (const auto set = setScenarioValue(scenario, key, "90"); !set) {
            EXPECT_EQ(set.error().code, ErrorCode::kUnknownName);
        }
    }
    return scenario;
}

TEST(Scenario, SimulatesAtTheEdgeOfEveryKey) {
    for (const ScenarioEntry& entry : scenarioTable()) {
        if (entry.name.starts_with("packbot-") && entry.name != "packbot-corridors") continue;
        for (const ScenarioKey& key : scenarioKeys(entry.make())) {
            for (const double value : {key.min, std::min(key.max, 1000.0)}) {
                Scenario scenario = shortened(entry.make());
                ASSERT_TRUE(setScenarioValue(scenario, key.name, std::to_string(value)));
                const SimulatedMission mission = simulate(scenario, 1);
                ASSERT_EQ(mission.sensors.size(), mission.truth.size());
                EXPECT_TRUE(std::isfinite(mission.truth.back().pose.heading_rad)) << key.name;
                const auto* gyro = std::get_if<GyroRate>(&mission.sensors.back().gyro);
                EXPECT_TRUE(!gyro || std::isfinite(gyro->rad_s)) << key.name;
            }
        }
    }
}

TEST(Scenario, BeginsItsTruthAtItsStart) {
    for (const ScenarioEntry& entry : scenarioTable()) {
        const SimulatedMission mission = simulate(shortened(entry.make()), 2);
        EXPECT_EQ(mission.truth.front().pose, mission.start) << entry.name;
        EXPECT_EQ(mission.sensors.size(), mission.truth.size()) << entry.name;
        EXPECT_EQ(mission.building.has_value(), entry.name.starts_with("packbot-")) << entry.name;
    }
}

TEST(Scenario, RefusesAnUnknownKeyAndListsTheKnownOnes) {
    Scenario scenario;
    const auto result = setScenarioValue(scenario, "zickzack", "3");
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::kUnknownName);
    EXPECT_EQ(result.error().subject, "zickzack");
    EXPECT_NE(result.error().detail.find("zigzag_deg"), std::string::npos);
}

TEST(Scenario, KnowsItsOwnKeysOnly) {
    Scenario romi = scenarioByName("romi-rectangle").value();
    EXPECT_TRUE(setScenarioValue(romi, "wheelbase_error_mm", "-8"));
    EXPECT_EQ(std::get<RomiRectangle>(romi).wheelbase_error_m, -0.008);
    const auto result = setScenarioValue(romi, "zigzag_deg", "3");
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::kUnknownName);
    EXPECT_NE(result.error().detail.find("left_wheel_error_mm"), std::string::npos);
    EXPECT_EQ(result.error().detail.find("zigzag_deg"), std::string::npos);
}

TEST(Scenario, RefusesWhatIsNotANumberInRange) {
    Scenario scenario;
    for (const char* bad : {"", "fast", "3x", "-1", "1e9", "nan", "inf"}) {
        const auto result = setScenarioValue(scenario, "zigzag_deg", bad);
        ASSERT_FALSE(result) << bad;
        EXPECT_EQ(result.error().code, ErrorCode::kBadValue) << bad;
        EXPECT_EQ(result.error().subject, "zigzag_deg") << bad;
    }
}

TEST(Scenario, OfAnUnknownNameListsTheKnownOnes) {
    const auto result = scenarioByName("moon");
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::kUnknownName);
    EXPECT_NE(result.error().detail.find("packbot-corridors"), std::string::npos);
}

}  // namespace
}  // namespace hedr
