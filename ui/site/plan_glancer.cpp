#include "ui/site/plan_glancer.h"

#include <algorithm>
#include <utility>

namespace hedr {

void PlanGlancer::want(std::vector<PlanFileWish> files) {
    std::ranges::reverse(files);
    wanted_ = std::move(files);
    if (!job_.running()) lookAtNext();
}

void PlanGlancer::lookAtNext() {
    if (wanted_.empty()) return;
    const PlanFileWish file = wanted_.back();
    wanted_.pop_back();
    job_.start([file](const PlanProgress&) { return glanceAt(file, kSide_px); },
               [this, file](const PlanGlance& glance) {
                   lookAtNext();
                   emit glanced(file, glance);
               });
}

}  // namespace hedr
