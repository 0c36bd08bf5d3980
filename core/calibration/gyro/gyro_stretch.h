#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/calibration/gyro_samples.h"

namespace hedr {

// Takes out readings that stand alone, far from those before and after: broken ones, as no robot
// turns for one reading only. The place of such a reading is kept, with the one before in it.
// Learns what is usual from the readings; the first ones pass when there are enough to tell, all
// others when the next one has come.
class LoneReadingFilter {
  public:
    std::vector<GyroSample> add(const GyroSample& sample);

  private:
    std::vector<GyroSample> judged(std::span<const GyroSample> samples);
    void learnFromEarly();
    bool isLone(double rate_rad_s) const;
    void learn(double rate_rad_s);

    std::vector<GyroSample> early_{};
    std::optional<GyroSample> held_{};
    double before_rad_s_ = 0.0;
    double count_ = 0.0;
    double usual_rad_s_ = 0.0;
    double variance_ = 0.0;
};

// A gyro's readings over one stretch of time, in blocks of about 50 ms. Holds the last minutes.
class GyroStretch {
  public:
    void add(const GyroSample& sample);
    void clear() { *this = GyroStretch(); }
    void dropUntil(double t_s);  // blocks that begin before it

    std::size_t blocks() const { return edges_.empty() ? 0 : edges_.size() - 1; }
    double edge_s(std::size_t index) const { return edges_[index].t_s; }  // 0 … blocks()
    double begin_s() const { return edges_.front().t_s; }
    double end_s() const { return edges_.back().t_s; }
    // Of the blocks first … last - 1.
    double span_s(std::size_t first, std::size_t last) const;
    double turn_rad(std::size_t first, std::size_t last) const;
    double mean_rad_s(std::size_t first, std::size_t last) const;
    double readings(std::size_t first, std::size_t last) const;
    double variance(std::size_t first, std::size_t last) const;  // of single readings
    double duration_s() const { return edges_.empty() ? 0.0 : span_s(0, blocks()); }
    // The other end of the fewest blocks that span so long; none where the stretch is too short.
    std::optional<std::size_t> spanningFrom(std::size_t first, double span_s) const;
    std::optional<std::size_t> spanningUpTo(std::size_t last, double span_s) const;
    std::size_t firstEdgeAfter(double t_s) const;  // blocks() + 1: none

    // Noise density as means over that time show it, in the last minute: from successive
    // differences, so that no bias or slow drift counts, the largest left out, so that no short
    // motion does.
    static constexpr double kNoiseFrom_s = 60.0;
    double noise_rad_s_sqrthz(double mean_over_s, double within_s = kNoiseFrom_s) const;
    // The step of the readings, where they scatter too little for a mean to smooth it; else 0.
    double coarseStep_rad_s() const;
    double smallestStep_rad_s() const { return smallest_step_rad_s_; }

  private:
    struct Edge {  // sums up to here
        double t_s = 0.0;
        double span_s = 0.0;
        double turn_rad = 0.0;
        double count = 0.0;
        double sum = 0.0;
        double squares = 0.0;
    };
    void learnStep(double rate_rad_s);

    std::vector<Edge> edges_{};
    Edge open_{};
    double origin_rad_s_ = 0.0;  // subtracted in sum and squares, for their precision
    double last_rad_s_ = 0.0;
    double smallest_step_rad_s_ = 0.0;
};

}  // namespace hedr
