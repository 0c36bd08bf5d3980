#include "ui/site/site_model.h"

#include <algorithm>
#include <utility>

namespace hedr {

SiteModel::SiteModel(QObject* parent)
    : QObject(parent), history_(Site{.floors = {{.name = tr("Floor 1").toStdString()}}}) {}

const PlanImage* SiteModel::image(const SitePlan& plan) const {
    const auto found = images_.find(plan.image_file);
    return found == images_.end() ? nullptr : &found->second;
}

std::vector<MapPlan> SiteModel::mapPlans() const {
    std::vector<MapPlan> drawn;
    for (const SitePlan& plan : floor().plans) {
        const PlanImage* pixels = image(plan);
        if (!plan.visible || !pixels) continue;
        drawn.push_back({*pixels, plan.opacity, plan.inverted_at_night, plan.crop});
        drawn.back().image.placement = plan.placement;
    }
    return drawn;
}

void SiteModel::addImage(const PlanImage& image) {
    images_[image.image_file] = image;
    Site next = history_.now();
    std::vector<SitePlan>& plans = next.floors.at(floor_).plans;
    const bool known = std::ranges::any_of(
        plans, [&](const SitePlan& plan) { return plan.image_file == image.image_file; });
    if (known) {
        emit changed();
        return;
    }
    plans.push_back({.image_file = image.image_file, .placement = image.placement});
    edit(std::move(next));
}

void SiteModel::edit(Site next) {
    history_.add(std::move(next));
    settle();
}

void SiteModel::preview(Site next) {
    preview_ = std::move(next);
    emit changed();
}

void SiteModel::dropPreview() { settle(); }

void SiteModel::undo() {
    history_.undo();
    settle();
}

void SiteModel::redo() {
    history_.redo();
    settle();
}

void SiteModel::settle() {
    preview_.reset();
    emit changed();
}

}  // namespace hedr
