#include "core/calibration/wheels/drive_fit.h"

#include <algorithm>
#include <cmath>

#include "core/calibration/jackknife.h"
#include "core/calibration/median.h"

namespace hedr {

namespace {

constexpr std::size_t kMostDriveParts = 20;
constexpr int kHuberRounds = 8;
constexpr int kBiweightRounds = 25;
constexpr int kRoundsWithout = 4;  // after leaving out a part
constexpr double kHuber = 1.5;
constexpr double kBiweight = 4.685;    // 95 % as sure as least squares where nothing slips
constexpr double kCapped = 2.5;        // residuals are not taken for larger in variances
constexpr double kCappedMean = 0.977;  // of the squares of normal ones, then
constexpr double kFirstSlip_m = 0.02;  // on one metre
constexpr double kFirstTurnSlip = 0.03;
constexpr double kLeastSlip_m = 1e-5;
constexpr double kLeastTurnSlip = 1e-4;
constexpr double kClearTurn_rad = 0.3;

// That a value is nearer than the believed one: surer than elsewhere, for of a thousand troubled
// drives three were believed with 99 % that made the wheels worse, as slip is not normal.
constexpr double kSureShare = 0.999;

double square(double value) { return value * value; }

// The variance (m²) of each row's difference.
struct DriveVariance {
    double slip_m2_m = square(kFirstSlip_m);
    double turn_slip2 = square(kFirstTurnSlip);
    double wheelbase_m = 0.0;

    double turnSquare_m2(const DrivePiece& piece) const {
        return square(wheelbase_m * piece.gyro_rad);
    }
    double of(const DriveRows& rows, Eigen::Index row) const {
        const DrivePiece& piece = rows.piece(row);
        const double gyro_m2 = square(wheelbase_m) * rows.gyroVariance_rad2(row);
        if (piece.kind == DriveKind::kStand) return gyro_m2;
        return gyro_m2 + square(rows.noise(row).count_m) / 3.0 + slip_m2_m * piece.rolled_m +
               turn_slip2 * turnSquare_m2(piece);
    }
    Eigen::VectorXd ofAll(const DriveRows& rows) const {
        Eigen::VectorXd all(rows.count());
        for (Eigen::Index row = 0; row < all.size(); ++row) all(row) = of(rows, row);
        return all;
    }
    // One step towards the likeliest (multiplicative, so that none becomes negative).
    void learn(const DriveRows& rows, const Eigen::VectorXd& residuals_m) {
        double slip_seen = 0.0, slip_said = 0.0, turn_seen = 0.0, turn_said = 0.0;
        for (Eigen::Index row = 0; row < rows.count(); ++row) {
            const DrivePiece& piece = rows.piece(row);
            if (piece.kind == DriveKind::kStand) continue;
            const double variance_m2 = of(rows, row);
            const double ratio = std::min(square(residuals_m(row)) / variance_m2, square(kCapped)) /
                                 kCappedMean / variance_m2;
            slip_seen += piece.rolled_m * ratio;
            slip_said += piece.rolled_m / variance_m2;
            turn_seen += turnSquare_m2(piece) * ratio;
            turn_said += turnSquare_m2(piece) / variance_m2;
        }
        slip_m2_m = std::max(slip_m2_m * slip_seen / slip_said, square(kLeastSlip_m));
        turn_slip2 = std::max(turn_slip2 * turn_seen / turn_said, square(kLeastTurnSlip));
    }
};

double huberWeight(double sigmas) { return sigmas > kHuber ? kHuber / sigmas : 1.0; }

double biweight(double sigmas) {
    return sigmas < kBiweight ? square(1.0 - square(sigmas / kBiweight)) : 0.0;
}

// What the wheels' difference is to the gyro's angle in most turns.
double roughWheelbase_m(const DriveRows& rows, double believed_m) {
    std::vector<double> wheelbases_m;
    for (Eigen::Index row = 0; row < rows.count(); ++row) {
        const DrivePiece& piece = rows.piece(row);
        if (piece.kind == DriveKind::kTurn && std::abs(piece.gyro_rad) > kClearTurn_rad)
            wheelbases_m.push_back(piece.difference_m / piece.gyro_rad);
    }
    return wheelbases_m.empty() ? believed_m : medianOf(std::move(wheelbases_m));
}

struct RobustSolution {
    Eigen::VectorXd solution{};
    Eigen::VectorXd robust{};   // 0 … 1
    Eigen::VectorXd weights{};  // 1/m²
    DriveVariance variance{};
};

void reweigh(RobustSolution& found, const DriveRows& rows, double (*weight)(double)) {
    const Eigen::VectorXd variance_m2 = found.variance.ofAll(rows);
    const Eigen::VectorXd sigmas =
        rows.residuals_m(found.solution).cwiseAbs().cwiseQuotient(variance_m2.cwiseSqrt());
    found.robust = sigmas.unaryExpr(weight);
    found.weights = found.robust.cwiseQuotient(variance_m2);
}

RobustSolution solveRobustly(const DriveRows& rows, double believed_wheelbase_m) {
    RobustSolution found;
    found.variance.wheelbase_m = roughWheelbase_m(rows, believed_wheelbase_m);
    found.solution = rows.solveBias(found.variance.ofAll(rows).cwiseInverse(),
                                    {found.variance.wheelbase_m, 0.0});
    for (int round = 0; round < kHuberRounds + kBiweightRounds; ++round) {
        found.variance.learn(rows, rows.residuals_m(found.solution));
        reweigh(found, rows, round < kHuberRounds ? &huberWeight : &biweight);
        found.solution = rows.solve(found.weights, found.variance.wheelbase_m);
        found.variance.wheelbase_m = std::abs(DriveRows::shapeOf(found.solution).wheelbase_m);
    }
    return found;
}

// Parts of the drive, one for each row, with equal shares of the way and of the turning.
std::vector<std::size_t> partsOf(const DriveRows& rows, std::size_t parts) {
    double way_m = 0.0;
    double turned_rad = 0.0;
    for (Eigen::Index row = 0; row < rows.count(); ++row) {
        way_m += rows.piece(row).rolled_m;
        turned_rad += std::abs(rows.piece(row).gyro_rad);
    }
    std::vector<std::size_t> part_of;
    part_of.reserve(static_cast<std::size_t>(rows.count()));
    double share = 0.0;
    for (Eigen::Index row = 0; row < rows.count(); ++row) {
        const auto part = static_cast<std::size_t>(share * static_cast<double>(parts));
        part_of.push_back(std::min(part, parts - 1));
        share += 0.5 * rows.piece(row).rolled_m / way_m +
                 0.5 * std::abs(rows.piece(row).gyro_rad) / turned_rad;
    }
    return part_of;
}

std::size_t countOfParts(const DriveRows& rows) {
    std::size_t turns = 0;
    std::size_t others = 0;
    for (Eigen::Index row = 0; row < rows.count(); ++row) {
        turns += rows.piece(row).kind == DriveKind::kTurn ? 1 : 0;
        others += rows.piece(row).kind == DriveKind::kStraight ? 1 : 0;
    }
    const std::size_t parts = std::min({turns, others, kMostDriveParts});
    return parts < kFewestDriveParts ? 0 : parts;
}

// The shape that the drive without that part gives. What the others weigh has to follow: with the
// weights as they are, standard errors would come out a sixth too small.
WheelShape shapeWithout(const DriveRows& rows, RobustSolution found,
                        std::span<const std::size_t> part_of, std::size_t part) {
    for (int round = 0; round < kRoundsWithout; ++round) {
        reweigh(found, rows, &biweight);
        for (Eigen::Index row = 0; row < rows.count(); ++row) {
            const bool wheels_moved = rows.piece(row).kind != DriveKind::kStand;
            if (wheels_moved && part_of[static_cast<std::size_t>(row)] == part)
                found.weights(row) = 0.0;
        }
        found.solution = rows.solve(found.weights, found.variance.wheelbase_m);
    }
    return DriveRows::shapeOf(found.solution);
}

// Of a jackknife: as many parts of equal weight tell as much of a value whose rows have that
// regressor, less one.
double freedomOf(const DriveRows& rows, const RobustSolution& found,
                 std::span<const std::size_t> part_of, std::size_t parts,
                 double DrivePiece::*regressor) {
    std::vector<double> information(parts, 0.0);
    double all = 0.0;
    for (Eigen::Index row = 0; row < rows.count(); ++row) {
        if (rows.piece(row).kind == DriveKind::kStand) continue;
        const double share = found.weights(row) * square(rows.piece(row).*regressor);
        information[part_of[static_cast<std::size_t>(row)]] += share;
        all += share;
    }
    double squares = 0.0;
    for (const double each : information) squares += square(each / all);
    return std::max(1.0, 1.0 / squares - 1.0);
}

// With a variance more, which is known (Welch and Satterthwaite).
Estimate widened(const Estimate& estimate, double variance) {
    const double was = square(estimate.standard_error);
    const double now = was + variance;
    return {estimate.value, std::sqrt(now), estimate.degrees_of_freedom * square(now / was)};
}

// The heading that wheels of that shape miss in one part: what adds up along the way, and what adds
// up over its turns whichever way they go.
double missedHeading_rad(const DriveRows& rows, const RobustSolution& found,
                         const WheelShape& shape, std::span<const std::size_t> part_of,
                         std::size_t part) {
    const Eigen::VectorXd residuals_m = rows.residuals_m(rows.solveBias(found.weights, shape));
    double along_m = 0.0;
    double in_turns_m = 0.0;
    for (Eigen::Index row = 0; row < rows.count(); ++row) {
        const DrivePiece& piece = rows.piece(row);
        if (part_of[static_cast<std::size_t>(row)] != part || piece.kind == DriveKind::kStand)
            continue;
        const double missed_m = found.robust(row) * residuals_m(row);
        along_m += missed_m;
        if (piece.kind == DriveKind::kTurn)
            in_turns_m += std::copysign(missed_m, missed_m * piece.gyro_rad);
    }
    return std::hypot(along_m, in_turns_m) / found.variance.wheelbase_m;
}

std::vector<double> asVector(const Eigen::VectorXd& values) {
    return {values.data(), values.data() + values.size()};
}

// What is believed, with what changes of the other one.
WheelShape changed(const DriveFit& fit, double believed_wheelbase_m, const WheelShape& other) {
    const bool none = !fit.wheelbase_changes && !fit.right_larger_changes;
    return {none || fit.wheelbase_changes ? other.wheelbase_m : believed_wheelbase_m,
            none || fit.right_larger_changes ? other.right_larger : 0.0};
}

void addParts(DriveFit& fit, const DriveRows& rows, const RobustSolution& found,
              const DriveFitOptions& options) {
    const auto part_of = partsOf(rows, fit.parts);
    std::vector<WheelShape> without;
    std::vector<double> wheelbases_m;
    std::vector<double> rights_larger;
    for (std::size_t part = 0; part < fit.parts; ++part) {
        without.push_back(shapeWithout(rows, found, part_of, part));
        wheelbases_m.push_back(without.back().wheelbase_m);
        rights_larger.push_back(without.back().right_larger);
    }
    const WheelShape shape = DriveRows::shapeOf(found.solution);
    const double believed_m = options.believed_wheelbase_m;
    const Eigen::Matrix2d from_bias =
        rows.unsureFromBias(found.weights, found.variance.wheelbase_m);
    fit.wheelbase_m = jackknifed(shape.wheelbase_m, wheelbases_m);
    fit.wheelbase_m.degrees_of_freedom =
        freedomOf(rows, found, part_of, fit.parts, &DrivePiece::gyro_rad);
    fit.wheelbase_m = widened(fit.wheelbase_m, from_bias(0, 0));
    fit.right_larger = jackknifed(shape.right_larger, rights_larger);
    fit.right_larger.degrees_of_freedom =
        freedomOf(rows, found, part_of, fit.parts, &DrivePiece::way_m);
    fit.right_larger = widened(fit.right_larger, from_bias(1, 1));
    fit.wheelbase_changes = fit.wheelbase_m.isNearerThan(believed_m, kSureShare,
                                                         options.unsure_share * shape.wheelbase_m);
    fit.gyro_scale_may_explain =
        !fit.wheelbase_changes && fit.wheelbase_m.isNearerThan(believed_m, kSureShare);
    fit.right_larger_changes = fit.right_larger.isNearerThan(0.0, kSureShare);
    for (std::size_t part = 0; part < fit.parts; ++part) {
        const WheelShape now = changed(fit, believed_m, without[part]);
        fit.held_out.push_back({missedHeading_rad(rows, found, {believed_m, 0.0}, part_of, part),
                                missedHeading_rad(rows, found, now, part_of, part)});
    }
}

}  // namespace

DriveFit fitDrive(std::span<const DriveLog> logs, const DriveFitOptions& options) {
    DriveFit fit;
    const DriveRows rows(logs);
    fit.parts = countOfParts(rows);
    if (fit.parts == 0) return fit;
    const RobustSolution found = solveRobustly(rows, options.believed_wheelbase_m);
    fit.slip_m_sqrtm = std::sqrt(found.variance.slip_m2_m);
    fit.turn_slip_share = std::sqrt(found.variance.turn_slip2);
    fit.turned_rad = asVector(rows.turned_rad(found.solution));
    fit.weights = asVector(found.robust);
    addParts(fit, rows, found, options);
    return fit;
}

}  // namespace hedr
