// Laws that hold for every estimator of the table, whatever its method.
#include "core/fusion/estimators.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <set>
#include <vector>

#include "core/geometry/angle.h"

namespace hedr {
namespace {

// The motions of perfect sensors, a magnetometer among them.
class PerfectDrive {
  public:
    Motion step(double dt_s, double distance_m, double turn_rad) {
        t_s_ += dt_s;
        heading_rad_ += turn_rad;
        return {
            .t_s = t_s_,
            .dt_s = dt_s,
            .distance_m = distance_m,
            .odometry_turn_rad = turn_rad,
            .gyro_turn_rad = turn_rad,
            .magnetic_field = MagneticField{std::cos(heading_rad_), -std::sin(heading_rad_), -2.0}};
    }

  private:
    double t_s_ = 0.0;
    double heading_rad_ = 0.0;
};

Pose<World> poseOf(const AnyEstimator& estimator) {
    return std::visit([](const auto& known) { return Pose<World>(known.pose()); }, estimator);
}

void update(AnyEstimator& estimator, const Motion& motion) {
    std::visit([&](auto& known) { known.update(motion); }, estimator);
}

std::optional<Eigen::Matrix3d> covarianceOf(const AnyEstimator& estimator) {
    return std::visit(
        [](const auto& known) -> std::optional<Eigen::Matrix3d> {
            if constexpr (EstimatorWithCovariance<std::decay_t<decltype(known)>>)
                return known.covariance();
            return std::nullopt;
        },
        estimator);
}

// Straight, a left turn, straight, a little crooked.
std::vector<Motion> drive() {
    PerfectDrive drive;
    std::vector<Motion> motions;
    for (int i = 1; i <= 3000; ++i) {
        const double turn = i > 1000 && i <= 1100 ? kPi / 200.0 : 1e-4 * std::sin(0.05 * i);
        motions.push_back(drive.step(0.02, 0.012, turn));
    }
    return motions;
}

class EstimatorLaws : public ::testing::TestWithParam<std::string_view> {
  protected:
    AnyEstimator make(const Pose<World>& start = {}) const {
        return findEstimator(GetParam())->make(start, FusionConfig{});
    }
};

TEST_P(EstimatorLaws, StandingStays) {
    AnyEstimator estimator = make({{3.0, 4.0}, 0.5});
    PerfectDrive drive;
    for (int i = 1; i < 1000; ++i) {
        Motion motion = drive.step(0.02, 0.0, 0.0);
        motion.standing = i > 25;
        update(estimator, motion);
    }
    EXPECT_EQ(poseOf(estimator).position, (Point<World>{3.0, 4.0}));
    EXPECT_NEAR(poseOf(estimator).heading_rad, 0.5, 1e-12);  // a field comes from an arc tangent
}

TEST_P(EstimatorLaws, AStraightLineIsExact) {
    AnyEstimator estimator = make({{1.0, 2.0}, kPi / 6.0});
    PerfectDrive drive;
    for (int i = 1; i <= 1000; ++i) update(estimator, drive.step(0.02, 0.01, 0.0));
    EXPECT_NEAR(poseOf(estimator).position.x, 1.0 + 10.0 * std::cos(kPi / 6.0), 1e-9);
    EXPECT_NEAR(poseOf(estimator).position.y, 2.0 + 10.0 * std::sin(kPi / 6.0), 1e-9);
}

TEST_P(EstimatorLaws, AnArcIsExact) {
    AnyEstimator estimator = make();
    PerfectDrive drive;
    // Fast enough to be a turn, which no heuristic may touch: half a circle of radius 1 m in 3 s.
    for (int i = 1; i <= 150; ++i) update(estimator, drive.step(0.02, kPi / 150, kPi / 150));
    EXPECT_NEAR(poseOf(estimator).position.x, 0.0, 1e-3);
    EXPECT_NEAR(poseOf(estimator).position.y, 2.0, 1e-3);
    EXPECT_NEAR(poseOf(estimator).heading_rad, kPi, 1e-3);
}

TEST_P(EstimatorLaws, TurningTheStartTurnsTheWholeTrack) {
    const Pose<World> start{{5.0, -3.0}, 1.1};
    AnyEstimator at_origin = make();
    AnyEstimator turned = make(start);
    const auto world_from_start = rigidTransform<World, World>(start);
    for (const Motion& motion : drive()) {
        update(at_origin, motion);
        update(turned, motion);
        const Point<World> expected = world_from_start * poseOf(at_origin).position;
        ASSERT_NEAR(poseOf(turned).position.x, expected.x, 1e-6);
        ASSERT_NEAR(poseOf(turned).position.y, expected.y, 1e-6);
    }
}

TEST_P(EstimatorLaws, ACopyContinuesAsTheOriginal) {
    AnyEstimator original = make();
    std::optional<AnyEstimator> copy;
    int i = 0;
    for (const Motion& motion : drive()) {
        if (++i == 1500) copy = original;
        update(original, motion);
        if (copy) update(*copy, motion);
    }
    EXPECT_EQ(poseOf(original), poseOf(*copy));
}

TEST_P(EstimatorLaws, GapsAndTinyStepsGiveNoNan) {
    AnyEstimator estimator = make();
    PerfectDrive drive;
    for (const double dt_s : {1e-9, 0.02, 3600.0, 1e-6, 100.0, 0.5}) {
        const Motion motion = drive.step(dt_s, 0.1, 0.01);
        update(estimator, motion);
        update(estimator, Motion{.t_s = motion.t_s, .dt_s = dt_s});
    }
    EXPECT_TRUE(std::isfinite(poseOf(estimator).position.x));
    EXPECT_TRUE(std::isfinite(poseOf(estimator).heading_rad));
    EXPECT_TRUE(covarianceOf(estimator).value_or(Eigen::Matrix3d::Zero()).allFinite());
}

TEST_P(EstimatorLaws, ItsCovarianceIsSymmetricPositiveAndGrowsOnTheWay) {
    AnyEstimator estimator = make();
    if (!covarianceOf(estimator)) {
        EXPECT_EQ(GetParam(), "hedr");  // the sign of an angle says nothing of its spread
        return;
    }
    double after_a_while_m2 = 0.0;
    int steps = 0;
    for (const Motion& motion : drive()) {
        update(estimator, motion);
        const Eigen::Matrix3d p = *covarianceOf(estimator);
        ASSERT_TRUE(p.allFinite());
        ASSERT_TRUE(p.isApprox(p.transpose(), 1e-9)) << p;
        const Eigen::Vector3d spread = p.selfadjointView<Eigen::Lower>().eigenvalues();
        ASSERT_GE(spread.minCoeff(), -1e-9 * spread.maxCoeff());
        if (++steps == 500) after_a_while_m2 = p(0, 0) + p(1, 1);
    }
    const Eigen::Matrix3d at_the_end = *covarianceOf(estimator);
    EXPECT_GT(after_a_while_m2, 0.0);
    EXPECT_GT(at_the_end(0, 0) + at_the_end(1, 1), after_a_while_m2);
}

std::vector<std::string_view> allNames() {
    std::vector<std::string_view> names;
    for (const EstimatorEntry& entry : estimatorTable()) names.push_back(entry.name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(All, EstimatorLaws, ::testing::ValuesIn(allNames()),
                         [](const auto& each) { return std::string(each.param); });

TEST(EstimatorTable, HasTheContractsNamesOnce) {
    const auto names = allNames();
    const std::set<std::string_view> unique(names.begin(), names.end());
    EXPECT_EQ(unique.size(), names.size());
    for (const char* name : {"odometry", "gyro", "gyrodometry", "gyro_kalman", "gh_gyro",
                             "gh_magnetometer", "gh_combined", "hedr", "hedr_bayes"}) {
        EXPECT_NE(findEstimator(name), nullptr) << name;
    }
    EXPECT_EQ(findEstimator("crystal_ball"), nullptr);
}

TEST(FusionKnobs, EachCanBeSetAndRefusesNonsense) {
    for (const FusionKnob& knob : fusionKnobs()) {
        FusionConfig config;
        const char* good = knob.key == "heading_source" ? "encoders" : "45";
        const bool accepts = setFusionValue(config, knob.key, good).has_value() ||
                             setFusionValue(config, knob.key, "1").has_value();
        EXPECT_TRUE(accepts) << knob.key;
        EXPECT_FALSE(setFusionValue(config, knob.key, "much")) << knob.key;
        EXPECT_FALSE(setFusionValue(config, knob.key, "nan")) << knob.key;
    }
    FusionConfig config;
    const auto unknown = setFusionValue(config, "magic", "1");
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().code, ErrorCode::kUnknownName);
    EXPECT_NE(unknown.error().detail.find("gain_deg_s2"), std::string::npos);
}

TEST(FusionKnobs, SayTheirRangeInPlainNumbers) {
    FusionConfig config;
    const auto set = setFusionValue(config, "gh_alpha", "2");
    ASSERT_FALSE(set);
    EXPECT_EQ(set.error().detail, "is \"2\", must be a number from 0 to 1");
}

TEST(FusionKnobs, GiveTheirValueAsItIsSet) {
    EXPECT_EQ(fusionValue({}, "gain_deg_s2"), "0.01");
    EXPECT_EQ(fusionValue({}, "direction_deg"), "auto");
    EXPECT_EQ(fusionValue({}, "heading_source"), "gyro");
    for (const FusionKnob& knob : fusionKnobs()) {
        FusionConfig config;
        const std::string value = fusionValue(config, knob.key);
        EXPECT_TRUE(setFusionValue(config, knob.key, value)) << knob.key << ' ' << value;
        EXPECT_EQ(fusionValue(config, knob.key), value) << knob.key;
    }
}

TEST(EstimatorTable, HasNoEstimatorThatGuessesAHeading) {
    const EstimatorInputs no_heading{
        .magnetometer = true, .gyro_drift = true, .magnetometer_range = true};
    for (const EstimatorEntry& entry : estimatorTable()) {
        EXPECT_TRUE(missingInput(entry.needs, no_heading)) << entry.name;
    }
    for (const char* name : {"hedr", "hedr_bayes"}) {
        const EstimatorInputs& needs = findEstimator(name)->needs;
        EXPECT_FALSE(missingInput(needs, {.gyro = true})) << name;
        EXPECT_FALSE(missingInput(needs, {.both_wheels = true})) << name;
        const auto missing = missingInput(needs, no_heading);
        ASSERT_TRUE(missing) << name;
        EXPECT_TRUE(missing->what.starts_with("no heading (")) << missing->what;
        EXPECT_FALSE(missing->in_vehicle);
    }
}

TEST(FusionKnobs, EachActsOnAnEstimatorOfTheTable) {
    const auto acts = [](std::string_view key, std::string_view estimator) {
        for (const FusionKnob& knob : fusionKnobs()) {
            if (knob.key == key) return actsOn(knob, estimator);
        }
        return false;
    };
    EXPECT_TRUE(acts("gain_deg_s2", "hedr"));
    EXPECT_FALSE(acts("gain_deg_s2", "hedr_bayes"));
    EXPECT_TRUE(acts("gh_alpha", "gh_magnetometer"));
    EXPECT_FALSE(acts("gh_gamma", "gh_gyro"));
    for (const FusionKnob& knob : fusionKnobs()) {
        bool any = false;
        for (const EstimatorEntry& entry : estimatorTable()) any = any || actsOn(knob, entry.name);
        EXPECT_TRUE(any) << knob.key;
    }
}

}  // namespace
}  // namespace hedr
