#include "core/calibration/encoders/encoder_period.h"

#include <Eigen/Core>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <complex>

#include "core/geometry/angle.h"

namespace hedr {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kSmooth_s = 0.2;  // each way: over some counts of coarse encoders
constexpr int kTrend = 4;          // coefficients of a wandering robot
constexpr int kMostHarmonics = 8;
constexpr int kFewestHarmonics = 4;
constexpr int kFirstHarmonic = 2;          // a wheel that is not round has the first one
constexpr double kTicksPerHarmonic = 3.0;  // counts themselves are a line at the number of them
constexpr double kSamplesPerColumn = 3.0;
constexpr std::size_t kMostSamples = 400;
constexpr double kMostMissing = 0.1;  // more shows in the distance
constexpr int kShares = 13;
constexpr double kSigmas = 5.0;       // of the steps, at the angle where they are largest
constexpr double kFewestTicks = 0.6;  // missing; less is what a healthy encoder does
constexpr double kSmallestShare = 0.008;

// Where a wheel was, and by how much it was ahead of the other one, in revolutions.
struct Ahead {
    VectorXd angle{};
    VectorXd ahead{};
    MatrixXd trend{};  // what makes it so on a wandering robot with wheels of two sizes
};

MatrixXd trendOf(const VectorXd& angle, const VectorXd& gyro_rad) {
    const double middle = 0.5 * (angle.minCoeff() + angle.maxCoeff());
    const double half = 0.5 * (angle.maxCoeff() - angle.minCoeff());
    const VectorXd along = (angle.array() - middle) / half;
    MatrixXd trend(along.size(), kTrend);
    for (int power = 0; power < kTrend; ++power) trend.col(power) = along.array().pow(power);
    if (gyro_rad.isZero()) return trend;
    trend.conservativeResize(Eigen::NoChange, kTrend + 1);
    trend.rightCols(1) = gyro_rad;
    return trend;
}

// The angle is that of the other wheel and the trend, as its own counts may have gaps.
Ahead aheadOf(const WheelPairRun& run, bool left) {
    const auto& moments = run.moments;
    const auto other = [left](const WheelPair& at) {
        return left ? at.right_revolutions : at.left_revolutions;
    };
    const auto own = [left](const WheelPair& at) {
        return left ? at.left_revolutions : at.right_revolutions;
    };
    const std::size_t every = moments.size() / kMostSamples + 1;
    const auto n = static_cast<Eigen::Index>((moments.size() - 1) / every + 1);
    VectorXd others(n);
    VectorXd ahead(n);
    VectorXd gyro_rad(n);
    std::size_t first = 0;
    std::size_t last = 0;
    double sum = 0.0;
    for (Eigen::Index i = 0; i < n; ++i) {
        const WheelPair& moment = moments[static_cast<std::size_t>(i) * every];
        for (; last < moments.size() && moments[last].t_s <= moment.t_s + kSmooth_s; ++last) {
            sum += other(moments[last]);
        }
        for (; moments[first].t_s < moment.t_s - kSmooth_s; ++first) sum -= other(moments[first]);
        others(i) = sum / static_cast<double>(last - first);
        ahead(i) = own(moment) - other(moment);
        gyro_rad(i) = moment.gyro_rad;
    }
    const MatrixXd trend = trendOf(others, gyro_rad);
    return {others + trend * trend.colPivHouseholderQr().solve(ahead), ahead, trend};
}

int harmonicsOf(const WheelPairRun& run) {
    const double by_ticks = run.ticks_per_revolution / kTicksPerHarmonic;
    const double samples = static_cast<double>(std::min(run.moments.size(), kMostSamples));
    const double by_samples = (samples / kSamplesPerColumn - kTrend) / 4.0;
    return static_cast<int>(std::min({by_ticks, by_samples, double{kMostHarmonics}}));
}

// What the harmonics of a revolution, and what is half-way between them, have of the difference.
struct Spectrum {
    std::vector<std::complex<double>> lines{};    // at 1, 2, …
    std::vector<std::complex<double>> between{};  // at 1.5, 2.5, …
};

// All at once with a trend, so that none leaks into another.
Spectrum spectrumOf(const Ahead& data, double stretch, Eigen::Index harmonics) {
    MatrixXd design(data.trend.rows(), data.trend.cols() + 4 * harmonics);
    design.leftCols(data.trend.cols()) = data.trend;
    for (Eigen::Index i = 0; i < 2 * harmonics; ++i) {
        const double harmonic = 1.0 + 0.5 * static_cast<double>(i);
        const VectorXd phase = 2.0 * kPi * harmonic * stretch * data.angle;
        design.col(data.trend.cols() + 2 * i) = phase.array().cos();
        design.col(data.trend.cols() + 2 * i + 1) = phase.array().sin();
    }
    const VectorXd fit = design.colPivHouseholderQr().solve(data.ahead).tail(4 * harmonics);
    Spectrum spectrum;
    for (Eigen::Index i = 0; i < 2 * harmonics; ++i) {
        (i % 2 == 0 ? spectrum.lines : spectrum.between).emplace_back(fit(2 * i), fit(2 * i + 1));
    }
    return spectrum;
}

// How fast a wheel gets ahead by chance, at each harmonic: logarithms of the variance.
VectorXd chanceOf(const Spectrum& spectrum) {
    const auto n = static_cast<Eigen::Index>(spectrum.between.size());
    MatrixXd powers(n, 2);
    MatrixXd lines(n, 2);
    VectorXd logs(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const double harmonic = static_cast<double>(i) + 1.0;
        const double slope =
            2.0 * kPi * (harmonic + 0.5) * std::abs(spectrum.between[static_cast<std::size_t>(i)]);
        constexpr double kMeanOfLog = -0.5772;  // of a variable with an exponential distribution
        constexpr double kTiny = 1e-30;
        powers.row(i) << 1.0, std::log(harmonic + 0.5);
        lines.row(i) << 1.0, std::log(harmonic);
        logs(i) = std::log(kTiny + 0.5 * slope * slope) - kMeanOfLog;
    }
    return lines * powers.colPivHouseholderQr().solve(logs);
}

// How fast a line gets ahead at that angle.
double slopeAt(const std::complex<double>& line, double harmonic, double angle) {
    const double omega = 2.0 * kPi * harmonic;
    return omega * (line.imag() * std::cos(omega * angle) - line.real() * std::sin(omega * angle));
}

struct Step {
    double share = 0.0;   // back, of a revolution
    double sigmas = 0.0;  // over chance
};

// The best step back: all its lines fall alike where it is. `chance`: variance at each harmonic.
Step bestStep(const Spectrum& spectrum, const std::vector<double>& chance) {
    constexpr int kAngles = 120;
    Step best;
    for (int at = 0; at < kAngles; ++at) {
        double sum = 0.0;
        double weights = 0.0;
        for (std::size_t i = kFirstHarmonic - 1; i < spectrum.lines.size(); ++i) {
            const double harmonic = static_cast<double>(i + 1);
            const double angle = static_cast<double>(at) / kAngles;
            sum -= slopeAt(spectrum.lines[i], harmonic, angle) / chance[i];
            weights += 1.0 / chance[i];
        }
        // A step of a share has twice that share as slope in each line.
        const Step step{0.5 * sum / weights, sum / std::sqrt(weights)};
        if (step.sigmas > best.sigmas) best = step;
    }
    return best;
}

// Its angle is larger than its counts say, by the share that is missing: the one that shows best.
MissingCounts missingCountsOf(const WheelPairRun& run, bool left, int harmonics) {
    const Ahead data = aheadOf(run, left);
    std::vector<Spectrum> spectra;
    VectorXd chance = VectorXd::Zero(harmonics);
    for (int i = 0; i < kShares; ++i) {
        spectra.push_back(spectrumOf(data, 1.0 + kMostMissing * i / (kShares - 1), harmonics));
        chance += chanceOf(spectra.back()) / kShares;
    }
    chance = chance.array().exp();
    Step best;
    for (const Spectrum& spectrum : spectra) {
        const Step step = bestStep(spectrum, {chance.begin(), chance.end()});
        if (step.sigmas > best.sigmas) best = step;
    }
    return {left, best.share,
            std::min({best.sigmas / kSigmas, best.share * run.ticks_per_revolution / kFewestTicks,
                      best.share / kSmallestShare})};
}

}  // namespace

double revolutionsOf(const WheelPairRun& run) {
    if (run.moments.empty()) return 0.0;
    const WheelPair& first = run.moments.front();
    const WheelPair& last = run.moments.back();
    return 0.5 * (last.left_revolutions - first.left_revolutions + last.right_revolutions -
                  first.right_revolutions);
}

std::optional<MissingCounts> missingCountsIn(const WheelPairRun& run) {
    const int harmonics = harmonicsOf(run);
    if (revolutionsOf(run) < kFewestRevolutions || harmonics < kFewestHarmonics)
        return std::nullopt;
    const MissingCounts left = missingCountsOf(run, true, harmonics);
    const MissingCounts right = missingCountsOf(run, false, harmonics);
    return left.share > right.share ? left : right;
}

}  // namespace hedr
