#include <benchmark/benchmark.h>

#include <QApplication>
#include <QEvent>
#include <QTemporaryDir>
#include <QThread>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>

#include "core/site/mip_pyramid.h"
#include "radio/live_link.h"
#include "radio/replay.h"
#include "ui/main_window.h"

// From a byte at the port to the painted window: a robot speaks 100 times a second over a
// pseudo-terminal, while all is recorded, every estimator runs, and a plan of 10,000 x 10,000
// pixels lies below.
namespace hedr {
namespace {

using Time = ReceiveClock::time_point;

constexpr int kSamples = 1000;
constexpr double kPeriod_s = 0.01;

SensorReport sampleAt(int i) {
    const double travel_m = 0.006 * i;
    SensorReport report;
    report.robot_time_s = kPeriod_s * i;
    report.odometry = WheelTravel{travel_m, travel_m};
    report.gyro = GyroRate{0.01 * std::sin(0.02 * i)};
    return report;
}

PlanImage largePlan() {
    constexpr int kSide_px = 10'000;
    std::vector<std::uint8_t> pixels(static_cast<std::size_t>(kSide_px) * kSide_px, 255);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (i / kSide_px % 200 < 4 || i % 200 < 4) pixels[i] = 0;
    }
    PlanImage plan;
    plan.levels =
        mipPyramid({kSide_px, kSide_px, 1,
                    std::make_shared<const std::vector<std::uint8_t>>(std::move(pixels))});
    plan.placement.resolution_m = 0.01;
    return plan;
}

// Speaks in real time and remembers when it said what.
class SpeakingRobot {
  public:
    explicit SpeakingRobot(RobotLine line) : sent_(kSamples), line_(std::move(line)) {
        thread_ = std::thread([this] { speak(); });
    }
    ~SpeakingRobot() { thread_.join(); }
    bool done() const { return count_ == kSamples; }
    Time sentAt(int i) const { return sent_[static_cast<std::size_t>(i)]; }
    int count() const { return count_; }

  private:
    void speak() {
        SimulatedRobot robot(vehiclePresets().front(), {});
        if (!waitForListener(line_, [] { return false; })) return;
        const Time start = ReceiveClock::now();
        for (int i = 0; i < kSamples; ++i) {
            std::this_thread::sleep_until(start + i * std::chrono::milliseconds(10));
            sent_[static_cast<std::size_t>(i)] = ReceiveClock::now();
            robot.sense(sampleAt(i), [&](std::span<const std::uint8_t> f) { line_.send(f); });
            count_ = i + 1;
        }
    }

    std::vector<Time> sent_;
    std::atomic<int> count_ = 0;
    RobotLine line_;
    std::thread thread_;
};

// Notes when the samples that a batch brought have been painted.
class PaintWatch : public QObject {
  public:
    explicit PaintWatch(MainWindow& window) { window.installEventFilter(this); }
    void arrived(int samples) { arrived_ = std::max(arrived_, samples); }
    std::vector<double> latencies_ms(const SpeakingRobot& robot) const {
        std::vector<double> all;
        for (const auto& [sample, painted] : painted_) {
            const auto late = painted - robot.sentAt(sample);
            all.push_back(std::chrono::duration<double, std::milli>(late).count());
        }
        std::sort(all.begin(), all.end());
        return all;
    }

  protected:
    bool eventFilter(QObject* object, QEvent* event) override {
        // What is queued now runs when the window has been painted.
        if (event->type() == QEvent::UpdateRequest) {
            QMetaObject::invokeMethod(
                this, [this] { notePainted(); }, Qt::QueuedConnection);
        }
        return QObject::eventFilter(object, event);
    }

  private:
    void notePainted() {
        for (; next_ < arrived_; ++next_) painted_.emplace_back(next_, ReceiveClock::now());
    }

    int arrived_ = 0;
    int next_ = 0;
    std::vector<std::pair<int, Time>> painted_;
};

void byteToPixel(benchmark::State& state) {
    QTemporaryDir folder;
    const std::string port = folder.filePath("robot").toStdString();
    MainWindow window;
    window.resize(1920, 1080);
    window.setPlan(largePlan());
    window.show();
    QThread radio_thread;
    auto* link = new LiveLink({vehiclePresets().front(),
                               folder.filePath("m.hedr").toStdString(),
                               {std::chrono::system_clock::now(), "benchmark"}});
    link->moveToThread(&radio_thread);
    QObject::connect(&radio_thread, &QThread::finished, link, &QObject::deleteLater);
    PaintWatch watch(window);
    QObject::connect(link, &LiveLink::batchReady, &window, [&](const LiveBatch& batch) {
        for (const NamedPoints& track : batch.tracks) {
            if (track.name != "odometry" || track.points.empty()) continue;
            watch.arrived(1 + static_cast<int>(std::lround(track.points.back().t_s / kPeriod_s)));
        }
        window.applyBatch(batch);
    });
    radio_thread.start();
    for ([[maybe_unused]] auto _ : state) {
        SpeakingRobot robot(*RobotLine::openPseudoTerminal(port));
        QMetaObject::invokeMethod(link, [&] {
            link->open(SerialAddress{QString::fromStdString(port), 57600});
        });
        while (!robot.done()) {
            QApplication::processEvents(QEventLoop::WaitForMoreEvents | QEventLoop::AllEvents);
        }
        const std::vector<double> late_ms = watch.latencies_ms(robot);
        const auto percentile = [&](std::size_t p) { return late_ms[late_ms.size() * p / 100]; };
        state.counters["samples"] = static_cast<double>(late_ms.size());
        if (late_ms.empty()) break;
        state.counters["p50_ms"] = percentile(50);
        state.counters["p95_ms"] = percentile(95);
        state.counters["p99_ms"] = percentile(99);
    }
    radio_thread.quit();
    radio_thread.wait();
}

BENCHMARK(byteToPixel)->Iterations(1)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

}  // namespace
}  // namespace hedr
