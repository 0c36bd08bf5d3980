#include "core/calibration/track_width.h"

#include <algorithm>
#include <cmath>

namespace hedr {

namespace {

constexpr std::size_t kFewestInClass = 5;
constexpr std::size_t kMostClasses = 5;

struct ClearTurn {
    double rate_rad_s = 0.0;
    double wheelbase_m = 0.0;
};

std::vector<ClearTurn> clearTurns(std::span<const DriveLog> logs, const DriveFit& fit) {
    std::vector<ClearTurn> turns;
    std::size_t piece = 0;
    for (const DriveLog& log : logs) {
        for (const DrivePiece& each : log.pieces) {
            const double turned_rad = fit.turned_rad[piece];
            const bool counts = fit.weights[piece] > 0.0;
            ++piece;
            if (!counts || each.kind != DriveKind::kTurn || std::abs(turned_rad) < kClearTurn_rad)
                continue;
            turns.push_back({std::abs(turned_rad) / each.span_s(),
                             wheelbaseInTurn_m(each, turned_rad, fit.right_larger.value)});
        }
    }
    return turns;
}

TrackWidth widthOf(std::span<const ClearTurn> turns) {
    const auto count = static_cast<double>(turns.size());
    TrackWidth width{.turns = turns.size()};
    double mean_m = 0.0;
    for (const ClearTurn& turn : turns) {
        width.rate_rad_s += turn.rate_rad_s / count;
        mean_m += turn.wheelbase_m / count;
    }
    double squares_m2 = 0.0;
    for (const ClearTurn& turn : turns)
        squares_m2 += (turn.wheelbase_m - mean_m) * (turn.wheelbase_m - mean_m);
    width.wheelbase_m = {mean_m, std::sqrt(squares_m2 / (count - 1.0) / count), count - 1.0};
    return width;
}

}  // namespace

double wheelbaseInTurn_m(const DrivePiece& turn, double turned_rad, double right_larger) {
    return (turn.difference_m + right_larger * turn.way_m) / turned_rad;
}

std::vector<TrackWidth> trackWidths(std::span<const DriveLog> logs, const DriveFit& fit) {
    if (fit.parts == 0) return {};
    std::vector<ClearTurn> turns = clearTurns(logs, fit);
    std::ranges::sort(turns, {}, &ClearTurn::rate_rad_s);
    const std::size_t classes = std::min(kMostClasses, turns.size() / kFewestInClass);
    std::vector<TrackWidth> widths;
    for (std::size_t i = 0; i < classes; ++i) {
        const std::size_t begin = i * turns.size() / classes;
        const std::size_t end = (i + 1) * turns.size() / classes;
        widths.push_back(widthOf(std::span(turns).subspan(begin, end - begin)));
    }
    return widths;
}

}  // namespace hedr
