#include "core/calibration/compass/correlated_errors.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/calibration/distributions.h"

namespace hedr {

namespace {

constexpr std::size_t kMostLags = 400;
constexpr double kSureCorrelation = 2.0;  // standard deviations of that of white noise

std::size_t endOfStretch(std::span<const std::size_t> begins, std::size_t stretch,
                         std::size_t count) {
    return stretch + 1 < begins.size() ? begins[stretch + 1] : count;
}

double covarianceAt(const Eigen::VectorXd& residuals, std::span<const std::size_t> begins,
                    std::size_t lag) {
    const auto count = static_cast<std::size_t>(residuals.size());
    double sum = 0.0;
    double pairs = 0.0;
    for (std::size_t stretch = 0; stretch < begins.size(); ++stretch) {
        const std::size_t end = endOfStretch(begins, stretch, count);
        if (begins[stretch] + lag >= end) continue;
        const auto length = static_cast<Eigen::Index>(end - begins[stretch] - lag);
        const auto first = static_cast<Eigen::Index>(begins[stretch]);
        const auto second = static_cast<Eigen::Index>(begins[stretch] + lag);
        sum += residuals.segment(first, length).dot(residuals.segment(second, length));
        pairs += static_cast<double>(length);
    }
    return pairs > 0.0 ? sum / pairs : 0.0;
}

// The jacobian's transpose times the jacobian of so many readings later, and that the other way
// round.
class LaggedProducts {
  public:
    LaggedProducts(const Eigen::MatrixXd& jacobian, std::span<const std::size_t> begins)
        : jacobian_(jacobian), begins_(begins) {}

    const Eigen::MatrixXd& at(std::size_t lag) {
        while (products_.size() <= lag) products_.push_back(productAt(products_.size()));
        return products_[lag];
    }

  private:
    Eigen::MatrixXd productAt(std::size_t lag) const {
        const auto count = static_cast<std::size_t>(jacobian_.rows());
        Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(jacobian_.cols(), jacobian_.cols());
        for (std::size_t stretch = 0; stretch < begins_.size(); ++stretch) {
            const std::size_t end = endOfStretch(begins_, stretch, count);
            if (begins_[stretch] + lag >= end) continue;
            const auto length = static_cast<Eigen::Index>(end - begins_[stretch] - lag);
            const auto first = static_cast<Eigen::Index>(begins_[stretch]);
            const auto second = static_cast<Eigen::Index>(begins_[stretch] + lag);
            sum += jacobian_.middleRows(first, length).transpose() *
                   jacobian_.middleRows(second, length);
        }
        return lag == 0 ? sum : sum + sum.transpose();
    }

    const Eigen::MatrixXd& jacobian_;
    std::span<const std::size_t> begins_;
    std::vector<Eigen::MatrixXd> products_{};
};

Eigen::MatrixXd scoresOf(LaggedProducts& products, const ErrorCorrelation& correlation) {
    const std::vector<double>& covariance = correlation.covariance;
    Eigen::MatrixXd sum = covariance[0] * products.at(0);
    for (std::size_t lag = 1; lag < covariance.size(); ++lag) {
        sum += covariance[lag] * products.at(lag);
    }
    if (Eigen::LLT<Eigen::MatrixXd>(sum).info() == Eigen::Success) return sum;
    // Covariances that were cut need not be those of any errors: then no combination of scores is
    // surer than white noise would leave it.
    const Eigen::LLT<Eigen::MatrixXd> root(products.at(0));
    const Eigen::MatrixXd half = root.matrixL().solve(sum);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(
        root.matrixL().solve(half.transpose()));
    const Eigen::VectorXd sizes = eigen.eigenvalues().cwiseMax(covariance[0]);
    const Eigen::MatrixXd back = root.matrixL() * eigen.eigenvectors();
    return back * sizes.asDiagonal() * back.transpose();
}

// What is lost in chance goes on as it fell before.
void addTail(std::vector<double>& covariance) {
    constexpr std::size_t kFewestLags = 4;
    constexpr double kTailEnds = 0.01;
    if (covariance.size() < kFewestLags) return;
    const auto steps = static_cast<double>(covariance.size() - 2);
    const double ratio = std::pow(covariance.back() / covariance[1], 1.0 / steps);
    if (!(ratio < 1.0)) return;
    while (covariance.size() < kMostLags && covariance.back() > kTailEnds * covariance[0]) {
        covariance.push_back(ratio * covariance.back());
    }
}

// `raw`: the covariances of the residuals at all lags. `taken`: by the fit, from each of them.
ErrorCorrelation correlationWith(std::span<const double> raw, std::span<const double> taken,
                                 double count) {
    ErrorCorrelation result;
    const double variance = raw[0] + taken[0];
    result.covariance = {variance};
    // Noise across an ellipse changes its sign as the robot turns: a lag or two without any are not
    // yet the end.
    std::size_t last = 0;
    const double chance = kSureCorrelation / std::sqrt(count) * variance;
    for (std::size_t lag = 1; lag < raw.size() && lag <= last + last / 2 + 1; ++lag) {
        if (std::abs(raw[lag] + taken[lag]) > chance) last = lag;
    }
    for (std::size_t lag = 1; lag <= last; ++lag) {
        result.covariance.push_back(raw[lag] + taken[lag]);
    }
    result.degrees_of_freedom = count / (static_cast<double>(result.covariance.size()) - 0.5);
    addTail(result.covariance);
    return result;
}

}  // namespace

Eigen::MatrixXd scoreCovariance(const Eigen::MatrixXd& jacobian,
                                const ErrorCorrelation& correlation,
                                std::span<const std::size_t> begins) {
    LaggedProducts products(jacobian, begins);
    return scoresOf(products, correlation);
}

ErrorCorrelation correlationOf(const Eigen::VectorXd& residuals, const Eigen::MatrixXd& jacobian,
                               std::span<const std::size_t> begins) {
    constexpr int kRounds = 6;
    const double count = static_cast<double>(residuals.size());
    const auto lags = std::min(kMostLags, static_cast<std::size_t>(residuals.size()) / 8 + 1);
    std::vector<double> raw(lags, 0.0);
    for (std::size_t lag = 0; lag < lags; ++lag) raw[lag] = covarianceAt(residuals, begins, lag);
    LaggedProducts products(jacobian, begins);
    const Eigen::LDLT<Eigen::MatrixXd> normal(products.at(0));
    std::vector<double> taken(lags, 0.0);
    ErrorCorrelation result = correlationWith(raw, taken, count);
    for (int round = 0; round < kRounds; ++round) {
        // Of the fitted outline, whose points move with the parameters.
        const Eigen::MatrixXd errors =
            normal.solve(normal.solve(scoresOf(products, result)).transpose());
        const std::size_t reach = std::min(lags, 2 * result.covariance.size() + 1);
        for (std::size_t lag = 0; lag < reach; ++lag) {
            const double both_ways = lag == 0 ? 1.0 : 0.5;
            const double share = both_ways * errors.cwiseProduct(products.at(lag)).sum() / count;
            // Where it takes more than it leaves there is no telling.
            taken[lag] = std::clamp(share, -raw[0], raw[0]);
        }
        result = correlationWith(raw, taken, count);
    }
    return result;
}

CorrelatedFit fitWithCorrelatedErrors(const Eigen::MatrixXd& design, const Eigen::VectorXd& values,
                                      std::span<const std::size_t> begins) {
    CorrelatedFit fit;
    const Eigen::MatrixXd inverse =
        (design.transpose() * design)
            .ldlt()
            .solve(Eigen::MatrixXd::Identity(design.cols(), design.cols()));
    fit.coefficients = inverse * (design.transpose() * values);
    fit.fitted = design * fit.coefficients;
    const ErrorCorrelation correlation = correlationOf(values - fit.fitted, design, begins);
    fit.covariance = inverse * scoreCovariance(design, correlation, begins) * inverse;
    return fit;
}

double CorrelatedFit::chanceOf(Eigen::Index first, Eigen::Index count) const {
    const Eigen::VectorXd part = coefficients.segment(first, count);
    const Eigen::MatrixXd errors = covariance.block(first, first, count, count);
    const double chi_squared = part.dot(errors.ldlt().solve(part));
    // Errors that are not positive definite tell nothing.
    if (!(chi_squared > 0.0) || !std::isfinite(chi_squared)) return 1.0;
    return chiSquaredTail(chi_squared, static_cast<double>(count));
}

}  // namespace hedr
