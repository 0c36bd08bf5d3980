#pragma once

#include <QObject>
#include <vector>

#include "ui/background_job.h"
#include "ui/site/plan_glance.h"

namespace hedr {

// Looks at files for lists and dialogs, one after the other, off the GUI thread. A new wish waits
// for the file that is being looked at, but for no other: the GUI thread waits for none.
class PlanGlancer : public QObject {
    Q_OBJECT

  public:
    static constexpr int kSide_px = 320;

    using QObject::QObject;
    void want(std::vector<PlanFileWish> files);  // and none of those wanted before

  signals:
    void glanced(const hedr::PlanFileWish& file, const hedr::PlanGlance& glance);

  private:
    void lookAtNext();

    std::vector<PlanFileWish> wanted_{};  // the next one last
    BackgroundJob job_;
};

}  // namespace hedr
