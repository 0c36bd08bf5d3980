#include "ui/map/base_keeper.h"

#include <utility>

namespace hedr {

BaseKeeper::BaseKeeper(QObject* parent) : QObject(parent) { pool_.setMaxThreadCount(1); }

BaseKeeper::~BaseKeeper() { pool_.waitForDone(); }

void BaseKeeper::drop() {
    invalidate();
    base_ = {};
}

void BaseKeeper::draw(MapScene scene, const ViewTransform& view, double device_ratio) {
    if (busy_) return;
    busy_ = true;
    pool_.start([this, job = job_, scene = std::move(scene), view, device_ratio] {
        BaseImage base = renderBase(scene, view, device_ratio);
        QMetaObject::invokeMethod(
            this, [this, job, done = std::move(base)]() mutable { take(job, std::move(done)); },
            Qt::QueuedConnection);
    });
}

void BaseKeeper::grow(const LiveTrail& trail, const QPen& pen, RobotId robot) {
    if (!outdated()) growBase(base_, trail, pen, robot);
}

void BaseKeeper::take(int job, BaseImage base) {
    busy_ = false;
    if (job == job_) {
        base_ = std::move(base);
        base_job_ = job;
    }
    emit renewed();
}

}  // namespace hedr
