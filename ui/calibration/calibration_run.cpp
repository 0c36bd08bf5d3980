#include "ui/calibration/calibration_run.h"

#include <utility>

namespace hedr {

namespace {

constexpr int kLook_ms = 1000;
constexpr std::size_t kMuch = 500;  // readings: half a minute of a slow robot

}  // namespace

CalibrationRun::CalibrationRun(const Procedure& procedure, const Vehicle& believed, QObject* parent)
    : QObject(parent),
      procedure_(procedure),
      samples_(std::make_shared<SampleCollector>("live", believed)) {
    connect(&timer_, &QTimer::timeout, this, [this] {
        const bool news = waiting_.size() > 1 || !waiting_.back().empty();
        if (news && !job_.running()) look();
    });
    timer_.start(kLook_ms);
    look();  // what to do is known before the first sample
}

void CalibrationRun::add(const std::vector<HeardSensors>& sensors) {
    std::vector<HeardSensors>& last = waiting_.back();
    if (concluding_) return;
    last.insert(last.end(), sensors.begin(), sensors.end());
    heard_ += sensors.size();
}

bool CalibrationRun::heardMuch() const { return heard_ >= kMuch; }

void CalibrationRun::set(const ProcedureSettings& settings) {
    if (concluding_) return;
    settings_ = settings;
    look();
}

void CalibrationRun::mark() {
    if (concluding_) return;
    waiting_.emplace_back();
    look();
}

void CalibrationRun::conclude() {
    concluding_ = true;
    timer_.stop();
    look();
}

void CalibrationRun::look() {
    looks_again_ = job_.running();
    if (looks_again_) return;
    auto work = [samples = samples_, news = std::exchange(waiting_, Stretches(1)),
                 settings = settings_, run = procedure_.run](const PlanProgress&) {
        for (std::size_t i = 0; i < news.size(); ++i) {
            if (i > 0) samples->mark();
            samples->add(news[i]);
        }
        samples->set(settings);
        return run(samples->input());
    };
    job_.start(std::move(work), [this](Calibration calibration) { take(std::move(calibration)); });
}

void CalibrationRun::take(Calibration calibration) {
    latest_ = std::move(calibration);
    emit changed();
    if (looks_again_) return look();
    if (concluding_) emit concluded({latest_, samples_->input()});
}

}  // namespace hedr
