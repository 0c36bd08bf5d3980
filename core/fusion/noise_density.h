#pragma once

#include <algorithm>

namespace hedr {

// How noisy a rate is, from its sums over blocks: the density of white noise, in units squared per
// span. Second differences of the blocks' means take away a constant and a steady drift, so that an
// unknown bias does not count as noise.
class NoiseDensity {
  public:
    struct Config {
        double block_span = 1.0;
        double prior = 0.0;          // density
        double prior_weight = 1.0;   // counts like so many second differences
        double most_weight = 100.0;  // older ones fade
    };

    explicit NoiseDensity(const Config& config) : config_(config), density_(config.prior) {}

    // `sum`: integral of the rate over `span`.
    void add(double sum, double span) {
        sum_ += sum;
        span_ += span;
        if (span_ < config_.block_span) return;
        const double mean = sum_ / span_;
        const double difference = mean - 2.0 * last_ + before_last_;
        // The variance of a second difference is 1 + 4 + 1 times that of a mean.
        if (blocks_ >= 2) learn(difference * difference / 6.0 * span_);
        before_last_ = last_;
        last_ = mean;
        ++blocks_;
        sum_ = span_ = 0.0;
    }
    // What follows does not continue what was before.
    void interrupt() {
        blocks_ = 0;
        sum_ = span_ = 0.0;
    }
    double density() const { return density_; }

  private:
    void learn(double density) {
        weight_ = std::min(weight_ + 1.0, config_.most_weight);
        density_ += (density - density_) / (config_.prior_weight + weight_);
    }

    Config config_;
    double density_;
    double weight_ = 0.0;
    double sum_ = 0.0;
    double span_ = 0.0;
    double last_ = 0.0;
    double before_last_ = 0.0;
    int blocks_ = 0;
};

}  // namespace hedr
