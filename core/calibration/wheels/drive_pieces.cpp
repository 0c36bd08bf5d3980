#include "core/calibration/wheels/drive_pieces.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "core/calibration/median.h"

namespace hedr {

namespace {

constexpr double kCell_s = 0.5;
constexpr double kGap_s = 1.0;
constexpr double kTurning_rad_s = 0.15;       // more than steering in a corridor
constexpr double kWheelsCountAgain_m = 5e-4;  // fine encoders go to and fro by a count
constexpr double kStandsFor_s = 2.0;
constexpr double kLongestStraight_s = 5.0;
constexpr double kLongestTurn_s = 8.0;
constexpr double kLongestStand_s = 10.0;

// Half a second of a drive, as a short piece.
struct DriveCell {
    DrivePiece piece{};
    bool after_gap = false;
};

DrivePiece between(const EncoderMoment& from, const EncoderMoment& to) {
    const double left_m = to.left_m - from.left_m;
    const double right_m = to.right_m - from.right_m;
    return {.begin_s = from.t_s,
            .end_s = to.t_s,
            .way_m = 0.5 * (left_m + right_m),
            .rolled_m = 0.5 * (std::abs(left_m) + std::abs(right_m)),
            .difference_m = right_m - left_m,
            .gyro_rad = to.gyro_rad - from.gyro_rad};
}

std::vector<DriveCell> cellsOf(const EncoderTravel& travel) {
    std::vector<DriveCell> cells;
    if (travel.moments.empty()) return cells;
    const EncoderMoment* from = &travel.moments.front();
    const EncoderMoment* last = from;
    bool after_gap = true;
    for (const EncoderMoment& moment : travel.moments) {
        if (moment.t_s - last->t_s > kGap_s) {
            from = &moment;
            after_gap = true;
        } else if (moment.t_s - from->t_s >= kCell_s) {
            cells.push_back({between(*from, moment), after_gap});
            from = &moment;
            after_gap = false;
        }
        last = &moment;
    }
    return cells;
}

// Where nothing says what the gyro's bias is, what it has more than the wheels most of the time.
void removeUnknownBias(std::vector<DriveCell>& cells, double wheelbase_m) {
    std::vector<double> rates_rad_s;
    rates_rad_s.reserve(cells.size());
    for (const DriveCell& cell : cells) {
        const DrivePiece& piece = cell.piece;
        rates_rad_s.push_back((piece.gyro_rad - piece.difference_m / wheelbase_m) / piece.span_s());
    }
    if (rates_rad_s.empty()) return;
    const double bias_rad_s = medianOf(std::move(rates_rad_s));
    for (DriveCell& cell : cells) cell.piece.gyro_rad -= bias_rad_s * cell.piece.span_s();
}

bool isStill(const DriveCell& cell) { return cell.piece.rolled_m <= kWheelsCountAgain_m; }

// The wheels did not count for a while, and not only between two counts of a slow drive.
void markStands(std::span<DriveCell> cells) {
    for (std::size_t begin = 0; begin < cells.size();) {
        std::size_t end = begin;
        while (end < cells.size() && isStill(cells[end]) && (end == begin || !cells[end].after_gap))
            ++end;
        if (end == begin) {
            ++begin;
            continue;
        }
        for (std::size_t i = begin + 1; i + 1 < end; ++i) {
            const bool long_enough =
                cells[end - 1].piece.end_s - cells[begin].piece.begin_s >= kStandsFor_s;
            if (long_enough) cells[i].piece.kind = DriveKind::kStand;
        }
        begin = end;
    }
}

bool turnsFast(const DriveCell& cell) {
    return std::abs(cell.piece.gyro_rad) > kTurning_rad_s * cell.piece.span_s();
}

// With the moments before and after, in which it begins and ends to turn.
void markTurns(std::span<DriveCell> cells) {
    const auto mark = [](DriveCell& cell) {
        if (cell.piece.kind != DriveKind::kStand) cell.piece.kind = DriveKind::kTurn;
    };
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (!turnsFast(cells[i])) continue;
        mark(cells[i]);
        if (i > 0 && !cells[i].after_gap) mark(cells[i - 1]);
        if (i + 1 < cells.size() && !cells[i + 1].after_gap) mark(cells[i + 1]);
    }
}

double longestPiece_s(DriveKind kind) {
    switch (kind) {
        case DriveKind::kStand:
            return kLongestStand_s;
        case DriveKind::kStraight:
            return kLongestStraight_s;
        case DriveKind::kTurn:
            return kLongestTurn_s;
    }
    return kLongestStraight_s;
}

void append(DrivePiece& piece, const DrivePiece& next) {
    piece.end_s = next.end_s;
    piece.way_m += next.way_m;
    piece.rolled_m += next.rolled_m;
    piece.difference_m += next.difference_m;
    piece.gyro_rad += next.gyro_rad;
}

bool goesOn(const DrivePiece& piece, const DriveCell& cell) {
    if (cell.after_gap || cell.piece.kind != piece.kind) return false;
    if (cell.piece.end_s - piece.begin_s > longestPiece_s(piece.kind)) return false;
    const bool other_way =
        piece.kind == DriveKind::kTurn && piece.gyro_rad * cell.piece.gyro_rad < 0.0;
    return !other_way || !turnsFast(cell);
}

}  // namespace

std::vector<DrivePiece> piecesOf(const EncoderTravel& travel, double wheelbase_m) {
    std::vector<DriveCell> cells = cellsOf(travel);
    if (!travel.knows_gyro_bias) removeUnknownBias(cells, wheelbase_m);
    markStands(cells);
    markTurns(cells);
    std::vector<DrivePiece> pieces;
    for (const DriveCell& cell : cells) {
        if (!pieces.empty() && goesOn(pieces.back(), cell)) {
            append(pieces.back(), cell.piece);
        } else {
            pieces.push_back(cell.piece);
        }
    }
    return pieces;
}

}  // namespace hedr
