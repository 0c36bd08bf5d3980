#include "core/calibration/squares/square_shape.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/calibration/short_number.h"
#include "core/geometry/angle.h"

namespace hedr {

namespace {

constexpr double kSides = 4.0;
constexpr double kPiecesPerSide = 40.0;    // so short, a turn on the spot shows as such
constexpr double kTightestOfASide = 0.25;  // radius over side: what bends more is a corner
constexpr double kShortestOfASide = 0.25;  // over the mean side
constexpr double kSmallestCorner_rad = radFromDeg(30.0);  // less is steering
constexpr double kMostUnequal = 0.25;                     // opposite sides, over the mean side

double sumOf(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

double wayOf(const WheelTravel& step) { return 0.5 * (step.left_m + step.right_m); }

// Tells corners from sides while it walks along the way.
class ShapeWalker {
  public:
    explicit ShapeWalker(double side_m) : side_m_(side_m) {}

    void walk(double way_m, double turn_rad) {
        if (std::abs(turn_rad) * kTightestOfASide * side_m_ > std::abs(way_m)) {
            corner_rad_ += turn_rad;
            corner_way_m_ += way_m;
        } else {
            endCorner();
            shape_.sides_m.back() += way_m;
        }
    }

    SquareShape finish() {
        endCorner();
        dropShortSides();
        return shape_;
    }

  private:
    void endCorner() {
        const bool steered = std::abs(corner_rad_) < kSmallestCorner_rad;
        shape_.sides_m.back() += steered ? corner_way_m_ : 0.5 * corner_way_m_;
        if (!steered) {
            shape_.corners_rad.push_back(corner_rad_);
            shape_.sides_m.push_back(0.5 * corner_way_m_);
        }
        corner_rad_ = corner_way_m_ = 0.0;
    }

    // A corner that was taken in two goes is one.
    void dropShortSides() {
        for (std::size_t i = shape_.sides_m.size(); i-- > 0;) {
            if (std::abs(shape_.sides_m[i]) >= kShortestOfASide * side_m_) continue;
            const bool inner = i > 0 && i < shape_.corners_rad.size();
            if (inner) {
                shape_.corners_rad[i - 1] += shape_.corners_rad[i];
                shape_.corners_rad.erase(shape_.corners_rad.begin() +
                                         static_cast<std::ptrdiff_t>(i));
            }
            shape_.sides_m.erase(shape_.sides_m.begin() + static_cast<std::ptrdiff_t>(i));
        }
    }

    double side_m_;
    SquareShape shape_{.sides_m = {0.0}};
    double corner_rad_ = 0.0;
    double corner_way_m_ = 0.0;
};

}  // namespace

double SquareShape::turn_rad() const { return sumOf(corners_rad); }

double SquareShape::side_m() const {
    return sides_m.empty() ? 0.0 : sumOf(sides_m) / static_cast<double>(sides_m.size());
}

double SquareShape::corner_rad() const {
    return corners_rad.empty() ? 0.0
                               : std::abs(turn_rad()) / static_cast<double>(corners_rad.size());
}

SquareShape shapeOf(std::span<const WheelTravel> steps, double wheelbase_m) {
    double whole_way_m = 0.0;
    for (const WheelTravel& step : steps) whole_way_m += std::abs(wayOf(step));
    const double side_m = whole_way_m / kSides;
    ShapeWalker walker(side_m);
    WheelTravel piece;
    double rolled_m = 0.0;
    for (const WheelTravel& step : steps) {
        piece.left_m += step.left_m;
        piece.right_m += step.right_m;
        rolled_m += 0.5 * (std::abs(step.left_m) + std::abs(step.right_m));
        if (rolled_m < side_m / kPiecesPerSide) continue;
        walker.walk(wayOf(piece), (piece.right_m - piece.left_m) / wheelbase_m);
        piece = {};
        rolled_m = 0.0;
    }
    walker.walk(wayOf(piece), (piece.right_m - piece.left_m) / wheelbase_m);
    SquareShape shape = walker.finish();
    shape.way_m = whole_way_m;
    return shape;
}

std::string complaintAbout(const SquareShape& shape) {
    const std::vector<double>& sides = shape.sides_m;
    if (static_cast<double>(sides.size()) != kSides) {
        return "has " + std::to_string(sides.size()) + " sides where a square has four";
    }
    const auto [least, most] = std::ranges::minmax_element(shape.corners_rad);
    if (*least < 0.0 && *most > 0.0) return "turned both ways";
    const double most_m = kMostUnequal * std::abs(shape.side_m());
    for (const std::size_t i : {0U, 1U}) {
        if (std::abs(sides[i] - sides[i + 2]) <= most_m) continue;
        return "is not closed: opposite sides of it are " + shortNumber(sides[i]) + " m and " +
               shortNumber(sides[i + 2]) + " m long";
    }
    return {};
}

}  // namespace hedr
