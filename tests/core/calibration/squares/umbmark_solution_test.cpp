#include "core/calibration/squares/umbmark_solution.h"

#include <gtest/gtest.h>

#include "tests/core/calibration/squares/square_drives.h"

namespace hedr {
namespace {

// No noise of any kind; what is left are encoders that count whole ticks.
constexpr SquareDrives kFlawless{
    .clockwise = 1, .counter_clockwise = 1, .unevenness_m_sqrtm = 0.0, .tape_m = 0.0};

struct Measured {
    SquareRuns drives{};
    std::vector<MeasuredSquare> squares{};
};

Measured measured(const SquareDrives& drives, Random& random) {
    const DrivenSquares driven = drive(drives, random);
    Measured result{squareRunsOf(driven.sets, labmate()), {}};
    for (const SquareRun& run : result.drives.runs) {
        result.squares.push_back({&run, driven.ends[run.number - 1]});
    }
    return result;
}

void expectFound(SquareDrives drives, Random& random) {
    for (const bool along_tape : {false, true}) {
        drives.along_tape = along_tape;
        const Measured all = measured(drives, random);
        const UmbmarkSolution solution = solveUmbmark(all.squares, kLabmate);
        EXPECT_NEAR(solution.ratios.x(), drives.diameter_ratio, 2e-5);
        EXPECT_NEAR(solution.ratios.y(), drives.wheelbase_ratio, 2e-4);
    }
}

TEST(UmbmarkSolution, FindsWhatWasPutInHoweverLarge) {
    Random random(1);
    for (int i = 0; i < 60; ++i) {
        SquareDrives drives = kFlawless;
        drives.diameter_ratio = random.uniform(0.98, 1.02);
        drives.wheelbase_ratio = random.uniform(0.8, 1.4);
        SCOPED_TRACE(testing::Message()
                     << "E_d " << drives.diameter_ratio << ", E_b " << drives.wheelbase_ratio);
        expectFound(drives, random);
    }
}

// The slopes are right where they predict what other ratios do.
TEST(UmbmarkSolution, KnowsHowEndsMoveWithTheRatios) {
    Random random(2);
    const Measured all = measured(kFlawless, random);
    constexpr double kStep = 1e-6;
    for (const MeasuredSquare& square : all.squares) {
        const UmbmarkRatios at{1.01, 0.97};
        const EndEquation here = endEquation(square, kLabmate, at);
        for (int i = 0; i < 2; ++i) {
            UmbmarkRatios other = at;
            other(i) += kStep;
            const EndEquation there = endEquation(square, kLabmate, other);
            const Eigen::Vector2d slope = (here.error_m - there.error_m) / kStep;
            EXPECT_LT((slope - here.jacobian_m.col(i)).norm(), 1e-3 * slope.norm());
        }
    }
}

TEST(UmbmarkSolution, BeginsWhereItIsTold) {
    Random random(4);
    const Measured all = measured(SquareDrives{}, random);
    const UmbmarkSolution anywhere = solveUmbmark(all.squares, kLabmate);
    const UmbmarkSolution near = solveUmbmark(all.squares, kLabmate, anywhere.ratios);
    EXPECT_LT((anywhere.ratios - near.ratios).norm(), 1e-9);
}

}  // namespace
}  // namespace hedr
