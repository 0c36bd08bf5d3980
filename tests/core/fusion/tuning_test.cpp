#include "core/fusion/tuning.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace hedr {
namespace {

const std::vector kAlphaBeta{&GhGains::alpha, &GhGains::beta};

bool always(std::size_t, std::size_t) { return true; }

TEST(TuneGains, FindsTheBestOnItsGrid) {
    const auto tuning = tuneGains(
        {0.2, 0.3, 0.9}, kAlphaBeta,
        [](const GhGains& gains) {
            return std::abs(gains.alpha - 0.63) + std::abs(gains.beta - 0.21);
        },
        always);
    ASSERT_TRUE(tuning);
    EXPECT_DOUBLE_EQ(tuning->best.alpha, 0.65);
    EXPECT_DOUBLE_EQ(tuning->best.beta, 0.2);
    EXPECT_DOUBLE_EQ(tuning->best.gamma, 0.9);
    EXPECT_NEAR(tuning->error, 0.03, 1e-12);
}

TEST(TuneGains, TriesThePapersValuesInThePapersOrder) {
    const auto tuning = tuneGains(
        {0.2, 0.3, 0.9}, kAlphaBeta, [](const GhGains& gains) { return -gains.alpha; }, always);
    ASSERT_TRUE(tuning);
    ASSERT_EQ(tuning->sweeps.size(), 4u);
    EXPECT_EQ(tuning->sweeps[0].gain, &GhGains::alpha);
    EXPECT_EQ(tuning->sweeps[1].gain, &GhGains::beta);
    std::vector<double> coarse;
    for (const auto& trial : tuning->sweeps[0].trials) coarse.push_back(trial.value);
    EXPECT_EQ(coarse, (std::vector{0.1, 0.3, 0.5, 0.7, 0.9}));
    std::vector<double> fine;
    for (const auto& trial : tuning->sweeps[2].trials) fine.push_back(trial.value);
    EXPECT_EQ(fine, (std::vector{0.8, 0.85, 0.9, 0.95, 1.0}));
    EXPECT_DOUBLE_EQ(tuning->best.alpha, 1.0);
    EXPECT_DOUBLE_EQ(tuning->best.beta, 0.0);  // all the same: the first
}

TEST(TuneGains, AnErrorThatIsNoNumberIsTheWorst) {
    const auto tuning = tuneGains(
        {0.2, 0.3, 0.9}, {&GhGains::alpha},
        [](const GhGains& gains) {
            return gains.alpha < 0.4 ? std::numeric_limits<double>::quiet_NaN() : gains.alpha;
        },
        always);
    ASSERT_TRUE(tuning);
    EXPECT_DOUBLE_EQ(tuning->best.alpha, 0.4);
}

TEST(TuneGains, StopsWhenItIsTold) {
    std::size_t told = 0;
    const auto tuning = tuneGains(
        {}, kAlphaBeta, [](const GhGains&) { return 0.0; },
        [&](std::size_t made, std::size_t of) {
            EXPECT_EQ(of, 20u);
            told = made;
            return made < 7;
        });
    EXPECT_FALSE(tuning);
    EXPECT_EQ(told, 7u);
}

}  // namespace
}  // namespace hedr
