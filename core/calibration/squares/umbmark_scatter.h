#pragma once

#include <span>
#include <vector>

#include "core/calibration/estimate.h"
#include "core/calibration/squares/umbmark_solution.h"

namespace hedr {

// Smaller differences are those of reading a tape measure.
inline constexpr double kReadingOfTape_m = 0.005;

// An end far from those of the other squares of its direction.
struct FarEnd {
    const SquareRun* run = nullptr;
    double distance_m = 0.0;
};

struct NearEnds {
    std::vector<MeasuredSquare> squares{};
    UmbmarkSolution solution{};  // by these alone
    std::vector<FarEnd> far{};
};

// The squares without those that ended far from the others, by the scatter of the others; of an
// honest set in a hundred one is lost. Generalised extreme studentised deviates (Rosner 1983): the
// farthest is taken away again and again, and as many are far as the last one that is surely so,
// since two can hide each other. Of two in a direction nobody knows which is wrong: both stay.
NearEnds withoutFarEnds(const std::vector<MeasuredSquare>& squares,
                        const VehicleGeometry& believed);

// How well the squares of both directions want the same ratios.
struct DirectionsAgree {
    double chance = 1.0;       // that honest ends differ so much
    double variance_m2 = 0.0;  // of an end, were that its reason; two degrees of freedom
};
DirectionsAgree directionsAgree(const UmbmarkSolution& solution,
                                std::span<const MeasuredSquare> squares);

// How far an end moves with each ratio, root mean square.
Eigen::Vector2d metresPerRatio(std::span<const EndEquation> equations);

// The solution without each of the squares.
std::vector<UmbmarkRatios> ratiosWithoutEach(const UmbmarkSolution& solution);

struct UmbmarkEstimates {
    Estimate diameter_ratio{};
    Estimate wheelbase_ratio{};
};

// By the scatter within each direction. A square is one sample: an uneven floor moves x and
// y of its end together, most along the line on which the ratios move it, and as much in one
// direction as in the other. Of two squares each way or more.
UmbmarkEstimates estimatesOf(const UmbmarkSolution& solution,
                             std::span<const MeasuredSquare> squares);

// For ends that are wrong in the same way in all squares of a direction.
UmbmarkEstimates estimatesOf(const UmbmarkSolution& solution, const DirectionsAgree& directions);

}  // namespace hedr
