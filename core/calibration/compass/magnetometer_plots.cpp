#include "core/calibration/compass/magnetometer_plots.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/calibration/compass/compass_errors.h"
#include "core/geometry/angle.h"

namespace hedr {

namespace {

constexpr std::size_t kMostDots = 1500;
constexpr int kOutlineSteps = 120;

std::size_t dotStep(std::size_t count) { return 1 + count / kMostDots; }

EvidencePlot fieldPlot(const MagnetometerTurns& level, const MagnetometerRange& least_and_most) {
    EvidencePlot plot{"Field while it turned", {"x"}, {"y"}, true};
    EvidenceSeries readings{"Readings", EvidenceSeries::Shape::kDots};
    const auto& samples = level.turns.samples;
    for (std::size_t i = 0; i < samples.size(); i += dotStep(samples.size())) {
        readings.x.push_back(samples[i].field.x());
        readings.y.push_back(samples[i].field.y());
    }
    plot.series.push_back(std::move(readings));
    const std::pair<const char*, Ellipse> outlines[] = {
        {"Ellipse", level.fit->ellipse}, {"Least and most", ellipseFrom(least_and_most)}};
    for (const auto& [name, ellipse] : outlines) {
        EvidenceSeries outline{name, plot.series.size() == 1 ? EvidenceSeries::Shape::kLine
                                                             : EvidenceSeries::Shape::kDashes};
        for (int step = 0; step <= kOutlineSteps; ++step) {
            const Eigen::Vector2d at = ellipse.at(2.0 * kPi * step / kOutlineSteps);
            outline.x.push_back(at.x());
            outline.y.push_back(at.y());
        }
        plot.series.push_back(std::move(outline));
    }
    return plot;
}

EvidencePlot errorPlot(const MagnetometerTurns& level, const MagnetometerRange& believed) {
    const bool by_judge = level.turns.judge != HeadingJudge::kNone;
    EvidencePlot plot{by_judge ? "Magnetic heading less that of gyro or encoders"
                               : "Strength of the field over its mean, less one",
                      {"Magnetic heading", "rad"},
                      {by_judge ? "Difference" : "Unsteadiness", by_judge ? "rad" : ""}};
    const std::pair<const char*, MagnetometerRange> ranges[] = {{"Before", believed},
                                                                {"After", level.range}};
    for (const auto& [name, range] : ranges) {
        const Eigen::VectorXd errors = by_judge ? headingErrors_rad(level.turns, range, level.range)
                                                : strengthErrors(level.turns, range);
        EvidenceSeries series{name, EvidenceSeries::Shape::kDots};
        const auto count = static_cast<std::size_t>(errors.size());
        for (std::size_t i = 0; i < count; i += dotStep(count)) {
            const auto row = static_cast<Eigen::Index>(i);
            series.x.push_back(wrapAngle(level.fit->angle_rad(row)));
            series.y.push_back(errors(row));
        }
        plot.series.push_back(std::move(series));
    }
    return plot;
}

}  // namespace

std::vector<EvidencePlot> plotsOfTurns(const MagnetometerTurns& level,
                                       const MagnetometerRange& believed) {
    if (!level.fit) return {};
    const MagnetometerRange least_and_most = leastAndMost(level.turns.readings().field);
    return {fieldPlot(level, least_and_most), errorPlot(level, believed)};
}

std::vector<EvidencePlot> plotsOfSphere(const EllipsoidFit& sphere,
                                        const std::vector<Eigen::Vector3d>& field) {
    EvidencePlot plot{"Field while it was turned, from above", {"x"}, {"y"}, true};
    EvidenceSeries before{"As it is", EvidenceSeries::Shape::kDots};
    EvidenceSeries after{"Without iron", EvidenceSeries::Shape::kSquares};
    for (std::size_t i = 0; i < field.size(); i += dotStep(field.size())) {
        const Eigen::Vector3d without = sphere.ellipsoid.withoutIron(field[i]);
        before.x.push_back(field[i].x());
        before.y.push_back(field[i].y());
        after.x.push_back(without.x());
        after.y.push_back(without.y());
    }
    plot.series = {std::move(before), std::move(after)};
    return {plot};
}

}  // namespace hedr
