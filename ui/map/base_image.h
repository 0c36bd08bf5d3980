#pragma once

#include <QImage>
#include <QPen>
#include <string>
#include <vector>

#include "ui/fleet.h"
#include "ui/map/map_plan.h"
#include "ui/map/trail_layer.h"
#include "ui/map/view_transform.h"
#include "ui/theme.h"

namespace hedr {

struct SceneTrail {
    LiveTrail trail;
    QPen pen{};
    RobotId robot = kFirstRobot;
};

// A snapshot of everything that the slow layers show, by value: a worker thread draws from it.
struct MapScene {
    std::vector<MapPlan> plans;      // the lowest first
    std::vector<SceneTrail> trails;  // drawn in this order
    Theme theme{};
    std::vector<SceneTrail> earlier{};  // of former stays on this floor, below the trails
};

struct DrawnTrail {
    RobotId robot = kFirstRobot;
    std::string name{};
    TrailEnd end{};
};

// The slow layers as pixels, and how far they reach.
struct BaseImage {
    QImage image;
    ViewTransform view{};
    std::vector<DrawnTrail> trails;
    std::size_t grown_points = 0;  // drawn onto it since

    const DrawnTrail* find(RobotId robot, const std::string& name) const;
};

// Pure: may run on any thread.
BaseImage renderBase(const MapScene& scene, const ViewTransform& view, double device_ratio);

// Draws onto it what has come of a trail since, above all that is there.
void growBase(BaseImage& base, const LiveTrail& trail, const QPen& pen, RobotId robot);

}  // namespace hedr
