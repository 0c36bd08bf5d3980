#include "core/calibration/gyro/motion_sign.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/calibration/distributions.h"
#include "core/calibration/median.h"
#include "core/calibration/short_number.h"
#include "core/geometry/angle.h"

namespace hedr {

namespace {

// Chance that one look at standing data is taken for a turn, one way: some thousand looks that
// overlap make a measurement.
constexpr double kTurnChance = 3e-7;
constexpr std::array kTurnSpans_s{0.05, 0.1, 0.15, 0.2, 0.3, 0.45, 0.7, 1.0, 1.5, 2.5, 4.0, 6.0};
constexpr double kLongSpan_s = 1.5;  // from here on noise that is not white may show
constexpr double kAround_s = 20.0;   // the bias wanders little in that time
constexpr double kWander_rad_s = radFromDeg(0.01);
constexpr double kSlowTurn_s = 1.5;  // so long and slow: called a slow turn
constexpr double kSlowTurn_rad_s = radFromDeg(0.15);
constexpr double kTurnNoiseFrom_s = 30.0;
constexpr double kDegreesPerBlock = 0.5;  // of freedom, in the trimmed noise

constexpr std::array kVibrationSpans_s{1.0, 4.0};
constexpr double kVibrationSigmas = 5.5;
constexpr double kNoiseWanders = 0.05;     // of the cube root of the variance
constexpr std::size_t kFewestUsual = 8;    // windows to know what is usual
constexpr std::size_t kFewestSpread = 20;  // and how much that scatters
constexpr double kFewestReadings = 5.0;
constexpr double kUsualFrom_s = 60.0;

constexpr double kSlowFrom_s = 120.0;
constexpr double kSlowSide_s = 10.0;  // before and after: faster ones are found as turns
constexpr std::array kSlowNoiseOver_s{0.5, 4.0};
constexpr double kSlowSigmas = 5.8;
constexpr double kSlowWander_rad_s = radFromDeg(0.003);   // steps of the bias itself
constexpr double kSlowDrift_rad_s2 = radFromDeg(0.0001);  // a warm gyro's; four times: warming up
constexpr double kOnsetStep_s = 1.0;

double squareOf(double value) { return value * value; }

// The mean rate of some blocks less that of the seconds around them.
struct Contrast {
    double rate_rad_s = 0.0;
    double per_noise_density = 0.0;  // standard deviation for white noise of density 1
};

std::optional<Contrast> contrastOf(const GyroStretch& stretch, std::size_t first,
                                   std::size_t last) {
    const double span_s = stretch.span_s(first, last);
    const std::size_t from = stretch.spanningUpTo(first, kAround_s).value_or(0);
    const std::size_t until =
        stretch.spanningFrom(from, kAround_s + span_s).value_or(stretch.blocks());
    const double around_s = stretch.span_s(from, until) - span_s;
    if (around_s < span_s) return std::nullopt;
    const double around_rad = stretch.turn_rad(from, until) - stretch.turn_rad(first, last);
    return Contrast{stretch.mean_rad_s(first, last) - around_rad / around_s,
                    std::sqrt(1.0 / span_s + 1.0 / around_s)};
}

// How much readings scatter: the cube root of their variance, which is nearly normal (Wilson and
// Hilferty 1931). The square of their step is added, as a lone flip to the next value is no
// vibration.
double readingScatter(const GyroStretch& stretch, std::size_t first, std::size_t last) {
    const double degrees = stretch.readings(first, last) - 1.0;
    const double step_rad_s = stretch.smallestStep_rad_s();
    return std::cbrt(stretch.variance(first, last) + step_rad_s * step_rad_s) /
           (1.0 - 2.0 / (9.0 * degrees));
}

struct UsualScatter {
    double median = 0.0;
    double relative_deviation = 0.0;  // of one second
};

std::vector<double> scattersOfSeconds(const GyroStretch& stretch) {
    std::vector<double> scatters;
    std::size_t first = stretch.spanningUpTo(stretch.blocks(), kUsualFrom_s).value_or(0);
    while (const auto last = stretch.spanningFrom(first, kVibrationSpans_s[0])) {
        if (stretch.readings(first, *last) >= kFewestReadings) {
            scatters.push_back(readingScatter(stretch, first, *last));
        }
        first = *last;
    }
    return scatters;
}

std::optional<UsualScatter> usualScatterIn(const GyroStretch& stretch) {
    std::vector<double> scatters = scattersOfSeconds(stretch);
    if (scatters.size() < kFewestUsual) return std::nullopt;
    UsualScatter usual{.median = medianOf(scatters)};
    if (usual.median <= 0.0) return std::nullopt;
    if (scatters.size() < kFewestSpread) return usual;
    constexpr double kDeviationPerMedianChange = 1.4826;
    for (double& scatter : scatters) scatter = std::abs(scatter / usual.median - 1.0);
    usual.relative_deviation = kDeviationPerMedianChange * medianOf(scatters);
    return usual;
}

// How far the scatter is from what is usual; above 1: too far.
double scatterStrength(double scatter, double readings, double span_s, const UsualScatter& usual) {
    const double as_white_noise = std::sqrt(2.0 / (9.0 * (readings - 1.0)));
    const double as_seen = usual.relative_deviation * std::sqrt(kVibrationSpans_s[0] / span_s);
    return std::abs(scatter / usual.median - 1.0) /
           (kNoiseWanders + kVibrationSigmas * std::max(as_white_noise, as_seen));
}

// The place of a step in the rate, in the time that a stretch covers.
struct StepFit {
    double rate_rad_s = 0.0;
    double deviation_rad_s = 0.0;
};

// What the best step is searched in: bias, drift and noise of the stretch from `first` on. The
// drift has a normal prior; the sums are those of generalised least squares with it.
class StepSearch {
  public:
    StepSearch(const GyroStretch& stretch, std::size_t first, double noise_density)
        : stretch_(stretch), first_(first), noise_(squareOf(noise_density)) {
        span_s_ = stretch.span_s(first, stretch.blocks());
        for (std::size_t i = first; i < stretch.blocks(); ++i) {
            const double middle_s =
                0.5 * (stretch.span_s(first, i) + stretch.span_s(first, i + 1)) - 0.5 * span_s_;
            drift_sum_ += middle_s * stretch.turn_rad(i, i + 1);
        }
        const double drift = squareOf(kSlowDrift_rad_s2);
        keep_ = drift / (noise_ + drift * span_s_ * span_s_ * span_s_ / 12.0);
    }

    StepFit stepAt(std::size_t onset) const {
        const double after_s = stretch_.span_s(onset, stretch_.blocks());
        const double before_s = span_s_ - after_s;
        const double step_step = after_s * before_s / span_s_;
        const double step_drift = 0.5 * after_s * before_s;
        const double step_sum = stretch_.turn_rad(onset, stretch_.blocks()) -
                                after_s / span_s_ * stretch_.turn_rad(first_, stretch_.blocks());
        const double information = step_step - keep_ * squareOf(step_drift);
        return {(step_sum - keep_ * step_drift * drift_sum_) / information,
                std::sqrt(noise_ / information + squareOf(kSlowWander_rad_s) +
                          squareOf(stretch_.coarseStep_rad_s()))};
    }

  private:
    const GyroStretch& stretch_;
    std::size_t first_;
    double noise_;
    double span_s_ = 0.0;
    double drift_sum_ = 0.0;
    double keep_ = 0.0;
};

// A turn: means over 50 ms to 6 s against the mean of the seconds around them.
MotionSign strongestTurn(const GyroStretch& stretch, double from_s) {
    const double quick_noise = stretch.noise_rad_s_sqrthz(kTurnSpans_s[0], kTurnNoiseFrom_s);
    const double noise_of_long = std::max(quick_noise, stretch.noise_rad_s_sqrthz(kLongSpan_s));
    const double allowed_rad_s = kWander_rad_s + stretch.coarseStep_rad_s();
    const double degrees = std::max(
        2.0, kDegreesPerBlock * std::min(stretch.duration_s(), kTurnNoiseFrom_s) / kTurnSpans_s[0]);
    const double sigmas = studentQuantile(1.0 - kTurnChance, degrees);
    MotionSign sign{.kind = MotionSign::Kind::kTurned};
    for (std::size_t last = stretch.firstEdgeAfter(from_s); last <= stretch.blocks(); ++last) {
        for (const double span_s : kTurnSpans_s) {
            const auto first = stretch.spanningUpTo(last, span_s);
            const auto contrast = first ? contrastOf(stretch, *first, last) : std::nullopt;
            if (!contrast) break;
            const double noise = span_s < kLongSpan_s ? quick_noise : noise_of_long;
            const double strength = std::abs(contrast->rate_rad_s) /
                                    (allowed_rad_s + sigmas * noise * contrast->per_noise_density);
            if (strength <= sign.strength) continue;
            sign.strength = strength;
            sign.since_s = stretch.edge_s(*first);
            sign.until_s = stretch.edge_s(last);
            sign.turn_rad = contrast->rate_rad_s * stretch.span_s(*first, last);
        }
    }
    if (sign.until_s - sign.since_s >= kSlowTurn_s) {
        sign.rate_rad_s = sign.turn_rad / (sign.until_s - sign.since_s);
        if (std::abs(sign.rate_rad_s) < kSlowTurn_rad_s) sign.kind = MotionSign::Kind::kTurnsSlowly;
    }
    return sign;
}

// A vibration, or its end: scatter over 1 s and 4 s against its median.
MotionSign strongestVibration(const GyroStretch& stretch, double from_s) {
    const auto usual = usualScatterIn(stretch);
    if (!usual) return {};
    MotionSign sign{.kind = MotionSign::Kind::kVibrates};
    for (std::size_t last = stretch.firstEdgeAfter(from_s); last <= stretch.blocks(); ++last) {
        for (const double span_s : kVibrationSpans_s) {
            const auto first = stretch.spanningUpTo(last, span_s);
            if (!first || stretch.readings(*first, last) < kFewestReadings) break;
            const double scatter = readingScatter(stretch, *first, last);
            const double strength =
                scatterStrength(scatter, stretch.readings(*first, last), span_s, *usual);
            if (strength <= sign.strength) continue;
            sign.strength = strength;
            sign.since_s = stretch.edge_s(*first);
            sign.until_s = stretch.edge_s(last);
            sign.noise_ratio = std::pow(scatter / usual->median, 1.5);
        }
    }
    return sign;
}

// A slow turn that goes on: the step of the rate, at whatever time within the last two minutes,
// that explains the readings better than white noise, a bias and a slow drift of it do.
MotionSign strongestSlowTurn(const GyroStretch& stretch) {
    const std::size_t first = stretch.spanningUpTo(stretch.blocks(), kSlowFrom_s).value_or(0);
    const auto last_onset = stretch.spanningUpTo(stretch.blocks(), kSlowSide_s);
    if (!last_onset) return {};
    const double noise = std::max(stretch.noise_rad_s_sqrthz(kSlowNoiseOver_s[0]),
                                  stretch.noise_rad_s_sqrthz(kSlowNoiseOver_s[1]));
    const StepSearch search(stretch, first, noise);
    MotionSign sign{.kind = MotionSign::Kind::kTurnsSlowly, .until_s = stretch.end_s()};
    auto onset = stretch.spanningFrom(first, kSlowSide_s);
    for (; onset && *onset <= *last_onset; onset = stretch.spanningFrom(*onset, kOnsetStep_s)) {
        const StepFit step = search.stepAt(*onset);
        const double strength = std::abs(step.rate_rad_s) / (kSlowSigmas * step.deviation_rad_s);
        if (strength <= sign.strength) continue;
        sign.strength = strength;
        sign.since_s = stretch.edge_s(*onset);
        sign.rate_rad_s = step.rate_rad_s;
    }
    return sign;
}

}  // namespace

std::string sentenceOf(const MotionSign& sign) {
    switch (sign.kind) {
        case MotionSign::Kind::kCounted:
            return "The encoders counted.";
        case MotionSign::Kind::kTurned:
            return "The robot turned by about " +
                   shortNumber(degFromRad(std::abs(sign.turn_rad)), 1) + "° within " +
                   shortNumber(sign.until_s - sign.since_s, 1) + " s.";
        case MotionSign::Kind::kTurnsSlowly:
            return "The robot turns slowly, by about " +
                   shortNumber(degFromRad(std::abs(sign.rate_rad_s)), 1) +
                   " °/s, or its gyro is warming up.";
        case MotionSign::Kind::kVibrates:
            return sign.noise_ratio > 1.0
                       ? "It vibrates: the gyro is " + shortNumber(sign.noise_ratio) +
                             " times as noisy as before."
                       : "It vibrated until now.";
        case MotionSign::Kind::kUnwatched:
            break;
    }
    return "No gyro readings came for " + shortNumber(sign.until_s - sign.since_s) + " s.";
}

MotionSign strongestHintIn(const GyroStretch& stretch, double from_s) {
    MotionSign strongest;
    for (const MotionSign& hint :
         {strongestTurn(stretch, from_s), strongestVibration(stretch, from_s),
          strongestSlowTurn(stretch)}) {
        if (hint.strength > strongest.strength) strongest = hint;
    }
    return strongest;
}

}  // namespace hedr
