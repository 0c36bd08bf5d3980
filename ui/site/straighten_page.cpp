#include "ui/site/straighten_page.h"

#include <cmath>
#include <utility>

#include "core/site/survey/quad_proposal.h"
#include "core/site/survey/rectified_placement.h"
#include "core/site/survey/rectified_plan.h"
#include "ui/error_text.h"
#include "ui/map/qt_geometry.h"
#include "ui/site/flat_preview.h"
#include "ui/site/straighten_card.h"
#include "ui/site/straighten_marks.h"

namespace hedr {
namespace {

SitePlan asPhoto(SitePlan plan) {
    plan.straightened.reset();
    plan.crop.reset();  // a crop of the one means nothing in the other
    plan.placed_by = {};
    return plan;
}

// What the operator begins with where nothing is proposed.
Quad quadWithin(const PlanLevel& photo) {
    constexpr double kMargin = 0.1;
    const double left = kMargin * photo.width_px;
    const double top = kMargin * photo.height_px;
    const double right = photo.width_px - left;
    const double bottom = photo.height_px - top;
    return {{{{left, top}, {right, top}, {right, bottom}, {left, bottom}}}};
}

}  // namespace

StraightenPage::StraightenPage(SiteModel& site, QWidget* map)
    : DeskPage(map), site_(site), card_(new StraightenCard(map)) {
    connect(card_, &StraightenCard::sidesChosen, this, &StraightenPage::chooseSides);
    connect(card_, &StraightenCard::photoWished, this,
            [this] { finish(std::nullopt, photo_.placement); });
    connect(&card_->preview(), &FlatPreview::resized, this, &StraightenPage::showFlat);
    connect(&flattening_, &BackgroundJob::progressed, card_, [this](double share) {
        if (flattening_.running()) card_->setProgress(share);
    });
}

bool StraightenPage::choose(std::size_t plan) {
    if (!site_.wholeImage(asPhoto(site_.floor().plans.at(plan)))) return false;
    plan_ = plan;
    return true;
}

void StraightenPage::begin() {
    const SitePlan plan = site_.floor().plans.at(plan_);
    photo_ = *site_.image(asPhoto(plan));
    photo_.placement = plan.placement;
    inverted_at_night_ = plan.inverted_at_night;
    const PlanLevel& size = photo_.levels.front();
    history_ = History<Straightening>(plan.straightened.value_or(Straightening{quadWithin(size)}));
    dragged_.reset();
    drag_.reset();
    error_.reset();
    of_sheet_ = false;
    corners_ = plan.straightened ? Corners::kGiven : Corners::kSought;
    const Result<Rectification> before = rectificationOf(history_.now());
    if (plan.straightened && before) {
        photo_.placement =
            photoPlacement(plan.placement, size.height_px, plan.straightened->quad, *before);
    }
    card_->preview().setInvertedAtNight(inverted_at_night_);
    card_->setStraightenedBefore(plan.straightened.has_value());
    card_->setProgress(std::nullopt);
    if (!plan.straightened) propose();
    showPhoto();
    show();
}

// Corners that the operator has set meanwhile stay.
void StraightenPage::propose() {
    seeking_.start(
        [photo = photo_.levels.front()](const PlanProgress&) { return proposeQuad(photo); },
        [this](const std::optional<QuadProposal>& proposal) {
            if (corners_ != Corners::kSought) return;
            corners_ = proposal ? Corners::kGiven : Corners::kNotFound;
            if (proposal) history_ = History<Straightening>({proposal->quad});
            of_sheet_ = proposal && proposal->kind == QuadKind::kSheet;
            show();
        });
}

// By the perspective, whatever format was chosen.
std::optional<SheetAspect> StraightenPage::seenAspect() const {
    Straightening by_photo = straightening();
    by_photo.aspect.reset();
    const Result<Rectification> seen = rectificationOf(by_photo);
    return seen ? std::optional(seen->aspect) : std::nullopt;
}

void StraightenPage::chooseSides(std::optional<double> longer_by_shorter) {
    Straightening next = straightening();
    next.aspect.reset();
    const auto seen = seenAspect();
    const bool upright = seen && seen->value < 1.0;
    if (longer_by_shorter) next.aspect = upright ? 1.0 / *longer_by_shorter : *longer_by_shorter;
    step(next);
}

void StraightenPage::step(Straightening next) {
    dragged_.reset();
    error_.reset();
    corners_ = Corners::kGiven;
    history_.add(std::move(next));
    showPhoto();  // another plan may have come meanwhile
    show();
}

// Alone, so that nothing hides a corner.
void StraightenPage::showPhoto() {
    Site site = site_.site();
    std::vector<SitePlan>& plans = site.floors.at(site_.floorIndex()).plans;
    for (SitePlan& plan : plans) plan.visible = false;
    SitePlan& photo = plans.at(plan_);
    photo = asPhoto(photo);
    photo.placement = photo_.placement;
    photo.visible = true;
    photo.opacity = 1.0;
    site_.preview(std::move(site));
}

void StraightenPage::showFlat() {
    if (photo_.levels.empty()) return;  // nothing is chosen yet
    if (rectification_) {
        card_->preview().show(photo_.levels, *rectification_, straightening().quad);
    } else {
        card_->preview().clear();
    }
}

void StraightenPage::show() {
    rectification_ = rectificationOf(straightening());
    showFlat();
    card_->setVerdict(verdict());
    card_->setSides(straightening().aspect, seenAspect());
    emit changed();
}

QString StraightenPage::verdict() const {
    if (error_) return errorText(*error_);
    if (flattening_.running()) return tr("Making it flat…");
    if (!rectification_) {
        return tr("These corners will not do: %1.")
            .arg(QString::fromStdString(rectification_.error().detail));
    }
    const SheetAspect& aspect = rectification_->aspect;
    const double longer = std::max(aspect.value, 1.0 / aspect.value);
    constexpr double kVague = 0.03;
    if (aspect.sigma > kVague) {
        return tr("Its sides are about %1 : 1. Choose them below if you know them.")
            .arg(longer, 0, 'f', 1);
    }
    return tr("Its sides are %1 : 1.").arg(longer, 0, 'f', 2);
}

QString StraightenPage::title() const {
    return tr("Straighten %1").arg(QString::fromStdString(photo_.image_file.filename().string()));
}

QString StraightenPage::hint() const {
    switch (corners_) {
        case Corners::kSought:
            return tr("Looking for the plan's corners…");
        case Corners::kNotFound:
            return tr(
                "No outline was found. Drag the handles to four corners of a rectangle: of "
                "the sheet, or of the building.");
        case Corners::kGiven:
            break;
    }
    return tr("Drag the handles to four corners of a rectangle: of the sheet, or of the building.");
}

Card* StraightenPage::card() { return card_; }

bool StraightenPage::canAccept() const {
    return corners_ == Corners::kGiven && rectification_ && !flattening_.running();
}

void StraightenPage::undo() {
    if (!canUndo()) return;
    history_.undo();
    error_.reset();
    show();
}

void StraightenPage::cancel() {
    flattening_.cancel();
    seeking_.cancel();
    site_.dropPreview();
    emit finished();
}

void StraightenPage::accept() {
    if (!canAccept()) return;
    flattening_.start(
        [photo = photo_, how = straightening()](const PlanProgress& progress) {
            return rectifiedPlan(photo, how, progress);
        },
        [this, straightened = straightening()](Result<PlanImage> flat) {
            if (!flat) {
                error_ = flat.error();
                card_->setProgress(std::nullopt);
                return show();
            }
            const PlanPlacement placement = flat->placement;
            SitePlan plan = asPhoto(site_.floor().plans.at(plan_));
            plan.straightened = straightened;
            site_.giveImage(plan, *std::move(flat));
            finish(straightened, placement);
        });
    card_->setProgress(0.0);
    show();
}

void StraightenPage::finish(std::optional<Straightening> straightened,
                            const PlanPlacement& placement) {
    seeking_.cancel();
    site_.dropPreview();
    Site site = site_.site();
    SitePlan& plan = site.floors.at(site_.floorIndex()).plans.at(plan_);
    plan = asPhoto(plan);
    plan.straightened = straightened;
    plan.placement = placement;
    if (straightened && of_sheet_ && rectification_) plan.crop = sheetOf(*rectification_);
    site_.edit(std::move(site));
    emit finished();
}

PlanCrop StraightenPage::sheetOf(const Rectification& flat) const {
    const auto& corners = straightening().quad.corners;
    const Point<Flat> first = flat.flat_from_photo * corners[0];
    const Point<Flat> opposite = flat.flat_from_photo * corners[2];
    return {{first.x, first.y}, {opposite.x, opposite.y}};
}

Result<Rectification> StraightenPage::rectificationOf(const Straightening& straightening) const {
    const PlanLevel& size = photo_.levels.front();
    return hedr::rectificationOf(size.width_px, size.height_px, straightening.quad,
                                 straightening.aspect, photo_.focal_length);
}

Transform<View, Plan> StraightenPage::viewFromPhoto(const ViewTransform& view) const {
    return view.viewFromWorld() * photo_.worldFromPlan();
}

Straightening StraightenPage::withCorner(std::size_t corner, Point<View> at,
                                         const ViewTransform& view) const {
    Straightening next = history_.now();
    next.quad.corners.at(corner) = viewFromPhoto(view).inverse() * at;
    return next;
}

bool StraightenPage::press(Point<View> at, const ViewTransform& view) {
    const ViewCorners corners = viewCorners(straightening().quad, viewFromPhoto(view));
    const auto corner = cornerAt(corners, at);
    if (!corner || flattening_.running()) return false;
    drag_ = Drag{*corner, corners[*corner] - at};
    return true;
}

void StraightenPage::move(Point<View> at, const ViewTransform& view) {
    if (!drag_) return;
    dragged_ = withCorner(drag_->corner, at + drag_->off, view);
    corners_ = Corners::kGiven;
    show();
}

void StraightenPage::release(Point<View>, const ViewTransform&) {
    drag_.reset();
    if (dragged_) step(*dragged_);
}

void StraightenPage::click(Point<View> at, const ViewTransform& view) {
    if (flattening_.running()) return;
    const ViewCorners corners = viewCorners(straightening().quad, viewFromPhoto(view));
    step(withCorner(nearestCorner(corners, at), at, view));
}

void StraightenPage::paint(QPainter& painter, const ViewTransform& view, const Theme& theme) const {
    const ViewCorners corners = viewCorners(straightening().quad, viewFromPhoto(view));
    const QColor colour = rectification_ ? theme.accent : theme.alarm;
    drawCorners(painter, corners, colour, theme);
    if (!drag_) return;
    const Theme photo_theme = inverted_at_night_ ? theme : dayTheme();
    drawLoupe(painter, {photo_, photo_theme, corners, drag_->corner, colour}, view, theme);
}

}  // namespace hedr
