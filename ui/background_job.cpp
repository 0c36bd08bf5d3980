#include "ui/background_job.h"

namespace hedr {

BackgroundJob::~BackgroundJob() { cancel(); }

PlanProgress BackgroundJob::begin() {
    cancel();
    running_ = true;
    canceled_ = std::make_shared<std::atomic<bool>>(false);
    return [this, canceled = canceled_](double share) {
        if (canceled->load()) return false;
        emit progressed(share);
        return true;
    };
}

// Waits for the worker: it asks for its progress often, so not for long.
void BackgroundJob::cancel() {
    ++job_;
    running_ = false;
    if (canceled_) canceled_->store(true);
    if (worker_.valid()) worker_.wait();
}

void BackgroundJob::askToEnd() {
    if (canceled_) canceled_->store(true);
}

void BackgroundJob::end(int job) {
    Q_ASSERT(job == job_);
    running_ = false;
}

}  // namespace hedr
