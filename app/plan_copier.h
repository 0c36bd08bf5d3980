#pragma once

#include <QObject>
#include <deque>

#include "core/site/plan_copy.h"
#include "radio/source/serial_source.h"  // Error as a type that signals carry
#include "ui/background_job.h"

namespace hedr {

class MainWindow;

// Writes copies of plans for other programs, one after the other, and tells the window how far they
// are and where they lie.
class PlanCopier : public QObject {
    Q_OBJECT

  public:
    PlanCopier(MainWindow& window, QObject* parent);

    void add(const PlanCopy& copy);
    void cancel();  // also what waits

  signals:
    void failed(const hedr::Error& error);

  private:
    void writeNext();
    void tell(const Result<std::vector<std::filesystem::path>>& files);

    MainWindow& window_;
    BackgroundJob writing_;
    std::deque<PlanCopy> waiting_{};
    bool canceled_ = false;  // the one that is being written
};

}  // namespace hedr
