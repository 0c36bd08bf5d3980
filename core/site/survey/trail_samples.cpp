#include "core/site/survey/trail_samples.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/geometry/angle.h"

namespace hedr {
namespace {

constexpr double kSpacing_m = 0.25;
constexpr double kAgain_m = 0.2;  // less than the spacing, so that neighbours stay
constexpr double kLongest_m = 400.0;
constexpr double kShortest_m = 20.0;
constexpr double kFarthest_m = 1e6;  // from the origin
constexpr std::size_t kReach = 3;    // samples before and after that tell the direction
const double kTurn = std::sin(radFromDeg(30.0));

double cross(Vector<World> a, Vector<World> b) { return a.x * b.y - a.y * b.x; }

bool isSane(Point<World> p) {
    return std::abs(p.x) < kFarthest_m && std::abs(p.y) < kFarthest_m;  // not if NaN
}

// From the newest back.
std::vector<Point<World>> evenlySpaced(std::span<const Point<World>> trail) {
    const auto most = static_cast<std::size_t>(kLongest_m / kSpacing_m) + 1;
    std::vector<Point<World>> places{trail.back()};
    for (auto p = trail.rbegin(); p != trail.rend() && places.size() < most; ++p) {
        Vector<World> way = *p - places.back();
        while (way.length() >= kSpacing_m && places.size() < most) {
            places.push_back(places.back() + (kSpacing_m / way.length()) * way);
            way = *p - places.back();
        }
    }
    return places;
}

bool isAgain(const TrailSample& sample, const TrailSample& other) {
    return (sample.from_middle - other.from_middle).length() < kAgain_m &&
           std::abs(cross(sample.direction, other.direction)) < kTurn;
}

// About the origin of the world.
std::vector<TrailSample> samplesOf(const std::vector<Point<World>>& places) {
    std::vector<TrailSample> samples;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Vector<World> way =
            places[std::min(i + kReach, places.size() - 1)] - places[std::max(i, kReach) - kReach];
        if (way.length() < kSpacing_m) continue;  // he turned about
        const TrailSample sample{places[i] - Point<World>{}, (1.0 / way.length()) * way};
        const auto again = [&](const TrailSample& other) { return isAgain(sample, other); };
        if (std::ranges::none_of(samples, again)) samples.push_back(sample);
    }
    return samples;
}

bool hasTurn(const std::vector<TrailSample>& samples) {
    const auto turns = [&](const TrailSample& sample) {
        return std::abs(cross(sample.direction, samples.front().direction)) > kTurn;
    };
    return std::ranges::any_of(samples, turns);
}

std::string lengthProblem(std::size_t places) {
    const auto length_m = kSpacing_m * static_cast<double>(places - 1);
    return "it is " + std::to_string(std::lround(length_m)) + " m long, must be at least " +
           std::to_string(std::lround(kShortest_m)) + " m";
}

}  // namespace

Result<TrailSamples> sampleTrail(std::span<const Point<World>> trail) {
    constexpr const char* kSubject = "trail";
    if (!std::ranges::all_of(trail, isSane)) {
        return fail(ErrorCode::kBadValue, kSubject, "a position of it is not a number");
    }
    if (trail.empty()) return fail(ErrorCode::kNoData, kSubject, "it is empty");
    const std::vector<Point<World>> places = evenlySpaced(trail);
    if (kSpacing_m * static_cast<double>(places.size() - 1) < kShortest_m) {
        return fail(ErrorCode::kNoData, kSubject, lengthProblem(places.size()));
    }
    TrailSamples result{.samples = samplesOf(places)};
    if (result.samples.empty() || !hasTurn(result.samples)) {
        return fail(ErrorCode::kNoData, kSubject, "it has no turn yet, so that it fits anywhere");
    }
    Vector<World> sum{};
    for (const TrailSample& sample : result.samples) sum = sum + sample.from_middle;
    const Vector<World> middle = (1.0 / static_cast<double>(result.samples.size())) * sum;
    for (TrailSample& sample : result.samples) sample.from_middle = sample.from_middle - middle;
    result.middle = Point<World>{} + middle;
    return result;
}

std::vector<TrailSample> thinned(const std::vector<TrailSample>& samples, std::size_t most) {
    const std::size_t step = (samples.size() + most - 1) / most;
    std::vector<TrailSample> kept;
    for (std::size_t i = step / 2; i < samples.size(); i += step) kept.push_back(samples[i]);
    return kept;
}

}  // namespace hedr
