#pragma once

#include <QObject>
#include <QThreadPool>

#include "ui/map/base_image.h"

namespace hedr {

// Keeps the newest base image, drawn on a worker thread. One job runs at a time; a job whose scene
// has been replaced meanwhile comes back too late and is dropped.
class BaseKeeper : public QObject {
    Q_OBJECT

  public:
    explicit BaseKeeper(QObject* parent = nullptr);
    ~BaseKeeper() override;

    const BaseImage& base() const { return base_; }
    bool busy() const { return busy_; }
    bool outdated() const { return base_job_ != job_; }

    void invalidate() { ++job_; }  // the scene is another one now
    void drop();                   // and the old picture must not be seen any more
    void draw(MapScene scene, const ViewTransform& view, double device_ratio);
    // What has come of a trail: little enough for the GUI thread.
    void grow(const LiveTrail& trail, const QPen& pen, RobotId robot);

  signals:
    void renewed();

  private:
    void take(int job, BaseImage base);

    BaseImage base_;
    int job_ = 1;       // number of the scene that is wanted
    int base_job_ = 0;  // number of the scene that base_ shows
    bool busy_ = false;
    QThreadPool pool_;
};

}  // namespace hedr
