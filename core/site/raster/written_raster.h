#pragma once

#include "core/site/plan.h"
#include "core/site/raster/gdal_file.h"

namespace hedr {

// The pixels as GDAL's bands red, green, blue, or one of grey; they stay where they are, so the
// image outlives it. Null where GDAL fails.
Dataset bandsOn(const PlanLevel& image);

// Lets GDAL ask a work of ours whether to go on, and remembers what that said.
class WrittenShare {
  public:
    explicit WrittenShare(const PlanProgress& progress) : progress_(progress) {}
    bool canceled() const { return canceled_; }
    static int CPL_STDCALL ask(double share, const char* message, void* written_share);

  private:
    const PlanProgress& progress_;
    bool canceled_ = false;
};

}  // namespace hedr
