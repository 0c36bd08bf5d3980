#pragma once

#include <QObject>
#include <QThreadPool>
#include <atomic>
#include <future>
#include <memory>
#include <utility>

#include "core/site/plan.h"

namespace hedr {

// One long computation at a time, off the GUI thread. A new one, or the owner's end, cancels it; a
// result that comes too late is dropped.
class BackgroundJob : public QObject {
    Q_OBJECT

  public:
    using QObject::QObject;
    ~BackgroundJob() override;

    // Runs `work(progress)` on a worker and then `done(its result)` on this object's thread.
    template <class Work, class Done>
    void start(Work work, Done done);
    void cancel();    // waits for the worker; its result is dropped
    void askToEnd();  // waits for nothing: the worker's progress says false, its result comes
    bool running() const { return running_; }
    int job() const { return job_; }  // the number of the last one that was started

  signals:
    void progressed(double share);  // 0..1

  private:
    PlanProgress begin();  // its progress; false once it is canceled
    void end(int job);

    std::shared_ptr<std::atomic<bool>> canceled_{};
    std::future<void> worker_{};
    int job_ = 0;
    bool running_ = false;
};

template <class Work, class Done>
void BackgroundJob::start(Work work, Done done) {
    PlanProgress progress = begin();
    std::promise<void> ended;
    worker_ = ended.get_future();
    auto run = [this, job = job_, progress = std::move(progress), work = std::move(work),
                done = std::move(done),
                ended = std::make_shared<std::promise<void>>(std::move(ended))]() mutable {
        auto result = work(progress);
        QMetaObject::invokeMethod(
            this, [this, job, done = std::move(done), result = std::move(result)]() mutable {
                if (job != job_) return;
                end(job);
                done(std::move(result));
            });
        ended->set_value();
    };
    QThreadPool::globalInstance()->start(std::move(run));
}

}  // namespace hedr
