#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

namespace hedr {

// How errors hang together that follow one another in time: a field's noise is seldom white.
struct ErrorCorrelation {
    std::vector<double> covariance{};  // at lags 0, 1, … until chance is larger than it
    // Of their spectrum near one wave per turn, as a sum over so many lags tells it: 2 n / (2 lags
    // + 1) (G. M. Jenkins, D. G. Watts, "Spectral Analysis", 1968, 6.4).
    double degrees_of_freedom = 0.0;
};

// Residuals of a fit with that jacobian, one row each. What the fit took from the covariance at
// each lag, the autocovariance of the fitted part, is found in rounds and given back. `begins`: the
// indices at which a new stretch begins; errors of two stretches have nothing in common.
ErrorCorrelation correlationOf(const Eigen::VectorXd& residuals, const Eigen::MatrixXd& jacobian,
                               std::span<const std::size_t> begins);

// The covariance of jacobian^T * errors.
Eigen::MatrixXd scoreCovariance(const Eigen::MatrixXd& jacobian,
                                const ErrorCorrelation& correlation,
                                std::span<const std::size_t> begins);

// Ordinary least squares whose covariance is that of errors that hang together, after W. K. Newey,
// K. D. West, Econometrica 55(3), 1987, with the lags cut where they are lost in chance.
struct CorrelatedFit {
    Eigen::VectorXd coefficients{};
    Eigen::MatrixXd covariance{};
    Eigen::VectorXd fitted{};

    // Of coefficients `first`, … `first + count - 1` as large as these, where they are truly zero.
    double chanceOf(Eigen::Index first, Eigen::Index count) const;
};
CorrelatedFit fitWithCorrelatedErrors(const Eigen::MatrixXd& design, const Eigen::VectorXd& values,
                                      std::span<const std::size_t> begins);

}  // namespace hedr
