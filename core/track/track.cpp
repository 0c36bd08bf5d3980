#include "core/track/track.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <optional>

#include "core/track/detail_levels.h"

namespace hedr {
namespace {

constexpr std::size_t kChunkPoints = DetailLevels::kPoints;

WorldBox boxOf(Point<World> point) { return {point, point}; }

void extend(WorldBox& box, Point<World> point) {
    box.min = {std::min(box.min.x, point.x), std::min(box.min.y, point.y)};
    box.max = {std::max(box.max.x, point.x), std::max(box.max.y, point.y)};
}

bool overlap(const WorldBox& a, const WorldBox& b) {
    return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y;
}

double diagonal(const WorldBox& box) { return (box.max - box.min).length(); }

// Gathers points to runs of at most kRunPoints, each beginning with the end of the one before.
class RunWriter {
  public:
    explicit RunWriter(const Track::DrawRun& draw) : draw_(draw) {}

    bool running() const { return count_ > 0; }
    void add(Point<World> point) {
        if (count_ == run_.size()) {
            draw_({run_.data(), count_});
            run_[0] = run_.back();
            count_ = 1;
        }
        run_[count_++] = point;
    }
    void end() {
        if (count_ > 0) draw_({run_.data(), count_});
        count_ = 0;
    }

  private:
    const Track::DrawRun& draw_;
    std::array<Point<World>, Track::kRunPoints> run_{};
    std::size_t count_ = 0;
};

// Simplified on the fly: what lies within the tolerance of the last drawn point is skipped.
void drawNearby(std::span<const TrackPoint> points, double tolerance_m, RunWriter& run) {
    for (std::size_t i = 0, last_drawn = 0; i < points.size(); ++i) {
        const Vector<World> step = points[i].pose.position - points[last_drawn].pose.position;
        const bool far = step.x * step.x + step.y * step.y > tolerance_m * tolerance_m;
        if (i != 0 && i + 1 != points.size() && !far) continue;
        run.add(points[i].pose.position);
        last_drawn = i;
    }
}

WorldBox boxOf(std::span<const TrackPoint> points, std::optional<Point<World>> before) {
    WorldBox box = boxOf(before.value_or(points.front().pose.position));
    for (const TrackPoint& point : points) extend(box, point.pose.position);
    return box;
}

DetailLevels levelsOf(std::span<const TrackPoint> points) {
    std::array<Point<World>, kChunkPoints> positions{};
    for (std::size_t i = 0; i < points.size(); ++i) positions[i] = points[i].pose.position;
    return DetailLevels({positions.data(), points.size()});
}

}  // namespace

struct Track::Chunk {
    Chunk(std::span<const TrackPoint> source, std::optional<Point<World>> before)
        : box(boxOf(source, before)), levels(levelsOf(source)) {
        std::copy(source.begin(), source.end(), points.begin());
    }

    void draw(double tolerance_m, RunWriter& run) const {
        // Joined to its neighbours by one point, a chunk that is smaller than the tolerance is
        // drawn well enough.
        if (diagonal(box) <= tolerance_m) return run.add(points.front().pose.position);
        const int level = DetailLevels::levelWithin(tolerance_m);
        if (level == DetailLevels::kEveryPoint) {
            for (const TrackPoint& point : points) run.add(point.pose.position);
        } else {
            levels.forEach(level, [&](std::size_t i) { run.add(points[i].pose.position); });
        }
    }

    WorldBox box;  // with the stretch from the chunk before
    DetailLevels levels;
    std::array<TrackPoint, kChunkPoints> points;
};

Track::Track() = default;

void Track::append(const TrackPoint& point) {
    if (empty()) bounds_ = boxOf(point.pose.position);
    extend(bounds_, point.pose.position);
    tail_.push_back(point);
    if (tail_.size() < kChunkPoints) return;
    std::optional<Point<World>> before;
    if (!full_.empty()) before = full_.back()->points.back().pose.position;
    full_.push_back(std::make_shared<const Chunk>(tail_, before));
    tail_.clear();
}

std::size_t Track::size() const { return kChunkPoints * full_.size() + tail_.size(); }

TrackPoint Track::at(std::size_t index) const {
    assert(index < size());
    const std::size_t chunk = index / kChunkPoints;
    return chunk < full_.size() ? full_[chunk]->points[index % kChunkPoints]
                                : tail_[index % kChunkPoints];
}

std::size_t Track::memoryBytes() const {
    return sizeof(Track) + full_.capacity() * sizeof(full_[0]) + full_.size() * sizeof(Chunk) +
           tail_.capacity() * sizeof(TrackPoint);
}

void Track::simplified(const WorldBox& area, double tolerance_m, const DrawRun& draw) const {
    RunWriter run(draw);
    const Chunk* before = nullptr;
    const auto begin = [&] {
        if (!run.running() && before) run.add(before->points.back().pose.position);
    };
    for (const auto& chunk : full_) {
        if (overlap(chunk->box, area)) {
            begin();
            chunk->draw(tolerance_m, run);
        } else {
            run.end();
        }
        before = chunk.get();
    }
    std::optional<Point<World>> last;
    if (before) last = before->points.back().pose.position;
    if (!tail_.empty() && overlap(boxOf(tail_, last), area)) {
        begin();
        drawNearby(tail_, tolerance_m, run);
    }
    run.end();
}

}  // namespace hedr
