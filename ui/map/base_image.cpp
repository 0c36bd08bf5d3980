#include "ui/map/base_image.h"

#include <QPainter>
#include <algorithm>

#include "ui/map/plan_layer.h"

namespace hedr {

const DrawnTrail* BaseImage::find(const std::string& name) const {
    const auto found = std::find_if(trails.begin(), trails.end(),
                                    [&](const DrawnTrail& trail) { return trail.name == name; });
    return found == trails.end() ? nullptr : &*found;
}

BaseImage renderBase(const MapScene& scene, const ViewTransform& view, double device_ratio) {
    BaseImage base{QImage((QSizeF(view.width_px, view.height_px) * device_ratio).toSize(),
                          QImage::Format_RGB32),
                   view,
                   {}};
    base.image.setDevicePixelRatio(device_ratio);
    base.image.fill(scene.theme.background);
    QPainter painter(&base.image);
    painter.setRenderHint(QPainter::Antialiasing);
    if (scene.plan) drawPlan(painter, *scene.plan, scene.theme, view);
    for (const auto& [trail, pen] : scene.trails) {
        base.trails.push_back({trail.name, drawTrail(painter, trail.track, pen, view)});
    }
    return base;
}

}  // namespace hedr
