#include "core/calibration/squares/umbmark_evidence.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/calibration/short_number.h"
#include "core/calibration/squares/umbmark_text.h"
#include "core/geometry/angle.h"

namespace hedr {

namespace {

using Shape = EvidenceSeries::Shape;

constexpr int kSquaresEachWay = 5;      // as in the paper
constexpr double kWantedOfWay = 0.001;  // may stay unknown of an end, over the way of a square

// Where errors of a direction lie.
struct Cluster {
    double count = 0.0;
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
};

Cluster clusterOf(const UmbmarkCalibration& umbmark, Turning turning,
                  Vector<Robot> UmbmarkSquare::*error) {
    Cluster cluster;
    std::vector<Eigen::Vector2d> errors;
    for (const UmbmarkSquare& square : umbmark.squares) {
        if (square.turning != turning || square.far_off_m) continue;
        errors.emplace_back((square.*error).x, (square.*error).y);
        cluster.centre += errors.back();
    }
    cluster.count = static_cast<double>(errors.size());
    if (errors.empty()) return cluster;
    cluster.centre /= cluster.count;
    for (const Eigen::Vector2d& each : errors) {
        const Eigen::Vector2d off = each - cluster.centre;
        cluster.covariance += off * off.transpose() / std::max(1.0, cluster.count - 1.0);
    }
    return cluster;
}

EvidenceSeries dotsOf(const UmbmarkCalibration& umbmark, Turning turning, std::string name) {
    EvidenceSeries series{std::move(name),
                          turning == Turning::kClockwise ? Shape::kDots : Shape::kSquares};
    for (const UmbmarkSquare& square : umbmark.squares) {
        if (square.turning != turning) continue;
        series.x.push_back(square.before.x);
        series.y.push_back(square.before.y);
    }
    return series;
}

// Where the true centre lies at 95 %, by Hotelling's T squared; an F quantile with 2 degrees of
// freedom above has a closed form.
EvidenceSeries ellipseOf(const Cluster& cluster, std::string name) {
    constexpr int kPoints = 72;
    const double n = cluster.count;
    const double f = 0.5 * (n - 2.0) * (std::pow(1.0 - kUsualConfidence, -2.0 / (n - 2.0)) - 1.0);
    const double radius = std::sqrt(2.0 * (n - 1.0) / (n - 2.0) * f / n);
    const Eigen::Matrix2d axes = Eigen::LLT<Eigen::Matrix2d>(cluster.covariance).matrixL();
    EvidenceSeries series{std::move(name), Shape::kEllipse};
    for (int i = 0; i <= kPoints; ++i) {
        const double angle = 2.0 * kPi * i / kPoints;
        const Eigen::Vector2d point =
            cluster.centre + radius * axes * Eigen::Vector2d(std::cos(angle), std::sin(angle));
        series.x.push_back(point.x());
        series.y.push_back(point.y());
    }
    return series;
}

// One name for all that belongs to a direction.
void addCluster(EvidencePlot& plot, const UmbmarkCalibration& umbmark, Turning turning) {
    constexpr double kFewestForAnEllipse = 4.0;  // fewer tell next to nothing of their scatter
    const Cluster cluster = clusterOf(umbmark, turning, &UmbmarkSquare::before);
    const auto squares = std::ranges::count(umbmark.squares, turning, &UmbmarkSquare::turning);
    const std::string name = std::string(nameOf(turning)) + ", " + std::to_string(squares) +
                             (squares == 1 ? " run" : " runs");
    if (squares == 0) return;
    if (cluster.count >= kFewestForAnEllipse) plot.series.push_back(ellipseOf(cluster, name));
    plot.series.push_back(
        {name, Shape::kDashes, {0.0, cluster.centre.x()}, {0.0, cluster.centre.y()}});
    plot.series.push_back(dotsOf(umbmark, turning, name));
}

std::string ratiosText(double wheelbase, double diameter, bool named) {
    return (named ? "E_b ±" : "±") + shortNumber(wheelbase, 1) + (named ? ", E_d ±" : ", ±") +
           shortNumber(diameter, 1);
}

Estimate afterOneMore(const Estimate& now, double count) {
    return {now.value, now.standard_error * std::sqrt(count / (count + 1.0)),
            now.degrees_of_freedom + 1.0};
}

CalibrationProgress progressOf(const UmbmarkCalibration& umbmark, double wanted_m) {
    const Estimate& diameter = umbmark.ratios.diameter_ratio;
    const Estimate& wheelbase = umbmark.ratios.wheelbase_ratio;
    const double margin_m = std::hypot(umbmark.metres_per_ratio.x() * diameter.margin(),
                                       umbmark.metres_per_ratio.y() * wheelbase.margin());
    const double share = margin_m > wanted_m ? wanted_m / margin_m : 1.0;
    CalibrationProgress progress{.share = share * share};
    progress.known =
        "Known so far: " + ratiosText(wheelbase.margin(), diameter.margin(), true) + ".";
    if (progress.share < 1.0) {
        const double n = static_cast<double>(countOf(umbmark, Turning::kClockwise) +
                                             countOf(umbmark, Turning::kCounterClockwise));
        progress.more = "One more run gives " +
                        ratiosText(afterOneMore(wheelbase, n).margin(),
                                   afterOneMore(diameter, n).margin(), false) +
                        ".";
    }
    return progress;
}

// Of one coordinate of a held-out end.
double scatter_m(const UmbmarkCalibration& umbmark) {
    double trace = 0.0;
    for (const Turning turning : {Turning::kClockwise, Turning::kCounterClockwise}) {
        trace += clusterOf(umbmark, turning, &UmbmarkSquare::after).covariance.trace();
    }
    return std::sqrt(0.25 * trace);
}

std::vector<EvidenceFigure> figuresOf(const UmbmarkCalibration& umbmark) {
    const Estimate& diameter = umbmark.ratios.diameter_ratio;
    const Estimate& wheelbase = umbmark.ratios.wheelbase_ratio;
    std::vector<EvidenceFigure> figures{
        {"E_d, diameter right over left", diameter.value, "", diameter.interval()},
        {"E_b, wheelbase", wheelbase.value, "", wheelbase.interval()}};
    if (umbmark.closed_form) {
        figures.push_back({"E_d, closed form", umbmark.closed_form->diameter_ratio});
        figures.push_back({"E_b, closed form", umbmark.closed_form->wheelbase_ratio});
    }
    figures.insert(figures.end(), {{"E_max,syst before", umbmark.largest_before_m, "m"},
                                   {"E_max,syst after, held out", umbmark.largest_after_m, "m"},
                                   {"Scatter of one run", scatter_m(umbmark), "m"},
                                   {"Side of the squares", umbmark.side_m, "m"}});
    return figures;
}

// What the scatter of single runs leaves of a centre at 95 %.
double blurOfCentre_m(const UmbmarkCalibration& umbmark) {
    const double n = static_cast<double>(std::min(countOf(umbmark, Turning::kClockwise),
                                                  countOf(umbmark, Turning::kCounterClockwise)));
    constexpr double kRayleigh95 = 2.45;
    return kRayleigh95 * scatter_m(umbmark) / std::sqrt(n);
}

void addRemarks(UmbmarkCalibration& umbmark) {
    std::vector<std::string>& remarks = umbmark.calibration.remarks;
    const auto& closed_form = umbmark.closed_form;
    if (!closed_form) {
        remarks.emplace_back(
            "The closed form of the paper gives nothing for errors as large as these.");
    } else if (!umbmark.ratios.diameter_ratio.interval().contains(closed_form->diameter_ratio) ||
               !umbmark.ratios.wheelbase_ratio.interval().contains(closed_form->wheelbase_ratio)) {
        remarks.emplace_back(
            "The closed form of the paper is for small errors: where it says something else, least "
            "squares is right.");
    }
    if (umbmark.largest_after_m < blurOfCentre_m(umbmark)) {
        remarks.push_back("What is left, " + readLength(umbmark.largest_after_m) +
                          ", is no more than the scatter of the runs (floor, tape) explains.");
    }
    remarks.emplace_back(
        "Squares do not tell the distance scale: the mean of the diameters is as it was. Measure "
        "it on a straight line.");
}

CalibrationStep driveStep(const UmbmarkCalibration& umbmark, Turning turning,
                          const std::string& how) {
    const auto driven = std::ranges::count(umbmark.drives.runs, turning, &SquareRun::turning);
    const std::string so_far = driven > 0 && driven < kSquaresEachWay
                                   ? " " + std::to_string(driven) + " of " +
                                         std::to_string(kSquaresEachWay) + " are driven."
                                   : "";
    return {"Drive " + std::to_string(kSquaresEachWay) +
                (turning == Turning::kClockwise ? " squares " : " ") + std::string(nameOf(turning)),
            how + so_far, driven >= kSquaresEachWay};
}

}  // namespace

std::size_t countOf(const UmbmarkCalibration& umbmark, Turning turning) {
    return static_cast<std::size_t>(
        std::ranges::count_if(umbmark.squares, [turning](const UmbmarkSquare& square) {
            return square.turning == turning && !square.far_off_m;
        }));
}

double largestSystematicError_m(const UmbmarkCalibration& umbmark,
                                Vector<Robot> UmbmarkSquare::*error) {
    return std::max(clusterOf(umbmark, Turning::kClockwise, error).centre.norm(),
                    clusterOf(umbmark, Turning::kCounterClockwise, error).centre.norm());
}

void addUmbmarkSteps(UmbmarkCalibration& umbmark) {
    const std::size_t runs = umbmark.drives.runs.size();
    const bool begun = runs > 0 || umbmark.drives.unfinished;
    umbmark.calibration.steps = {
        {"Mark the start", "Tape the front and one side of the robot.", begun},
        driveStep(umbmark, Turning::kClockwise,
                  "4 m sides, stop and turn at the corners, stand still at the end. In turns with "
                  "those of the next step: only then a mark that was moved shows."),
        driveStep(umbmark, Turning::kCounterClockwise, "The same square the other way round."),
        {"Enter where it stopped",
         "Click on the map, or type x (along the first side) and y (to its left).",
         runs > 0 && umbmark.squares.size() == runs}};
}

void addUmbmarkPlot(UmbmarkCalibration& umbmark) {
    if (umbmark.squares.empty()) return;
    EvidencePlot plot{.title = "Where the squares ended (true minus computed)",
                      .x = {"Along the first side", "m"},
                      .y = {"To its left", "m"},
                      .same_scale = true};
    addCluster(plot, umbmark, Turning::kClockwise);
    addCluster(plot, umbmark, Turning::kCounterClockwise);
    umbmark.calibration.plots = {std::move(plot)};
}

void addUmbmarkFigures(UmbmarkCalibration& umbmark) {
    const double wanted_m = kWantedOfWay * 4.0 * umbmark.side_m;
    umbmark.calibration.progress = progressOf(umbmark, wanted_m);
    umbmark.calibration.figures = figuresOf(umbmark);
    addRemarks(umbmark);
}

}  // namespace hedr
