#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <functional>
#include <vector>

#include "core/site/plan.h"

namespace hedr::test {

// A sheet printed with squares, a margin around them as broad as one; its middle at (0, 0).
struct Checkerboard {
    int columns = 14;
    int rows = 10;
    double square_m = 0.02;

    double width_m() const { return (columns + 2) * square_m; }
    double height_m() const { return (rows + 2) * square_m; }
    double brightness(double x_m, double y_m) const {
        const double column = std::floor(x_m / square_m + 0.5 * columns);
        const double row = std::floor(y_m / square_m + 0.5 * rows);
        if (column < -1.0 || row < -1.0 || column > columns || row > rows) return 90.0;
        if (column < 0.0 || row < 0.0 || column == columns || row == rows) return 225.0;
        return std::fmod(column + row, 2.0) == 0.0 ? 45.0 : 215.0;
    }
};

// Where the four squares next to `guess` meet: the point that all edges around it run through.
inline Eigen::Vector2d saddleNear(const PlanLevel& image, Eigen::Vector2d guess, int reach_px) {
    const auto grey = [&](int x, int y) {
        return static_cast<double>(
            image.pixels->at(static_cast<std::size_t>(y * image.width_px + x)));
    };
    for (int round = 0; round < 8; ++round) {
        Eigen::Matrix2d weight = Eigen::Matrix2d::Zero();
        Eigen::Vector2d sum = Eigen::Vector2d::Zero();
        const int x0 = static_cast<int>(guess.x());
        const int y0 = static_cast<int>(guess.y());
        for (int y = y0 - reach_px; y <= y0 + reach_px; ++y) {
            for (int x = x0 - reach_px; x <= x0 + reach_px; ++x) {
                const Eigen::Vector2d slope(grey(x + 1, y) - grey(x - 1, y),
                                            grey(x, y + 1) - grey(x, y - 1));
                const Eigen::Vector2d middle(x + 0.5, y + 0.5);
                const double far = (middle - guess).squaredNorm() / (reach_px * reach_px);
                const Eigen::Matrix2d part = std::exp(-2.0 * far) * slope * slope.transpose();
                weight += part;
                sum += part * middle;
            }
        }
        guess = weight.inverse() * sum;
    }
    return guess;
}

// How much longer a metre is in one direction than in another, at most, of the affine map that
// fits best: 0 for a similarity.
inline double anisotropy(const std::vector<Eigen::Vector2d>& from,
                         const std::vector<Eigen::Vector2d>& to) {
    const auto count = static_cast<Eigen::Index>(from.size());
    Eigen::MatrixXd a(count, 3);
    Eigen::MatrixXd b(count, 2);
    for (Eigen::Index i = 0; i < count; ++i) {
        const auto k = static_cast<std::size_t>(i);
        a.row(i) << from[k].x(), from[k].y(), 1.0;
        b.row(i) = to[k].transpose();
    }
    const Eigen::MatrixXd map = a.colPivHouseholderQr().solve(b);
    const Eigen::Matrix2d linear = map.topRows<2>();
    const Eigen::Vector2d scales = linear.jacobiSvd().singularValues();
    return scales[0] / scales[1] - 1.0;
}

struct Anisotropy {
    double whole = 0.0;  // of the sheet
    double worst = 0.0;  // of any 4 x 4 corners
};

// Measures the board's inner corners in `image`; `expected` says roughly where a point of the
// sheet (metres) lies.
inline Anisotropy measured(const Checkerboard& board, const PlanLevel& image,
                           const std::function<Eigen::Vector2d(double, double)>& expected,
                           int reach_px) {
    const int across = board.columns - 1;
    const int down = board.rows - 1;
    std::vector<Eigen::Vector2d> sheet;
    std::vector<Eigen::Vector2d> found;
    for (int i = 0; i < across * down; ++i) {
        const double x = (i % across + 1 - 0.5 * board.columns) * board.square_m;
        const double y = (i / across + 1 - 0.5 * board.rows) * board.square_m;
        sheet.emplace_back(x, y);
        found.push_back(saddleNear(image, expected(x, y), reach_px));
    }
    Anisotropy result{anisotropy(sheet, found), 0.0};
    for (int top = 0; top + 4 <= down; ++top) {
        for (int left = 0; left + 4 <= across; ++left) {
            std::vector<Eigen::Vector2d> from;
            std::vector<Eigen::Vector2d> to;
            for (int k = 0; k < 16; ++k) {
                const auto at = static_cast<std::size_t>((top + k / 4) * across + left + k % 4);
                from.push_back(sheet[at]);
                to.push_back(found[at]);
            }
            result.worst = std::max(result.worst, anisotropy(from, to));
        }
    }
    return result;
}

}  // namespace hedr::test
