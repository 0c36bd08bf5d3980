#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/geometry/frames.h"

namespace hedr {

// How uncertain a pose is, in single precision because a track has millions of them.
struct PoseVariance {
    float var_x_m2 = -1.0F;  // negative: the method does not say
    float cov_xy_m2 = 0.0F;
    float var_y_m2 = -1.0F;
    float var_heading_rad2 = -1.0F;
    bool known() const { return var_x_m2 >= 0.0F; }
    friend bool operator==(const PoseVariance&, const PoseVariance&) = default;
};

struct TrackPoint {
    double t_s = 0.0;
    Pose<World> pose{};
    double gyro_bias_rad_s = 0.0;
    PoseVariance variance{};
    friend bool operator==(const TrackPoint&, const TrackPoint&) = default;
};

struct WorldBox {
    Point<World> min{};
    Point<World> max{};
};

// All poses of one run by one estimator, never cut, with levels of detail for drawing. Append-only:
// full chunks are immutable and shared, so a copy (a snapshot for another thread) costs O(chunks).
class Track {
  public:
    // Called with at most kRunPoints points: long polylines are slow to paint.
    using DrawRun = std::function<void(std::span<const Point<World>>)>;
    static constexpr std::size_t kRunPoints = 256;

    Track();
    void append(const TrackPoint& point);
    std::size_t size() const;
    bool empty() const { return size() == 0; }
    TrackPoint at(std::size_t index) const;
    TrackPoint back() const { return at(size() - 1); }
    WorldBox bounds() const { return bounds_; }  // of a track that is not empty
    std::size_t memoryBytes() const;

    // Calls `draw` with runs of points (each run begins where the last one ended unless a part
    // outside `area` was skipped) that lie within `tolerance_m` of the exact trail, and the trail
    // within `tolerance_m` of them.
    void simplified(const WorldBox& area, double tolerance_m, const DrawRun& draw) const;

  private:
    struct Chunk;
    std::vector<std::shared_ptr<const Chunk>> full_;
    std::vector<TrackPoint> tail_;
    WorldBox bounds_{};
};

}  // namespace hedr
