#include "ui/site/align_page.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/site/placement_moves.h"
#include "ui/error_text.h"
#include "ui/map/map_view.h"
#include "ui/site/align_card.h"
#include "ui/site/choices_panel.h"
#include "ui/site/distance_panel.h"
#include "ui/site/move_panel.h"
#include "ui/site/points_panel.h"

namespace hedr {

AlignPage::AlignPage(SiteModel& site, MapView& map)
    : DeskPage(&map), site_(site), map_(map), card_(new AlignCard(&map)) {
    connectCard();
}

void AlignPage::connectCard() {
    connect(card_, &AlignCard::methodChosen, this, &AlignPage::setMethod);
    connect(card_, &AlignCard::straightenWished, this, [this] { emit straightenWished(plan_); });
    connect(&card_->points(), &PointsPanel::removeWished, this, [this](std::size_t point) {
        step(withoutPoint(alignment(), point, size().height_px));
    });
    connect(&card_->points(), &PointsPanel::locksChanged, this, &AlignPage::setLocks);
    connect(&card_->points(), &PointsPanel::placeTyped, this, [this](const QString& text) {
        take(withTypedPlace(alignment(), text.toStdString(), site_.site().geo_tie,
                            size().height_px));
    });
    connect(&card_->points(), &PointsPanel::fileWished, this, &AlignPage::pointsFileWished);
    connect(&card_->distance(), &DistancePanel::distanceGiven, this, &AlignPage::give);
    connect(&card_->choices(), &ChoicesPanel::chosen, this, [this](std::size_t choice) {
        Alignment next = alignment();
        next.placement = proposals_.placements.at(choice);
        step(std::move(next));
    });
    connect(&proposing_, &BackgroundJob::progressed, &card_->choices(), [this](double share) {
        if (proposing_.running()) card_->choices().setProgress(share);
    });
    connect(&card_->hand(), &MovePanel::turnWished, this, [this](double angle_rad) {
        Alignment next = alignment();
        next.placement = turnedAbout(next.placement, middle(), angle_rad);
        step(std::move(next));
    });
}

void AlignPage::choose(std::size_t plan) { plan_ = plan; }

void AlignPage::begin() {
    const SitePlan& plan = site_.floor().plans.at(plan_);
    history_ = History<Alignment>({.placement = plan.placement,
                                   .points = plan.placed_by.points,
                                   .keep_scale = plan.placed_by.keep_scale,
                                   .keep_rotation = plan.placed_by.keep_rotation});
    dragged_.reset();
    drag_.reset();
    trouble_.clear();
    setMethod(method_);
}

void AlignPage::setMethod(AlignMethod method) {
    method_ = method;
    card_->setMethod(method);
    propose();
    show();
}

// What takes the program a moment to find, for the methods that choose from it.
void AlignPage::propose() {
    proposing_.cancel();
    proposals_ = {};
    if (method_ != AlignMethod::kTurn && method_ != AlignMethod::kTrail) return;
    const SitePlan& plan = site_.floor().plans.at(plan_);
    ProposalBasis basis{.plan = {*site_.image(plan), 1.0, plan.inverted_at_night, plan.crop},
                        .trails = map_.sceneOf({}, site_.floorIndex()),
                        .wall_strokes = site_.floor().wall_strokes,
                        .direction_rad = site_.site().direction_rad.value_or(0.0),
                        .device_ratio = map_.devicePixelRatioF()};
    basis.plan.image.placement = alignment().placement;
    // The other trails would only make the pictures small. Where the robot has left the floor, the
    // last one that it drove there counts.
    auto& trails = basis.trails.trails;
    const auto& earlier = basis.trails.earlier;
    if (trails.empty() && !earlier.empty()) trails.push_back(earlier.back());
    if (trails.size() > 1) trails.erase(trails.begin(), trails.end() - 1);
    card_->choices().setProgress(0.0);
    const auto search = method_ == AlignMethod::kTurn ? &proposeTurns : &proposeByTrail;
    proposing_.start([basis = std::move(basis),
                      search](const PlanProgress& progress) { return search(basis, progress); },
                     [this](Result<PlacementProposals> found) { showProposals(std::move(found)); });
}

void AlignPage::showProposals(Result<PlacementProposals> found) {
    if (!found) found = PlacementProposals{.verdict = errorText(found.error())};
    proposals_ = *std::move(found);
    card_->choices().setFound(proposals_.verdict, proposals_.choices);
    show();
}

void AlignPage::setLocks(bool keep_scale, bool keep_rotation) {
    Alignment next = alignment();
    next.keep_scale = keep_scale;
    next.keep_rotation = keep_rotation;
    step(fitted(std::move(next), size().height_px));
}

void AlignPage::give(double distance_m) {
    take(withDistance(alignment(), distance_m, size().height_px));
}

void AlignPage::takePointsOf(const QString& file) {
    take(withPointsOf(file.toStdString(), alignment(), site_.site().geo_tie, size().height_px));
}

void AlignPage::take(Result<Alignment> next) {
    if (next) return step(*std::move(next));
    trouble_ = next.error().code == ErrorCode::kNoData
                   ? tr("That is a place on the globe, and the map is not tied to it yet: "
                        "leave this page and press G first.")
                   : errorText(next.error());
    show();
}

void AlignPage::step(Alignment next) {
    dragged_.reset();
    trouble_.clear();
    history_.add(std::move(next));
    show();
}

void AlignPage::show() {
    fit_ = fitOf(alignment(), size().height_px);
    card_->points().show(alignment(), fit_, trouble_);
    card_->distance().show(alignment());
    card_->hand().show(alignment().placement);
    const auto chosen = std::ranges::find(proposals_.placements, alignment().placement);
    const auto choice = static_cast<std::size_t>(chosen - proposals_.placements.begin());
    card_->choices().setChosen(choice);
    card_->offerStraightening(!canUndo());  // it comes first, or not at all
    site_.preview(aligned());
    emit changed();
}

Site AlignPage::aligned() const {
    Site site = site_.site();
    SitePlan& plan = site.floors.at(site_.floorIndex()).plans.at(plan_);
    const double turn_rad =
        alignment().placement.origin.heading_rad - plan.placement.origin.heading_rad;
    if (plan.tells_direction && site.direction_rad) *site.direction_rad += turn_rad;
    plan.placement = alignment().placement;
    plan.placed_by = placingPointsOf(alignment(), size().height_px);
    plan.sha256.clear();  // it is aligned as the image is now
    return site;
}

QString AlignPage::title() const {
    const auto& file = site_.floor().plans.at(plan_).image_file;
    return tr("Align %1").arg(QString::fromStdString(file.filename().string()));
}

QString AlignPage::hint() const {
    if (method_ == AlignMethod::kPoints && alignment().waiting) {
        return tr("Now click where point %1 is on the map.").arg(alignment().points.size() + 1);
    }
    for (const AlignMethodEntry& entry : alignMethods()) {
        if (entry.method == method_) return entry.hint;
    }
    return {};
}

Card* AlignPage::card() { return card_; }

void AlignPage::undo() {
    trouble_.clear();
    history_.undo();
    show();
}

void AlignPage::cancel() {
    proposing_.cancel();
    site_.dropPreview();
    emit finished();
}

void AlignPage::accept() {
    proposing_.cancel();
    if (history_.canUndo()) {
        site_.warn(site_.floor().plans.at(plan_), {});
        site_.edit(aligned());
    } else {
        site_.dropPreview();
    }
    emit finished();
}

const PlanLevel& AlignPage::size() const {
    const PlanImage* image = site_.image(site_.floor().plans.at(plan_));
    Q_ASSERT(image);
    return image->levels.front();
}

Point<World> AlignPage::middle() const {
    return worldFromPlan(alignment().placement, size().height_px) *
           Point<Plan>{size().width_px / 2.0, size().height_px / 2.0};
}

bool AlignPage::holds(Point<World> at) const {
    const Point<Plan> p = worldFromPlan(alignment().placement, size().height_px).inverse() * at;
    return p.x >= 0.0 && p.y >= 0.0 && p.x <= size().width_px && p.y <= size().height_px;
}

bool AlignPage::nudge(Vector<View> by) {
    if (method_ != AlignMethod::kMove) return false;
    const auto world_from_view = map_.view().worldFromView();
    Alignment next = alignment();
    next.placement = movedBy(
        next.placement, world_from_view * (Point<View>{} + by) - world_from_view * Point<View>{});
    step(std::move(next));
    return true;
}

bool AlignPage::press(Point<View> at, const ViewTransform& view) {
    const Point<World> from = view.worldFromView() * at;
    if (method_ == AlignMethod::kPoints) {
        if (const auto handle = pointHandleAt(marks(), view, at)) drag_ = Drag{handle, from};
    } else if (method_ == AlignMethod::kDistance) {
        if (const auto handle = rulerHandleAt(marks(), view, at)) drag_ = Drag{handle, from};
    } else if (method_ == AlignMethod::kMove) {
        const auto handle = frameHandleAt(planFrame(size(), alignment().placement, view), at);
        if (handle || holds(from)) drag_ = Drag{handle, from};
    }
    return drag_.has_value();
}

void AlignPage::move(Point<View> at, const ViewTransform& view) {
    if (!drag_) return;
    dragged_ = dragged(view.worldFromView() * at);
    show();
}

void AlignPage::release(Point<View>, const ViewTransform&) {
    drag_.reset();
    if (dragged_) step(*dragged_);
}

void AlignPage::click(Point<View> at, const ViewTransform& view) {
    const Point<World> place = view.worldFromView() * at;
    if (method_ == AlignMethod::kPoints) {
        step(withClick(alignment(), place, size().height_px));
    } else if (method_ == AlignMethod::kDistance) {
        step(withRulerClick(alignment(), place, size().height_px));
    }
}

// What the alignment is after the handle has come to `to`, from what it was before the drag.
Alignment AlignPage::dragged(Point<World> to) const {
    Alignment next = history_.now();
    const Point<Plan> on_plan = worldFromPlan(next.placement, size().height_px).inverse() * to;
    if (!drag_->handle) {
        next.placement = movedBy(next.placement, to - drag_->from);
        return next;
    }
    const Point<World> fixed = worldFromPlan(next.placement, size().height_px) *
                               Point<Plan>{size().width_px / 2.0, size().height_px / 2.0};
    const Vector<World> was = drag_->from - fixed;
    const Vector<World> is = to - fixed;
    switch (drag_->handle->handle) {
        case Handle::kMapEnd:
            next.points[drag_->handle->index].world = to;
            return fitted(std::move(next), size().height_px);
        case Handle::kPlanEnd:
            next.points[drag_->handle->index].plan = on_plan;
            return fitted(std::move(next), size().height_px);
        case Handle::kRuler:
            next.ruler[drag_->handle->index] = on_plan;
            next.distance_m.reset();
            break;
        case Handle::kCorner:
            next.placement = scaledAbout(
                next.placement, fixed, std::max(0.01, is.length() / std::max(1e-9, was.length())));
            break;
        case Handle::kTurn:
            next.placement = turnedAbout(next.placement, fixed,
                                         std::atan2(is.y, is.x) - std::atan2(was.y, was.x));
            break;
    }
    return next;
}

void AlignPage::paint(QPainter& painter, const ViewTransform& view, const Theme& theme) const {
    if (method_ == AlignMethod::kPoints) drawPoints(painter, marks(), view, theme);
    if (method_ == AlignMethod::kDistance) drawRuler(painter, marks(), view, theme);
    if (method_ == AlignMethod::kMove) {
        drawFrame(painter, planFrame(size(), alignment().placement, view), theme);
    }
}

}  // namespace hedr
