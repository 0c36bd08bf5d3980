#include "core/calibration/gyro/gyro_stretch.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/calibration/median.h"

namespace hedr {

namespace {

constexpr double kLoneSigmas = 4.5;
constexpr double kNeighbourSigmas = 3.5;  // a nudge of 0.3 s shows in neighbours, even at 10 Hz
constexpr double kLearnReadings = 200.0;
constexpr std::size_t kEarlyReadings = 20;
constexpr double kVariancePerMedianSquare = 2.198;  // of changes from the median
constexpr double kCutVariances = 9.0;               // one reading must not teach more

constexpr double kBlock_s = 0.05;      // shorter than any nudge
constexpr double kJitterShare = 0.02;  // of a block, lost in rounded time stamps
constexpr double kLongestHeld_s = 240.0;
// The mean of the smallest nine tenths of squared normal numbers of variance 1.
constexpr double kTrimmedShare = 0.9;
constexpr double kTrimmedMean = 0.6230;
// Noise of half a step smooths the steps; rounding adds a twelfth of a step's square to its own.
constexpr double kSmoothingSquares = 1.0 / 4.0 + 1.0 / 12.0;

double trimmedVariance(std::vector<double> squares) {
    if (squares.empty()) return 0.0;
    const auto kept = std::max<std::size_t>(
        1, static_cast<std::size_t>(kTrimmedShare * static_cast<double>(squares.size())));
    const auto end = squares.begin() + static_cast<std::ptrdiff_t>(kept);
    std::nth_element(squares.begin(), end - 1, squares.end());
    double sum = 0.0;
    for (auto it = squares.begin(); it != end; ++it) sum += *it;
    return sum / static_cast<double>(kept) / kTrimmedMean;
}

}  // namespace

std::vector<GyroSample> LoneReadingFilter::add(const GyroSample& sample) {
    if (early_.size() == kEarlyReadings) return judged(std::span(&sample, 1));
    early_.push_back(sample);
    if (early_.size() < kEarlyReadings) return {};
    learnFromEarly();
    return judged(early_);
}

std::vector<GyroSample> LoneReadingFilter::judged(std::span<const GyroSample> samples) {
    std::vector<GyroSample> passed;
    passed.reserve(samples.size());
    for (const GyroSample& sample : samples) {
        const std::optional<GyroSample> before = std::exchange(held_, sample);
        if (!before) continue;
        passed.push_back(*before);
        if (isLone(before->rate_rad_s)) passed.back().rate_rad_s = before_rad_s_;
        learn(before->rate_rad_s);
        before_rad_s_ = before->rate_rad_s;
    }
    return passed;
}

void LoneReadingFilter::learnFromEarly() {
    std::vector<double> values;
    values.reserve(early_.size());
    for (const GyroSample& sample : early_) values.push_back(sample.rate_rad_s);
    usual_rad_s_ = before_rad_s_ = medianOf(values);
    for (double& value : values) value = std::abs(value - usual_rad_s_);
    const double change_rad_s = medianOf(std::move(values));
    variance_ = kVariancePerMedianSquare * change_rad_s * change_rad_s;
    count_ = static_cast<double>(kEarlyReadings);
}

bool LoneReadingFilter::isLone(double rate_rad_s) const {
    const auto away = [this](double reading, double sigmas) {
        const double difference = reading - usual_rad_s_;
        return difference * difference > sigmas * sigmas * variance_;
    };
    return variance_ > 0.0 && away(rate_rad_s, kLoneSigmas) &&
           !away(before_rad_s_, kNeighbourSigmas) && !away(held_->rate_rad_s, kNeighbourSigmas);
}

void LoneReadingFilter::learn(double rate_rad_s) {
    count_ = std::min(count_ + 1.0, kLearnReadings);
    const double difference = rate_rad_s - usual_rad_s_;
    double square = difference * difference;
    if (variance_ > 0.0) square = std::min(square, kCutVariances * variance_);
    usual_rad_s_ += std::copysign(std::sqrt(square), difference) / count_;
    variance_ += (square - variance_) / count_;
}

void GyroStretch::add(const GyroSample& sample) {
    const double rate_rad_s = sample.rate_rad_s;
    if (edges_.empty()) {
        origin_rad_s_ = last_rad_s_ = rate_rad_s;
        open_.t_s = sample.t_s - sample.dt_s;
        edges_.push_back(open_);
    }
    learnStep(rate_rad_s);
    open_.t_s = sample.t_s;
    open_.span_s += sample.dt_s;
    open_.turn_rad += rate_rad_s * sample.dt_s;
    open_.count += 1.0;
    const double difference = rate_rad_s - origin_rad_s_;
    open_.sum += difference;
    open_.squares += difference * difference;
    if (open_.span_s - edges_.back().span_s < (1.0 - kJitterShare) * kBlock_s) return;
    edges_.push_back(open_);
    // In large pieces, as each moves all the others.
    if (duration_s() > 1.5 * kLongestHeld_s) dropUntil(end_s() - kLongestHeld_s);
}

void GyroStretch::learnStep(double rate_rad_s) {
    const double step_rad_s = std::abs(rate_rad_s - last_rad_s_);
    if (step_rad_s > 0.0 && (smallest_step_rad_s_ == 0.0 || step_rad_s < smallest_step_rad_s_)) {
        smallest_step_rad_s_ = step_rad_s;
    }
    last_rad_s_ = rate_rad_s;
}

void GyroStretch::dropUntil(double t_s) {
    const auto keep = std::find_if(edges_.begin(), edges_.end(),
                                   [t_s](const Edge& edge) { return edge.t_s >= t_s; });
    if (keep == edges_.end()) return clear();
    edges_.erase(edges_.begin(), keep);
}

double GyroStretch::span_s(std::size_t first, std::size_t last) const {
    return edges_[last].span_s - edges_[first].span_s;
}

double GyroStretch::turn_rad(std::size_t first, std::size_t last) const {
    return edges_[last].turn_rad - edges_[first].turn_rad;
}

double GyroStretch::mean_rad_s(std::size_t first, std::size_t last) const {
    return turn_rad(first, last) / span_s(first, last);
}

double GyroStretch::readings(std::size_t first, std::size_t last) const {
    return edges_[last].count - edges_[first].count;
}

double GyroStretch::variance(std::size_t first, std::size_t last) const {
    const double count = readings(first, last);
    const double sum = edges_[last].sum - edges_[first].sum;
    const double squares = edges_[last].squares - edges_[first].squares;
    return std::max(0.0, squares - sum * sum / count) / std::max(1.0, count - 1.0);
}

std::optional<std::size_t> GyroStretch::spanningFrom(std::size_t first, double span_s) const {
    const double until_s = edges_[first].span_s + (1.0 - kJitterShare) * span_s;
    const auto edge =
        std::lower_bound(edges_.begin(), edges_.end(), until_s,
                         [](const Edge& each, double value) { return each.span_s < value; });
    if (edge == edges_.end()) return std::nullopt;
    return static_cast<std::size_t>(edge - edges_.begin());
}

std::optional<std::size_t> GyroStretch::spanningUpTo(std::size_t last, double span_s) const {
    const double from_s = edges_[last].span_s - (1.0 - kJitterShare) * span_s;
    const auto edge =
        std::upper_bound(edges_.begin(), edges_.end(), from_s,
                         [](double value, const Edge& each) { return value < each.span_s; });
    if (edge == edges_.begin()) return std::nullopt;
    return static_cast<std::size_t>(edge - edges_.begin()) - 1;
}

std::size_t GyroStretch::firstEdgeAfter(double t_s) const {
    const auto edge =
        std::upper_bound(edges_.begin(), edges_.end(), t_s,
                         [](double value, const Edge& each) { return value < each.t_s; });
    return static_cast<std::size_t>(edge - edges_.begin());
}

double GyroStretch::noise_rad_s_sqrthz(double mean_over_s, double within_s) const {
    const double block_s = duration_s() / static_cast<double>(blocks());
    const auto count = static_cast<std::size_t>(std::max(1.0, std::round(mean_over_s / block_s)));
    std::vector<double> squares;
    std::size_t first = spanningUpTo(blocks(), within_s).value_or(0);
    for (; first + 2 * count <= blocks(); first += count) {
        const std::size_t middle = first + count;
        const std::size_t last = middle + count;
        const double difference = mean_rad_s(middle, last) - mean_rad_s(first, middle);
        squares.push_back(difference * difference /
                          (1.0 / span_s(first, middle) + 1.0 / span_s(middle, last)));
    }
    return std::sqrt(trimmedVariance(std::move(squares)));
}

double GyroStretch::coarseStep_rad_s() const {
    const double square = smallest_step_rad_s_ * smallest_step_rad_s_;
    return variance(0, blocks()) < kSmoothingSquares * square ? smallest_step_rad_s_ : 0.0;
}

}  // namespace hedr
