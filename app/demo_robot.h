#pragma once

#include <QTemporaryDir>
#include <atomic>
#include <memory>
#include <thread>

#include "core/result.h"

namespace hedr {

// A simulated robot in the sample building, speaking through a pseudo-terminal in this process.
class DemoRobot {
  public:
    // Errors: kFileUnwritable, kPortFailed.
    static Result<std::unique_ptr<DemoRobot>> start();
    ~DemoRobot();

    QString port() const { return folder_.filePath("robot"); }
    QString planFile() const { return folder_.filePath("plan.toml"); }

  private:
    DemoRobot() = default;

    QTemporaryDir folder_;
    std::atomic<bool> stop_{false};
    std::thread thread_;
};

}  // namespace hedr
