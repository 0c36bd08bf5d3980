#include "ui/map/miniature.h"

#include <optional>

#include "ui/map/plan_layer.h"

namespace hedr {
namespace {

constexpr double kEdge_px = 6.0;

std::optional<WorldBox> boundsOf(const MapScene& scene) {
    std::optional<WorldBox> box;
    const auto add = [&](const WorldBox& more) { box = box ? united(*box, more) : more; };
    for (const MapPlan& plan : scene.plans) add(planBounds(plan));
    for (const auto* trails : {&scene.earlier, &scene.trails}) {
        for (const SceneTrail& trail : *trails) add(trail.trail.track.bounds());
    }
    return box;
}

}  // namespace

QImage miniatureOf(const MapScene& scene, const QSize& size, double device_ratio) {
    ViewTransform view = ViewTransform{}.resized(size.width(), size.height());
    if (const auto box = boundsOf(scene)) {
        view = view.fitted(*box, {kEdge_px, kEdge_px, kEdge_px, kEdge_px});
    }
    return renderBase(scene, view, device_ratio).image;
}

}  // namespace hedr
