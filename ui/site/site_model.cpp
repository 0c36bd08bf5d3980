#include "ui/site/site_model.h"

#include <algorithm>
#include <utility>

namespace hedr {
namespace {

Site withAFloor(Site site) {
    if (site.floors.empty()) {
        site.floors.push_back({.name = SiteModel::tr("Ground floor").toStdString()});
    }
    return site;
}

}  // namespace

Site withPlan(Site site, std::size_t floor, std::size_t plan, const SitePlan& changed) {
    site.floors.at(floor).plans.at(plan) = changed;
    return site;
}

SiteModel::SiteModel(QObject* parent) : QObject(parent), history_(withAFloor({})) {}

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

void SiteModel::open(const Site& site) {
    history_ = History<Site>(withAFloor(site));
    preview_.reset();
    floor_ = 0;
    emit changed();
}

std::size_t SiteModel::addImage(const PlanImage& image) {
    images_[image.image_file] = image;
    const auto& plans = floor().plans;
    const auto known = std::find_if(plans.begin(), plans.end(), [&](const SitePlan& plan) {
        return plan.image_file == image.image_file;
    });
    const auto index = static_cast<std::size_t>(known - plans.begin());
    if (known != plans.end()) {
        emit changed();
        return index;
    }
    Site next = history_.now();
    next.floors[floor_].plans.push_back(
        {.image_file = image.image_file, .placement = image.placement});
    edit(std::move(next), tr("Add a plan"));
    return index;
}

void SiteModel::showFloor(std::size_t index) {
    if (index == floor_ || index >= site().floors.size()) return;
    floor_ = index;
    emit changed();
    emit floorChanged();
}

void SiteModel::edit(Site next, const QString& what) {
    history_.add(std::move(next), what);
    settle();
}

void SiteModel::preview(Site next) {
    preview_ = std::move(next);
    emit changed();
}

void SiteModel::dropPreview() {
    preview_.reset();
    emit changed();
}

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
    floor_ = std::min(floor_, site().floors.size() - 1);
    emit changed();
    emit edited();
}

}  // namespace hedr
