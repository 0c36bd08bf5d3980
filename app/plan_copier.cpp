#include "app/plan_copier.h"

#include "ui/main_window.h"

namespace hedr {

PlanCopier::PlanCopier(MainWindow& window, QObject* parent) : QObject(parent), window_(window) {
    connect(&window_, &MainWindow::copyChosen, this, &PlanCopier::add);
    connect(&window_, &MainWindow::copyCanceled, this, &PlanCopier::cancel);
    connect(&writing_, &BackgroundJob::progressed, this, [this](double share) {
        if (writing_.running() && !canceled_) window_.showCopyProgress(share);
    });
}

void PlanCopier::add(const PlanCopy& copy) {
    waiting_.push_back(copy);
    if (!writing_.running()) writeNext();
}

// A large file may be in the middle of something that takes a while: nobody waits for that.
void PlanCopier::cancel() {
    waiting_.clear();
    canceled_ = true;
    writing_.askToEnd();
    window_.showCopyProgress(std::nullopt);
}

void PlanCopier::writeNext() {
    window_.showCopyProgress(std::nullopt);
    if (waiting_.empty()) return;
    const PlanCopy copy = std::move(waiting_.front());
    waiting_.pop_front();
    canceled_ = false;
    window_.showCopyProgress(0.0);
    writing_.start([copy](const PlanProgress& progress) { return writePlanCopy(copy, progress); },
                   [this](const Result<std::vector<std::filesystem::path>>& files) {
                       tell(files);
                       writeNext();
                   });
}

// It may have been too late to cancel it.
void PlanCopier::tell(const Result<std::vector<std::filesystem::path>>& files) {
    if (files) return window_.showSaved(*files);
    if (files.error().code != ErrorCode::kCanceled) emit failed(files.error());
}

}  // namespace hedr
