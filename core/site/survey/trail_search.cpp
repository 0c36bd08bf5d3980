#include "core/site/survey/trail_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <opencv2/core.hpp>

#include "core/geometry/angle.h"
#include "core/site/survey/driving_score.h"

namespace hedr {
namespace {

constexpr double kCell_m = 0.5;
constexpr double kMostCells = 4e5;
constexpr int kDirections = 12;  // over half a turn: a robot drives either way
constexpr int kRotations = 180;
constexpr std::size_t kMostSamples = 200;
constexpr int kBestOfRotation = 6;
constexpr int kApart = 4;            // cells between two of them
constexpr double kSoftness_m = 0.8;  // as a step is coarse
// Scores are whole numbers, of which 200 add up to less than 2^15.
constexpr double kUnit = 1.0 / 80.0;

// The driving score in the middle of each cell, in twelve directions, above that beside the plan:
// what lies beside it then adds nothing.
struct CoarseScores {
    double cell_m = kCell_m;
    cv::Size size{};
    std::array<cv::Mat, kDirections> scores{};
};

Point<PlanGround> middleOf(cv::Point cell, double cell_m) {
    return {(cell.x + 0.5) * cell_m, -(cell.y + 0.5) * cell_m};
}

CoarseScores coarseScores(const ClearanceMap& map) {
    CoarseScores coarse;
    const double area_m2 = map.width_m() * map.height_m();
    coarse.cell_m = std::max(kCell_m, std::sqrt(area_m2 / kMostCells));
    coarse.size = {static_cast<int>(std::ceil(map.width_m() / coarse.cell_m)),
                   static_cast<int>(std::ceil(map.height_m() / coarse.cell_m))};
    for (int k = 0; k < kDirections; ++k) {
        const double angle = k * kPi / kDirections;
        const Vector<PlanGround> direction{std::cos(angle), std::sin(angle)};
        cv::Mat& scores = coarse.scores[static_cast<std::size_t>(k)];
        scores.create(coarse.size, CV_16S);
        for (cv::Point at; at.y < scores.rows; ++at.y) {
            for (at.x = 0; at.x < scores.cols; ++at.x) {
                const double above =
                    drivingScore(map, middleOf(at, coarse.cell_m), direction, kSoftness_m) -
                    kScoreBesidePlan;
                scores.at<std::int16_t>(at) = static_cast<std::int16_t>(std::lround(above / kUnit));
            }
        }
    }
    return coarse;
}

// A sample of the turned trail, in cells from its middle.
struct CoarseSample {
    std::size_t direction = 0;
    cv::Point at{};
};

std::vector<CoarseSample> turned(const std::vector<TrailSample>& samples, double rotation_rad,
                                 double cell_m) {
    const auto turn = TrailPose{.rotation_rad = rotation_rad}.groundFromTrail();
    std::vector<CoarseSample> result;
    for (const TrailSample& sample : samples) {
        const Vector<PlanGround> way = turn * sample.direction;
        const Vector<PlanGround> place = turn * sample.from_middle;
        const auto bin =
            static_cast<int>(std::lround(std::atan2(way.y, way.x) * kDirections / kPi));
        result.push_back({static_cast<std::size_t>((bin + 2 * kDirections) % kDirections),
                          {static_cast<int>(std::lround(place.x / cell_m)),
                           static_cast<int>(std::lround(-place.y / cell_m))}});
    }
    return result;
}

// The cells where the trail's middle may be: the trail may leave the plan by an eighth of itself,
// as it has drifted and plans are cut.
cv::Rect placesOf(const std::vector<CoarseSample>& samples, cv::Size size) {
    cv::Point least = samples.front().at;
    cv::Point most = least;
    for (const CoarseSample& sample : samples) {
        least = {std::min(least.x, sample.at.x), std::min(least.y, sample.at.y)};
        most = {std::max(most.x, sample.at.x), std::max(most.y, sample.at.y)};
    }
    const cv::Point margin = (most - least) / 8 + cv::Point(2, 2);
    const cv::Point begin = -least - margin;
    const cv::Point end = cv::Point(size.width, size.height) - most + margin;
    return {begin.x, begin.y, std::max(0, end.x - begin.x), std::max(0, end.y - begin.y)};
}

// The trail's score with its middle in each cell of `places`.
cv::Mat sumOfScores(const CoarseScores& coarse, const std::vector<CoarseSample>& samples,
                    const cv::Rect& places) {
    cv::Mat sums(places.size(), CV_16S, cv::Scalar(0));
    const cv::Rect plan({0, 0}, coarse.size);
    for (const CoarseSample& sample : samples) {
        const cv::Rect there = (places + sample.at) & plan;
        if (there.empty()) continue;
        cv::Mat sum = sums(there - sample.at - places.tl());
        cv::add(sum, coarse.scores[sample.direction](there), sum);
    }
    return sums;
}

// Changes the sums.
void keepBest(cv::Mat& sums, const cv::Rect& places, TrailPose pose, double cell_m, double unit,
              std::vector<TrailPose>& found) {
    for (int i = 0; i < kBestOfRotation; ++i) {
        double sum = 0.0;
        cv::Point at;
        cv::minMaxLoc(sums, nullptr, &sum, nullptr, &at);
        if (sum <= 0.0) return;
        pose.middle = middleOf(at + places.tl(), cell_m);
        pose.score = sum * unit + kScoreBesidePlan;
        found.push_back(pose);
        const cv::Rect around(at.x - kApart, at.y - kApart, 2 * kApart + 1, 2 * kApart + 1);
        sums(around & cv::Rect({0, 0}, sums.size())).setTo(0);
    }
}

}  // namespace

Result<std::vector<TrailPose>> searchTrail(const ClearanceMap& map,
                                           const std::vector<TrailSample>& samples,
                                           const PlanProgress& progress) {
    const CoarseScores coarse = coarseScores(map);
    const std::vector<TrailSample> few = thinned(samples, kMostSamples);
    const double unit = kUnit / static_cast<double>(few.size());
    std::vector<TrailPose> found;
    for (int i = 0; i < kRotations; ++i) {
        if (progress && !progress(static_cast<double>(i) / kRotations)) {
            return fail(ErrorCode::kCanceled, "trail");
        }
        const TrailPose pose{.rotation_rad = i * 2.0 * kPi / kRotations};
        const auto trail = turned(few, pose.rotation_rad, coarse.cell_m);
        const cv::Rect places = placesOf(trail, coarse.size);
        if (places.empty()) continue;
        cv::Mat sums = sumOfScores(coarse, trail, places);
        keepBest(sums, places, pose, coarse.cell_m, unit, found);
    }
    sortByScore(found);
    return found;
}

}  // namespace hedr
