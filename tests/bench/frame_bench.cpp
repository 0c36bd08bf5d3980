#include <benchmark/benchmark.h>

#include <QApplication>
#include <QPainter>
#include <cmath>
#include <random>

#include "ui/live_model.h"
#include "ui/map/base_image.h"
#include "ui/map/map_view.h"
#include "ui/trail_style.h"

// How long the map takes: a random walk of 5 mm per point on 1920 x 1080, as in the figures of
// other programs. The reference is what a plain widget does: QPainter with all points in chunks.
namespace hedr {
namespace {

constexpr double kWidth_px = 1920.0;
constexpr double kHeight_px = 1080.0;

std::vector<TrackPoint> randomWalk(std::size_t points) {
    std::mt19937 random(7);
    std::normal_distribution<double> turn(0.0, 0.05);
    std::vector<TrackPoint> walk;
    TrackPoint point;
    for (std::size_t i = 0; i < points; ++i) {
        point.t_s = 0.01 * static_cast<double>(i);
        point.pose.heading_rad += turn(random);
        point.pose.position =
            point.pose.position + Vector<World>{0.005 * std::cos(point.pose.heading_rad),
                                                0.005 * std::sin(point.pose.heading_rad)};
        walk.push_back(point);
    }
    return walk;
}

LiveBatch batchOf(std::vector<TrackPoint> points) {
    LiveBatch batch;
    batch.port = PortState::kOpen;
    batch.last_frame = ReceiveClock::now();
    batch.tracks = {{"hedr", std::move(points)}};
    return batch;
}

ViewTransform fullView(const Track& track) {
    const ViewTransform view{{}, 1.0, 0.0, kWidth_px, kHeight_px};
    return view.fitted(track.bounds(), {20, 20, 20, 20});
}

std::size_t pointsOf(const benchmark::State& state) {
    return static_cast<std::size_t>(state.range(0));
}

void qpainterChunks(benchmark::State& state) {
    Track track;
    for (const TrackPoint& point : randomWalk(pointsOf(state))) track.append(point);
    const auto view_from_world = fullView(track).viewFromWorld();
    std::vector<QPointF> line;
    for (std::size_t i = 0; i < track.size(); ++i) {
        const Point<View> p = view_from_world * track.at(i).pose.position;
        line.emplace_back(p.x, p.y);
    }
    QImage image(1920, 1080, QImage::Format_RGB32);
    for ([[maybe_unused]] auto _ : state) {
        image.fill(Qt::white);
        QPainter painter(&image);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(trailPen("hedr", true, dayTheme()));
        for (std::size_t from = 0; from + 1 < line.size(); from += 256) {
            const std::size_t count = std::min<std::size_t>(257, line.size() - from);
            painter.drawPolyline(line.data() + from, static_cast<int>(count));
        }
    }
}

MapScene sceneOf(const LiveModel& model, bool primary) {
    const LiveTrail& trail = *model.primary();
    return {{}, {{trail, trailPen(trail.name, primary, dayTheme())}}, dayTheme()};
}

void sharpRenderOf(benchmark::State& state, bool primary) {
    LiveModel model;
    model.apply(batchOf(randomWalk(pointsOf(state))), ReceiveClock::now());
    const MapScene scene = sceneOf(model, primary);
    const ViewTransform view = fullView(model.primary()->track).grown(256.0);
    for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(renderBase(scene, view, 1.0));
}

void sharpRender(benchmark::State& state) { sharpRenderOf(state, true); }

void sharpRenderDashed(benchmark::State& state) { sharpRenderOf(state, false); }

void sharpRenderZoomedIn(benchmark::State& state) {
    LiveModel model;
    model.apply(batchOf(randomWalk(pointsOf(state))), ReceiveClock::now());
    const MapScene scene = sceneOf(model, true);
    const ViewTransform view = fullView(model.primary()->track)
                                   .zoomed({kWidth_px / 2.0, kHeight_px / 2.0}, 8.0)
                                   .grown(256.0);
    for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(renderBase(scene, view, 1.0));
}

// A map that has its sharp picture.
class ReadyMap {
  public:
    explicit ReadyMap(std::size_t points) : map_(fleet_) {
        model().apply(batchOf(randomWalk(points)), ReceiveClock::now());
        map_.resize(1920, 1080);
        map_.show();
        map_.fit();
        settle();
    }
    void settle() {
        while (!map_.isSharp()) QApplication::processEvents(QEventLoop::WaitForMoreEvents);
        map_.render(&image_);
    }
    void frame() { map_.render(&image_); }
    LiveModel& model() { return fleet_.chosen().model; }
    MapView& map() { return map_; }

  private:
    Fleet fleet_;
    MapView map_;
    QImage image_{1920, 1080, QImage::Format_RGB32};
};

void frameWhilePanning(benchmark::State& state) {
    ReadyMap ready(pointsOf(state));
    double way = 2.0;
    for ([[maybe_unused]] auto _ : state) {
        ready.map().panBy({way, 0.0});
        way = -way;
        ready.frame();
    }
}

void frameWhileZooming(benchmark::State& state) {
    ReadyMap ready(pointsOf(state));
    double factor = 1.2;
    for ([[maybe_unused]] auto _ : state) {
        ready.map().zoomBy(factor);
        factor = 1.0 / factor;
        ready.frame();
    }
}

void frameWithTwentyNewPoints(benchmark::State& state) {
    ReadyMap ready(pointsOf(state));
    std::vector<TrackPoint> walk = randomWalk(pointsOf(state) + 20);
    walk.erase(walk.begin(), walk.end() - 20);
    ready.model().apply(batchOf(walk), ReceiveClock::now());
    for ([[maybe_unused]] auto _ : state) {
        ready.map().refresh(ReceiveClock::now());
        ready.frame();
    }
}

#define HEDR_FRAME_BENCHMARK(function) \
    BENCHMARK(function)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond)

HEDR_FRAME_BENCHMARK(qpainterChunks);
HEDR_FRAME_BENCHMARK(sharpRender);
HEDR_FRAME_BENCHMARK(sharpRenderDashed);
HEDR_FRAME_BENCHMARK(sharpRenderZoomedIn);
HEDR_FRAME_BENCHMARK(frameWhilePanning);
HEDR_FRAME_BENCHMARK(frameWhileZooming);
HEDR_FRAME_BENCHMARK(frameWithTwentyNewPoints);

}  // namespace
}  // namespace hedr
