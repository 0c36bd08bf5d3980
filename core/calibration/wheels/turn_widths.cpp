#include "core/calibration/wheels/turn_widths.h"

#include <algorithm>
#include <cmath>

namespace hedr {

namespace {

constexpr std::size_t kFewestInClass = 5;
constexpr std::size_t kMostClasses = 5;
constexpr double kTellingTurn_rad = 0.5;  // less does not tell a wheelbase

TrackWidth widthOf(std::span<const TurnWidth> turns) {
    const auto count = static_cast<double>(turns.size());
    TrackWidth width{.turns = turns.size()};
    double mean_m = 0.0;
    for (const TurnWidth& turn : turns) {
        width.rate_rad_s += turn.rate_rad_s / count;
        mean_m += turn.wheelbase_m / count;
    }
    double squares_m2 = 0.0;
    for (const TurnWidth& turn : turns)
        squares_m2 += (turn.wheelbase_m - mean_m) * (turn.wheelbase_m - mean_m);
    width.wheelbase_m = {mean_m, std::sqrt(squares_m2 / (count - 1.0) / count), count - 1.0};
    return width;
}

}  // namespace

std::vector<TurnWidth> turnWidths(std::span<const DriveLog> logs, const DriveFit& fit) {
    std::vector<TurnWidth> turns;
    if (fit.parts == 0) return turns;
    std::size_t piece = 0;
    for (const DriveLog& log : logs) {
        for (const DrivePiece& each : log.pieces) {
            const double turned_rad = fit.turned_rad[piece];
            const bool counts = fit.weights[piece++] > 0.0;
            const bool tells =
                each.kind == DriveKind::kTurn && std::abs(turned_rad) >= kTellingTurn_rad;
            if (!counts || !tells) continue;
            const double alike_m = each.difference_m + fit.right_larger.value * each.way_m;
            turns.push_back({std::abs(turned_rad) / each.span_s(), alike_m / turned_rad});
        }
    }
    return turns;
}

std::vector<TrackWidth> trackWidths(std::span<const DriveLog> logs, const DriveFit& fit) {
    std::vector<TurnWidth> turns = turnWidths(logs, fit);
    std::ranges::sort(turns, {}, &TurnWidth::rate_rad_s);
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
