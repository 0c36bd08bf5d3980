#include "tests/ui/scene.h"

#include <QDateTime>
#include <QTimeZone>
#include <algorithm>
#include <cmath>
#include <memory>

#include "core/geometry/angle.h"
#include "core/site/mip_pyramid.h"

namespace hedr::test {
namespace {

constexpr double kResolution_m = 0.05;
constexpr int kWidth_px = 1600;  // 80 m
constexpr int kHeight_px = 980;  // 49 m
constexpr double kSpeed_m_s = 0.62;

class Drawing {
  public:
    Drawing() : pixels_(static_cast<std::size_t>(kWidth_px) * kHeight_px, 255) {}

    void wall(double x0, double y0, double x1, double y1, double thickness_m = 0.16) {
        const double half = thickness_m / 2.0;
        fill(std::min(x0, x1) - half, std::min(y0, y1) - half, std::max(x0, x1) + half,
             std::max(y0, y1) + half);
    }
    void room(double x0, double y0, double x1, double y1, double thickness_m = 0.16) {
        wall(x0, y0, x1, y0, thickness_m);
        wall(x0, y1, x1, y1, thickness_m);
        wall(x0, y0, x0, y1, thickness_m);
        wall(x1, y0, x1, y1, thickness_m);
    }
    std::vector<std::uint8_t> take() { return std::move(pixels_); }

  private:
    void fill(double x0, double y0, double x1, double y1) {
        const auto column = [](double x) {
            return std::clamp(static_cast<int>(std::lround(x / kResolution_m)), 0, kWidth_px);
        };
        const auto row = [](double y) {
            return std::clamp(kHeight_px - static_cast<int>(std::lround(y / kResolution_m)), 0,
                              kHeight_px);
        };
        for (int r = row(y1); r < row(y0); ++r) {
            for (int c = column(x0); c < column(x1); ++c) {
                pixels_[static_cast<std::size_t>(r) * kWidth_px + static_cast<std::size_t>(c)] = 0;
            }
        }
    }

    std::vector<std::uint8_t> pixels_;
};

std::vector<std::uint8_t> floorPixels() {
    Drawing drawing;
    drawing.room(0.3, 0.3, 79.7, 48.7, 0.3);
    for (int i = 0; i < 8; ++i) {
        const double x = 0.3 + 79.4 / 8 * i;
        const double next = 0.3 + 79.4 / 8 * (i + 1);
        drawing.wall(x, 0.3, x, 8.4);
        drawing.wall(x, 40.6, x, 48.7);
        drawing.wall(x, 8.4, next - 1.6, 8.4);
        drawing.wall(x, 40.6, next - 1.6, 40.6);
    }
    drawing.room(3.0, 11.2, 24.6, 23.6);
    drawing.room(3.0, 26.4, 24.6, 37.8);
    drawing.room(27.4, 11.2, 52.4, 37.8);
    drawing.room(55.2, 11.2, 77.0, 23.6);
    drawing.room(55.2, 26.4, 77.0, 37.8);
    return drawing.take();
}

// The corners of the drive, in metres.
const std::vector<Point<World>>& corners() {
    static const std::vector<Point<World>> path{
        {1.6, 9.8},   {26.0, 9.8},  {26.0, 25.0}, {1.6, 25.0}, {1.6, 39.2},
        {53.8, 39.2}, {53.8, 25.0}, {78.4, 25.0}, {78.4, 9.8}, {40.0, 9.8}};
    return path;
}

Pose<World> truth(double s_m) {
    for (std::size_t i = 1; i < corners().size(); ++i) {
        const Vector<World> leg = corners()[i] - corners()[i - 1];
        const bool last = i + 1 == corners().size();
        if (s_m > leg.length() && !last) {
            s_m -= leg.length();
            continue;
        }
        const double part = std::min(1.0, s_m / leg.length());
        const double sway = 0.3 * std::sin(0.9 * s_m) * std::sin(kPi * part);
        const Vector<World> side{-leg.y / leg.length(), leg.x / leg.length()};
        return {corners()[i - 1] + part * leg + sway * side, std::atan2(leg.y, leg.x)};
    }
    return {};
}

std::vector<TrackPoint> samples(double from_s, double to_s, double error_rad_s) {
    std::vector<TrackPoint> points;
    constexpr double kStep_s = 0.05;
    Pose<World> drifted = truth(0.0);
    Pose<World> before = drifted;
    const double scale = 215.0 / kDrive_s / kSpeed_m_s;
    for (double t = 0.0; t <= to_s; t += kStep_s) {
        const Pose<World> now = truth(kSpeed_m_s * scale * t);
        const Vector<World> step = now.position - before.position;
        const double turn = error_rad_s * t + 0.02 * std::sin(t / 7.0) * (error_rad_s != 0.0);
        drifted.position =
            drifted.position + Vector<World>{step.x * std::cos(turn) - step.y * std::sin(turn),
                                             step.x * std::sin(turn) + step.y * std::cos(turn)};
        drifted.heading_rad = now.heading_rad + turn;
        before = now;
        if (t > from_s) points.push_back({t, drifted, 0.0});
    }
    return points;
}

}  // namespace

Clock HandClock::clock() const {
    Clock clock;
    clock.now = [now_s = now_s_] { return atSecond(*now_s); };
    clock.wall_now = [now_s = now_s_] {
        return QDateTime(QDate(2026, 3, 12), QTime(13, 57, 51), Qt::LocalTime)
            .addMSecs(static_cast<qint64>(1000.0 * *now_s));
    };
    return clock;
}

PlanImage samplePlan() {
    PlanImage plan;
    plan.image_file = "ground-floor.png";
    plan.levels = mipPyramid({kWidth_px, kHeight_px, 1,
                              std::make_shared<const std::vector<std::uint8_t>>(floorPixels())});
    plan.placement.resolution_m = kResolution_m;
    return plan;
}

PlanImage colouredPlan() {
    std::vector<std::uint8_t> bgra;
    const std::vector<std::uint8_t> grey = floorPixels();
    for (std::size_t i = 0; i < grey.size(); ++i) {
        const bool tinted = (i % kWidth_px) / 400 % 2 == 1;
        bgra.insert(
            bgra.end(),
            {grey[i], grey[i], static_cast<std::uint8_t>(tinted ? grey[i] * 4 / 5 : grey[i]), 255});
    }
    PlanImage plan;
    plan.image_file = "coloured-floor.png";
    plan.levels = mipPyramid({kWidth_px, kHeight_px, 4,
                              std::make_shared<const std::vector<std::uint8_t>>(std::move(bgra))});
    plan.placement.resolution_m = kResolution_m;
    return plan;
}

std::vector<TrackPoint> drift(double seconds, double error_rad_s) {
    return samples(-1.0, seconds, error_rad_s);
}

LiveBatch sampleBatch(double seconds, double from_seconds) {
    LiveBatch batch;
    batch.port = PortState::kOpen;
    batch.tracks = {{"odometry", samples(from_seconds, seconds, 0.0026)},
                    {"hedr_bayes", samples(from_seconds, seconds, 0.0)},
                    {"robot", samples(from_seconds, seconds, 0.00006)}};
    const auto sigma_rad = static_cast<float>(radFromDeg(0.4));
    for (TrackPoint& point : batch.tracks[1].points)
        point.variance = {0.02F, 0.0F, 0.02F, sigma_rad * sigma_rad};
    const HedrStatus active{.state = HedrState::kActive, .drift_rad_s = radFromDeg(3.1 / 60.0)};
    batch.statuses = {{"hedr_bayes", active}, {"robot", active}};
    batch.speed_m_s = kSpeed_m_s;
    batch.driven_m = 214.6 * seconds / kDrive_s;
    batch.link.bytes = 1'234'567;
    batch.link.good_frames = 24'900;
    batch.link.lost_frames = 100;
    batch.frames_per_s = 120.0;
    batch.last_byte = atSecond(seconds);
    batch.last_frame = atSecond(seconds);
    batch.robot = HelloReport{};
    batch.robot->vehicle = "packbot";
    batch.status = StatusReport{24.1, 0, -71};
    batch.recorder = {"/missions/today.hedr", 3'100'000, {}};
    return batch;
}

}  // namespace hedr::test
