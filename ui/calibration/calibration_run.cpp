#include "ui/calibration/calibration_run.h"

#include <utility>

namespace hedr {

namespace {

constexpr int kLook_ms = 1000;

}  // namespace

CalibrationRun::CalibrationRun(const Procedure& procedure, const Vehicle& believed, QObject* parent)
    : QObject(parent),
      procedure_(procedure),
      samples_(std::make_shared<SampleCollector>("live", believed)) {
    connect(&timer_, &QTimer::timeout, this, [this] {
        if (!waiting_.empty()) look();
    });
    timer_.start(kLook_ms);
    look();  // what to do is known before the first sample
}

void CalibrationRun::add(const std::vector<HeardSensors>& sensors) {
    if (!concluding_) waiting_.insert(waiting_.end(), sensors.begin(), sensors.end());
}

void CalibrationRun::conclude() {
    concluding_ = true;
    timer_.stop();
    look();
}

void CalibrationRun::look() {
    if (job_.running()) return;  // its end looks again where that is needed
    auto work = [samples = samples_, news = std::exchange(waiting_, {}),
                 run = procedure_.run](const PlanProgress&) {
        samples->add(news);
        return run(samples->input());
    };
    job_.start(std::move(work), [this](Calibration calibration) { take(std::move(calibration)); });
}

void CalibrationRun::take(Calibration calibration) {
    latest_ = std::move(calibration);
    emit changed();
    if (!concluding_) return;
    if (!waiting_.empty()) return look();
    emit concluded({latest_, samples_->input()});
}

}  // namespace hedr
