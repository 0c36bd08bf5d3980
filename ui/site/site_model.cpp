#include "ui/site/site_model.h"

#include <algorithm>

namespace hedr {
namespace {

bool sameImage(const SitePlan& a, const SitePlan& b) {
    return a.image_file == b.image_file && a.page == b.page && a.straightened == b.straightened;
}

Site withAFloor(Site site) {
    if (site.floors.empty()) {
        site.floors.push_back({.name = SiteModel::tr("Floor 1").toStdString()});
    }
    return site;
}

}  // namespace

SiteModel::SiteModel(QObject* parent) : QObject(parent), history_(withAFloor({})) {}

const PlanImage* SiteModel::image(const SitePlan& plan) const {
    const auto found = std::ranges::find_if(
        images_, [&](const auto& known) { return sameImage(known.first, plan); });
    return found == images_.end() ? nullptr : &found->second;
}

const PlanImage* SiteModel::wholeImage(const SitePlan& plan) const {
    const PlanImage* found = image(plan);
    const bool whole = found && (found->levels.front().pixels || found->levels.front().read_part);
    return whole ? found : nullptr;
}

std::vector<MapPlan> SiteModel::mapPlans(const SiteFloor& floor) const {
    std::vector<MapPlan> drawn;
    for (const SitePlan& plan : floor.plans) {
        const PlanImage* pixels = image(plan);
        if (!plan.visible || !pixels) continue;
        drawn.push_back({*pixels, plan.opacity, plan.inverted_at_night, plan.crop});
        drawn.back().image.placement = plan.placement;
    }
    return drawn;
}

std::vector<SitePlan> SiteModel::plansWithoutImage() const {
    std::vector<SitePlan> without;
    for (const SiteFloor& floor : site().floors) {
        std::ranges::copy_if(floor.plans, std::back_inserter(without),
                             [&](const SitePlan& plan) { return !image(plan); });
    }
    return without;
}

bool SiteModel::liesByGuess(const SitePlan& plan) const {
    const PlanImage* shown = image(plan);
    return shown && shown->placement_is_guess && plan.placement == shown->placement;
}

QString SiteModel::warning(const SitePlan& plan) const {
    const auto found = std::ranges::find_if(
        warnings_, [&](const auto& known) { return sameImage(known.first, plan); });
    return found == warnings_.end() ? QString() : found->second;
}

void SiteModel::warn(const SitePlan& plan, const QString& warning) {
    std::erase_if(warnings_, [&](const auto& known) { return sameImage(known.first, plan); });
    if (!warning.isEmpty()) warnings_.emplace_back(plan, warning);
    emit changed();
}

void SiteModel::open(Site site) {
    history_ = History<Site>(withAFloor(std::move(site)));
    moveRobot(0);
    settle();
}

bool SiteModel::addImage(const PlanImage& image, int page) {
    const SitePlan plan{.image_file = image.image_file, .page = page, .placement = image.placement};
    const bool known = std::ranges::any_of(
        floor().plans, [&](const SitePlan& other) { return sameImage(other, plan); });
    giveImage(plan, image);
    if (known) return false;
    Site next = history_.now();
    next.floors.at(floor_).plans.push_back(plan);
    edit(std::move(next));
    return true;
}

void SiteModel::withdrawImage(const std::filesystem::path& file, int page, std::size_t floor) {
    const SitePlan withdrawn{.image_file = file, .page = page};
    const auto is_it = [&](const SitePlan& plan) { return sameImage(plan, withdrawn); };
    history_.rewrite([&](Site& site) {
        if (floor < site.floors.size()) std::erase_if(site.floors[floor].plans, is_it);
    });
    std::erase_if(images_, [&](const auto& known) { return is_it(known.first); });
    settle();
}

void SiteModel::giveImage(const SitePlan& plan, PlanImage image) {
    std::erase_if(images_, [&](const auto& known) { return sameImage(known.first, plan); });
    images_.emplace_back(plan, std::move(image));
    emit changed();
}

void SiteModel::edit(Site next) {
    history_.add(std::move(next));
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

void SiteModel::showFloor(std::size_t floor) {
    if (floor == floor_ || floor >= site().floors.size()) return;
    floor_ = floor;
    emit changed();
    emit floorShown(floor);
}

void SiteModel::moveRobot(std::size_t floor) {
    if (floor >= site().floors.size()) return;
    const bool moved = std::exchange(robot_floor_, floor) != floor;
    const bool looked_elsewhere = std::exchange(floor_, floor) != floor;
    emit changed();
    if (looked_elsewhere) emit floorShown(floor);
    if (moved) emit robotMoved(floor);
}

void SiteModel::turnToRobotOn(std::size_t floor) {
    if (floor >= site().floors.size()) return;
    robot_floor_ = floor;
    emit changed();
}

void SiteModel::removeFloor(std::size_t floor) {
    Site next = history_.now();
    if (floor >= next.floors.size() || next.floors.size() == 1) return;
    next.floors.erase(next.floors.begin() + static_cast<std::ptrdiff_t>(floor));
    if (floor_ > floor) --floor_;
    if (robot_floor_ > floor) --robot_floor_;
    edit(std::move(next));
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
    const std::size_t highest = site().floors.size() - 1;
    if (robot_floor_ > highest) moveRobot(highest);
    if (floor_ > highest) showFloor(robot_floor_);
    emit kept(site());
    emit changed();
}

}  // namespace hedr
