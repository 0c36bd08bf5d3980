#include "core/fusion/hedr_bayes.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>

namespace hedr {
namespace {

class HedrBayesDriving : public ::testing::Test {
  protected:
    // Straight at 0.5 m/s, 50 Hz, with a gyro that drifts by `drift_deg_s`.
    void drive(double seconds, double drift_deg_s, double turn_deg_s = 0.0) {
        for (int i = 0; i < static_cast<int>(50.0 * seconds); ++i) {
            t_s_ += 0.02;
            heading_rad_ += radFromDeg(turn_deg_s) * 0.02;
            filter_.update({.t_s = t_s_,
                            .dt_s = 0.02,
                            .distance_m = 0.01,
                            .gyro_turn_rad = radFromDeg(turn_deg_s + drift_deg_s) * 0.02});
        }
    }
    double errorDeg() const { return degFromRad(filter_.pose().heading_rad - heading_rad_); }

    HedrBayes filter_{{}, {}};
    double t_s_ = 0.0;
    double heading_rad_ = 0.0;
};

TEST_F(HedrBayesDriving, FindsTheDriftOfAStraightDrive) {
    drive(120.0, 0.05);
    EXPECT_NEAR(errorDeg(), 0.0, 0.5);
    EXPECT_NEAR(degFromRad(filter_.gyro_bias_rad_s()), 0.05, 0.01);
}

TEST_F(HedrBayesDriving, FollowsAWayOffTheCorridorsAndComesBack) {
    drive(60.0, 0.0);
    drive(1.0, 0.0, 20.0);
    drive(40.0, 0.0);
    EXPECT_NEAR(errorDeg(), 0.0, 3.0);
    drive(1.0, 0.0, -20.0);
    drive(40.0, 0.0);
    EXPECT_NEAR(errorDeg(), 0.0, 1.0);
}

TEST_F(HedrBayesDriving, SaysThatItIsLostWhereNothingIsStraight) {
    drive(600.0, 0.0, 5.0);
    EXPECT_TRUE(filter_.status().lost);
}

TEST_F(HedrBayesDriving, KeepsItsCovarianceSymmetricAndPositive) {
    for (int leg = 0; leg < 20; ++leg) {
        drive(20.0, 0.02);
        drive(3.0, 0.02, leg % 3 == 0 ? -30.0 : 30.0);
        const Eigen::Matrix3d covariance = filter_.covariance();
        EXPECT_TRUE(covariance.isApprox(covariance.transpose(), 1e-9));
        EXPECT_GT(covariance.determinant(), 0.0);
        EXPECT_GT(covariance(0, 0), 0.0);
        EXPECT_GT(covariance(2, 2), 0.0);
    }
}

// It starts aslant, and drifts while it turns into the corridor.
TEST_F(HedrBayesDriving, KeepsToTheDirectionThatAPlanTells) {
    filter_.setDirection(radFromDeg(110.0));  // the same as 20
    drive(40.0, 0.05);
    drive(1.0, 0.05, 20.0);
    drive(120.0, 0.05);
    EXPECT_NEAR(errorDeg(), 0.0, 0.5);
    EXPECT_NEAR(degFromRad(filter_.gyro_bias_rad_s()), 0.05, 0.01);
}

TEST_F(HedrBayesDriving, BelievesThePlanThatWasCorrected) {
    filter_.setDirection(radFromDeg(8.0));
    drive(60.0, 0.0);
    filter_.setDirection(radFromDeg(0.0));
    drive(120.0, 0.0);
    EXPECT_NEAR(errorDeg(), 0.0, 0.7);
    EXPECT_FALSE(filter_.status().lost);
}

// The error of a turn is in the heading, in the leg and in what the encoders say of it.
TEST(HedrBayes, KeepsItsVariancesPositiveWithAWildGyro) {
    for (const double noise : {0.15, 1.0, 1e5}) {
        Vehicle vehicle;
        vehicle.gyro_noise_rad_s_sqrthz = noise;
        HedrBayes filter({}, hedrBayesPreset(vehicle));
        for (int i = 1; i <= 20000; ++i) {
            const double turn = i % 1500 < 100 ? 0.016 : 0.001 * std::sin(0.1 * i);
            filter.update({.t_s = 0.02 * i,
                           .dt_s = 0.02,
                           .distance_m = 0.01,
                           .odometry_turn_rad = turn,
                           .gyro_turn_rad = turn + 0.002 * std::cos(1.7 * i)});
            ASSERT_GE(filter.covariance().diagonal().minCoeff(), 0.0) << noise << ' ' << i;
            ASSERT_TRUE(std::isfinite(filter.pose().heading_rad)) << noise;
        }
    }
}

// A robot that stands for ten seconds and then drives, with a gyro whose vehicle file says nothing.
double headingSigmaAfterDriving_deg(double gyro_noise_deg_sqrts) {
    HedrBayes filter({}, hedrBayesPreset(Vehicle{}));
    std::mt19937 random(1);
    for (int i = 1; i <= 1500; ++i) {
        const bool standing = i <= 500;
        const double swerve = radFromDeg(i % 200 < 100 ? 5.0 : -5.0);  // along no corridor
        const double noise = (static_cast<double>(random() % 2001) / 1000.0 - 1.0) * std::sqrt(3.0);
        filter.update({.t_s = 0.02 * i,
                       .dt_s = 0.02,
                       .distance_m = standing ? 0.0 : 0.01,
                       .gyro_turn_rad = radFromDeg(gyro_noise_deg_sqrts) * std::sqrt(0.02) * noise +
                                        (standing ? 0.0 : swerve * 0.02),
                       .standing = standing});
    }
    return degFromRad(std::sqrt(filter.covariance()(2, 2)));
}

TEST(HedrBayes, LearnsHowNoisyTheGyroIsWhileItStands) {
    const double usual = headingSigmaAfterDriving_deg(0.03);
    const double noisy = headingSigmaAfterDriving_deg(0.2);
    EXPECT_GT(noisy, 2.0 * usual);
    EXPECT_LT(noisy, 4.0 * usual);
}

// The gyro falls silent: what the wheels saw of a bend is believed, less surely, and no bias of the
// gyro is taken from it.
TEST(HedrBayes, BelievesTheWheelsWhereTheGyroIsSilent) {
    HedrBayes filter({}, hedrBayesPreset(Vehicle{}));
    double heading_rad = 0.0;
    const auto drive = [&](double seconds, double turn_deg_s, bool silent) {
        for (int i = 0; i < static_cast<int>(50.0 * seconds); ++i) {
            const double turn_rad = radFromDeg(turn_deg_s) * 0.02;
            const double bias_rad = silent ? 0.0 : radFromDeg(0.3) * 0.02;
            heading_rad += turn_rad;
            filter.update({.dt_s = 0.02,
                           .distance_m = 0.01,
                           .odometry_turn_rad = turn_rad,
                           .gyro_turn_rad = turn_rad + bias_rad,
                           .gyro_silent = silent});
        }
    };
    drive(120.0, 0.0, false);
    const double sigma_before_rad = std::sqrt(filter.covariance()(2, 2));
    drive(10.0, 9.0, true);
    EXPECT_NEAR(degFromRad(filter.pose().heading_rad - heading_rad), 0.0, 8.0);
    EXPECT_NEAR(degFromRad(filter.gyro_bias_rad_s()), 0.3, 0.05);
    EXPECT_GT(std::sqrt(filter.covariance()(2, 2)), sigma_before_rad + radFromDeg(2.0));
}

// Nobody keeps straight where no wall guides him: a long slow bend is not taken for a drift of the
// gyro, of which a standing start told that it has none.
TEST(HedrBayes, LetsAWayOffTheCorridorsBend) {
    HedrBayes filter({}, hedrBayesPreset(Vehicle{}));
    double t_s = 0.0;
    double heading_rad = 0.0;
    const auto drive = [&](double seconds, double turn_deg_s, bool standing = false) {
        for (int i = 0; i < static_cast<int>(50.0 * seconds); ++i) {
            const double turn_rad = radFromDeg(turn_deg_s) * 0.02;
            t_s += 0.02;
            heading_rad += turn_rad;
            filter.update({.t_s = t_s,
                           .dt_s = 0.02,
                           .distance_m = standing ? 0.0 : 0.01,
                           .odometry_turn_rad = turn_rad,
                           .gyro_turn_rad = turn_rad,
                           .standing = standing});
        }
    };
    drive(10.0, 0.0, true);
    drive(60.0, 0.0);
    drive(1.0, 30.0);
    drive(40.0, 1.0);
    EXPECT_NEAR(degFromRad(filter.pose().heading_rad - heading_rad), 0.0, 5.0);
}

// Without a standing start nothing tells the bias but the wheels, here off by 0.1 °/s. That a gyro
// with next to no bias has been calibrated is likelier than that both are off by the same.
TEST(HedrBayes, BelievesThatAGyroWithHardlyABiasIsCalibrated) {
    HedrBayes filter({}, hedrBayesPreset(Vehicle{}));
    for (int i = 1; i <= 3000; ++i) {
        const double turn = radFromDeg(8.0) * std::sin(0.01 * i) * 0.02;
        filter.update({.t_s = 0.02 * i,
                       .dt_s = 0.02,
                       .distance_m = 0.01,
                       .odometry_turn_rad = turn - radFromDeg(0.1) * 0.02,
                       .gyro_turn_rad = turn});
    }
    EXPECT_LT(std::abs(degFromRad(filter.gyro_bias_rad_s())), 0.05);
}

}  // namespace
}  // namespace hedr
