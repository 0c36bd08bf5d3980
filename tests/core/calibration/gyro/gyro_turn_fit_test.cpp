#include "core/calibration/gyro/gyro_turn_fit.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <vector>

#include "core/geometry/angle.h"
#include "core/simulation/random.h"

namespace hedr {
namespace {

constexpr double kScale = 1.02;
constexpr double kMark_rad = radFromDeg(1.5);

// Whole turns one after another; noise and bias add `noise_rad` to each that is not the marks'.
TurnModel modelOf(const std::vector<int>& turns, double noise_rad) {
    const auto n = static_cast<Eigen::Index>(turns.size());
    TurnModel model{.reported_rad = Eigen::VectorXd::Zero(n),
                    .turned_rad = Eigen::VectorXd(n),
                    .known = noise_rad * noise_rad * Eigen::MatrixXd::Identity(n, n),
                    .known_degrees = 30.0,
                    .marks = 2.0 * Eigen::MatrixXd::Identity(n, n),
                    .usual_mark_rad = kMark_rad};
    for (Eigen::Index i = 0; i < n; ++i) {
        model.turned_rad(i) = 2.0 * kPi * turns[static_cast<std::size_t>(i)];
        if (i > 0) model.marks(i, i - 1) = model.marks(i - 1, i) = -1.0;
    }
    return model;
}

void turn(TurnModel& model, Random& random, double mark_rad) {
    const auto n = model.turned_rad.size();
    double beside_rad = mark_rad * random.normal();
    for (Eigen::Index i = 0; i < n; ++i) {
        const double next_rad = mark_rad * random.normal();
        model.reported_rad(i) = (model.turned_rad(i) + next_rad - beside_rad) / kScale +
                                std::sqrt(model.known(i, i)) * random.normal();
        beside_rad = next_rad;
    }
}

struct FitCase {
    const char* name;
    std::vector<int> turns;
    double mark_rad;
    double noise_rad = radFromDeg(0.1);
    bool wrong_mark = false;  // after the second turn
};

class TurnFits : public testing::TestWithParam<FitCase> {};

TEST_P(TurnFits, CoverTheTruthIn95PercentWithoutBias) {
    constexpr int kRuns = 2000;
    Random random(7);
    TurnModel model = modelOf(GetParam().turns, GetParam().noise_rad);
    int covered = 0;
    double sum = 0.0;
    double squares = 0.0;
    for (int run = 0; run < kRuns; ++run) {
        turn(model, random, GetParam().mark_rad);
        if (GetParam().wrong_mark) {
            const double off_rad = radFromDeg(random.uniform(20.0, 90.0));
            model.reported_rad(1) += off_rad;
            model.reported_rad(2) -= off_rad;
        }
        const TurnFit fit = fitTurns(model);
        EXPECT_LE(fit.outliers.size(), 2U);
        const double error = fit.both.value - kScale;
        covered += fit.both.interval().contains(kScale) ? 1 : 0;
        sum += error;
        squares += error * error;
    }
    EXPECT_GE(covered, kRuns * 93 / 100);
    EXPECT_LE(covered, kRuns * 97 / 100);
    EXPECT_LT(std::abs(sum / kRuns), 0.2 * std::sqrt(squares / kRuns));
}

INSTANTIATE_TEST_SUITE_P(
    Marks, TurnFits,
    testing::Values(FitCase{"one_each", {3, -3}, kMark_rad},
                    FitCase{"two_each", {3, -3, 3, -3}, kMark_rad},
                    FitCase{"two_and_two", {3, 3, -3, -3}, kMark_rad},
                    FitCase{"one_way", {2, 2, 2, 2}, kMark_rad},
                    FitCase{"five_and_five", {1, 1, 1, 1, 1, -1, -1, -1, -1, -1}, kMark_rad},
                    FitCase{"careful", {2, -2, 2, -2, 2, -2}, radFromDeg(0.5)},
                    FitCase{"sloppy", {2, -2, 2, -2, 2, -2}, radFromDeg(3.0)},
                    FitCase{"noisy", {2, -2, 2, -2, 2, -2}, kMark_rad, radFromDeg(1.5)},
                    FitCase{"wrong_mark", {2, -2, 2, -2, 2, -2}, kMark_rad, radFromDeg(0.1), true}),
    [](const auto& one) { return one.param.name; });

TEST(TurnFit, NamesTheTurnThatIsOff) {
    Random random(3);
    TurnModel model = modelOf({2, -2, 2, -2, 2, -2}, radFromDeg(0.1));
    turn(model, random, kMark_rad);
    model.reported_rad(5) += radFromDeg(40.0);
    const TurnFit fit = fitTurns(model);
    ASSERT_EQ(fit.outliers.size(), 1U);
    EXPECT_EQ(fit.outliers[0].turn, 5U);
    EXPECT_FALSE(fit.outliers[0].stand);
    EXPECT_NEAR(fit.outliers[0].off_rad, radFromDeg(40.0), radFromDeg(8.0));
}

TEST(TurnFit, NamesTheStandBesideTheMarkThatTwoTurnsShare) {
    Random random(4);
    TurnModel model = modelOf({2, -2, 2, -2, 2, -2}, radFromDeg(0.1));
    turn(model, random, kMark_rad);
    model.reported_rad(2) += radFromDeg(40.0);
    model.reported_rad(3) -= radFromDeg(40.0);
    const TurnFit fit = fitTurns(model);
    ASSERT_EQ(fit.outliers.size(), 1U);
    EXPECT_EQ(fit.outliers[0].turn, 2U);
    EXPECT_TRUE(fit.outliers[0].stand);
}

TEST(TurnFit, RarelyNamesWhatIsNotOff) {
    Random random(5);
    TurnModel model = modelOf({2, -2, 2, -2, 2, -2}, radFromDeg(0.1));
    int named = 0;
    for (int run = 0; run < 2000; ++run) {
        turn(model, random, kMark_rad);
        named += fitTurns(model).outliers.empty() ? 0 : 1;
    }
    EXPECT_LE(named, 20);
}

TEST(TurnFit, TellsTheDirectionsApart) {
    Random random(6);
    TurnModel model = modelOf({3, -3, 3, -3, 3, -3}, radFromDeg(0.05));
    turn(model, random, radFromDeg(0.3));
    for (const Eigen::Index right : {1, 3, 5}) model.reported_rad(right) *= 0.99;
    const TurnFit fit = fitTurns(model);
    EXPECT_NEAR(fit.difference->value, -0.01, fit.difference->margin());
    EXPECT_FALSE(fit.difference->interval().contains(0.0));
    EXPECT_LT(fit.counter_clockwise->value, fit.clockwise->value);
}

TEST(TurnFit, KnowsNoMoreThanTheGyroDoes) {
    TurnModel model = modelOf({1, -1, 1, -1}, radFromDeg(0.2));
    model.reported_rad = model.turned_rad;  // by a great chance
    const TurnFit fit = fitTurns(model);
    EXPECT_GE(fit.both.standard_error, 0.2 / 360.0 / 2.0 * 0.99);
}

TEST(TurnFit, JudgesATurnByTheOthers) {
    Random random(8);
    TurnModel model = modelOf({2, -2, 2, -2, 2, -2}, radFromDeg(0.1));
    turn(model, random, 0.0);
    model.reported_rad(3) *= 1.05;
    const TurnFit fit = fitTurns(model);
    EXPECT_NEAR(scaleWithout(model, fit, 3).value_or(0.0), kScale, 0.003);
    const TurnModel alone = modelOf({2}, radFromDeg(0.1));
    EXPECT_FALSE(scaleWithout(alone, TurnFit{}, 0));
}

}  // namespace
}  // namespace hedr
