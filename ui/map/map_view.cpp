#include "ui/map/map_view.h"

#include <QMouseEvent>
#include <QWheelEvent>
#include <cmath>
#include <utility>

#include "core/geometry/angle.h"
#include "ui/map/follow.h"
#include "ui/map/plan_layer.h"
#include "ui/map/qt_geometry.h"
#include "ui/style_sheet.h"
#include "ui/trail_style.h"

namespace hedr {
namespace {

constexpr double kCacheMargin_px = 256.0;
constexpr double kCacheSlack_px = 48.0;  // redraw before the edge of the cache comes into sight
constexpr double kZoomPerWheelStep = 1.25;
constexpr int kDragStart_px = 4;

// The middle button, or Shift, moves the map under a tool that takes every drag.
bool pansAnyway(const QMouseEvent& event) {
    return event.button() == Qt::MiddleButton || event.modifiers().testFlag(Qt::ShiftModifier);
}

}  // namespace

MapView::MapView(const Fleet& fleet, QWidget* parent)
    : QWidget(parent), fleet_(fleet), resume_(new QPushButton(tr("Resume following"), this)) {
    setObjectName(QStringLiteral("map"));
    setAccessibleName(tr("Map"));
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setMinimumSize(320, 240);
    resume_->setObjectName(QStringLiteral("resume"));
    resume_->setToolTip(tr("Keep the robot in sight again"));
    resume_->hide();
    connect(resume_, &QPushButton::clicked, this, [this] { setFollowing(true); });
    connect(&keeper_, &BaseKeeper::renewed, this, [this] {
        update();
        keepBaseFresh();
    });
    setTheme(theme_);
}

void MapView::setTheme(const Theme& theme) {
    theme_ = theme;
    resume_->setStyleSheet(primaryButtonSheet(theme));
    keeper_.invalidate();
    keepBaseFresh();
    update();
}

void MapView::setPlans(std::vector<MapPlan> plans) {
    plans_ = std::move(plans);
    keeper_.invalidate();
    keepBaseFresh();
    update();
}

void MapView::setTool(MapTool* tool) {
    tool_ = tool;
    tool_has_press_ = false;
    setMouseTracking(tool_ != nullptr);
    if (tool_) {
        setCursor(tool_->cursor());
    } else {
        unsetCursor();
    }
    update();
}

void MapView::showChosenTrails() {
    keeper_.invalidate();
    keepBaseFresh();
    update();
}

void MapView::setMargins(const ViewMargins& margins) {
    if (margins == margins_) return;
    margins_ = margins;
    placeResumeButton();
    if (fitted_) fit();
    update();
}

void MapView::forgetTrails() {
    keeper_.drop();
    keepBaseFresh();
    update();
}

void MapView::setFloor(std::size_t floor) {
    floor_ = floor;
    forgetTrails();
    placeResumeButton();
}

void MapView::refresh(ReceiveClock::time_point now) {
    now_ = now;
    const LinkVerdict link = model().link(now);
    const bool aged = link.state == LinkState::kStale || link.state == LinkState::kLost;
    if (aged || link.state != link_.state) update();
    link_ = link;
    reach_m_ = aged ? model().reach_m(now) : 0.0;
    nameRobots();
    keepRobotInSight();
    const QRegion moving_parts = movingParts();
    update(moving_parts.united(last_moving_parts_));
    last_moving_parts_ = moving_parts;
    const int needle_deg =
        model().pose() ? qRound(degFromRad(wrapAngle(model().pose()->heading_rad))) : 0;
    if (std::exchange(needle_deg_, needle_deg) != needle_deg) update(dialRect().toAlignedRect());
    takeTailsIn();
    keepBaseFresh();
}

// The longer the tails, the more every frame costs: from time to time the base image takes them in.
void MapView::takeTailsIn() {
    const std::vector<MapTrail> drawn = drawnTrails();
    const std::size_t points = tailPoints();
    if (points < kTailToTakeIn * drawn.size() || points > kTailForNewBase * fleet_.size()) return;
    for (const MapTrail& shown : drawn) keeper_.grow(*shown.trail, penOf(shown), shown.robot->id);
}

// A map that shows everything stays as it is until the robot leaves it.
// The map does not move under a pointer that is at work on it.
void MapView::keepRobotInSight() {
    const auto pose = model().pose();
    if (tool_ || !following_ || !showsRobot() || !pose || view_.width_px <= 0.0) return;
    if (fitted_ && freeRect().contains(toQt(view_.viewFromWorld() * pose->position))) return;
    const ViewTransform next = followed(view_, *pose, margins_);
    if (next == view_) return;
    fitted_ = false;
    setView(next);
}

void MapView::setFollowing(bool following) {
    if (following_ == following) return;
    following_ = following;
    placeResumeButton();
    keepRobotInSight();
    emit followingChanged(following);
}

void MapView::fit() {
    fitted_ = true;
    if (view_.width_px <= 0.0) return;  // it is done when the widget gets its size
    std::optional<WorldBox> box;
    for (const MapPlan& plan : plans_) {
        const WorldBox bounds = planBounds(plan);
        box = box ? united(*box, bounds) : bounds;
    }
    for (const SceneTrail& earlier : earlierTrails(floor_)) {
        const WorldBox bounds = earlier.trail.track.bounds();
        box = box ? united(*box, bounds) : bounds;
    }
    for (const MapTrail& shown : drawnTrails()) {
        if (shown.trail != shown.robot->model.primary()) continue;
        const WorldBox bounds = shown.trail->track.bounds();
        box = box ? united(*box, bounds) : bounds;
    }
    setView(box ? view_.fitted(*box, margins_) : view_);
}

void MapView::zoomBy(double factor) {
    fitted_ = false;
    setView(view_.zoomed(viewPoint(freeRect().center()), factor));
    if (tool_ && underMouse()) tool_->move(viewPoint(mapFromGlobal(QCursor::pos())), view_);
}

void MapView::panBy(Vector<View> content_moves) {
    fitted_ = false;
    setFollowing(false);
    setView(view_.panned(content_moves));
}

bool MapView::isSharp() const { return !keeper_.busy() && baseIsGoodEnough(); }

void MapView::setView(const ViewTransform& view) {
    view_ = view;
    keepBaseFresh();
    update();
}

bool MapView::baseIsGoodEnough() const {
    const BaseImage& base = keeper_.base();
    if (keeper_.outdated() || tailPoints() > kTailForNewBase * fleet_.size()) return false;
    if (base.grown_points > kGrownForNewBase * fleet_.size()) return false;
    if (base.view.pixels_per_metre != view_.pixels_per_metre) return false;
    if (base.view.rotation_rad != view_.rotation_rad) return false;
    const Point<View> corner =
        base.view.viewFromWorld() * (view_.worldFromView() * Point<View>{0.0, 0.0});
    return corner.x >= kCacheSlack_px && corner.y >= kCacheSlack_px &&
           corner.x + view_.width_px <= base.view.width_px - kCacheSlack_px &&
           corner.y + view_.height_px <= base.view.height_px - kCacheSlack_px;
}

void MapView::keepBaseFresh() {
    if (keeper_.busy() || width() < 1 || baseIsGoodEnough()) return;
    keeper_.draw(sceneOf(plans_, floor_), view_.grown(kCacheMargin_px), devicePixelRatioF());
}

QRectF MapView::freeRect() const {
    return QRectF(rect()).adjusted(margins_.left_px, margins_.top_px, -margins_.right_px,
                                   -margins_.bottom_px);
}

QRectF MapView::pointerRect() const { return freeRect().adjusted(24, 24, -24, -24); }

QPointF MapView::dialCentre() const { return {width() - 24.0 - kDialReach_px, height() - 136.0}; }

QRectF MapView::dialRect() const {
    const double reach = kDialReach_px;
    return QRectF(dialCentre(), QSizeF()).adjusted(-reach, -reach, reach, reach);
}

void MapView::placeResumeButton() {
    resume_->setVisible(!following_ && showsRobot());
    resume_->adjustSize();
    const QRectF free = freeRect();
    resume_->move(qRound(free.center().x() - resume_->width() / 2.0),
                  height() - resume_->height() - 24);
}

void MapView::resizeEvent(QResizeEvent* event) {
    view_ = view_.resized(event->size().width(), event->size().height());
    placeResumeButton();
    if (fitted_) fit();
    keepBaseFresh();
}

void MapView::wheelEvent(QWheelEvent* event) {
    const double steps = event->angleDelta().y() / 120.0;
    fitted_ = false;
    setView(view_.zoomed(viewPoint(event->position()), std::pow(kZoomPerWheelStep, steps)));
    if (tool_) tool_->move(viewPoint(event->position()), view_);
    event->accept();
}

void MapView::mousePressEvent(QMouseEvent* event) {
    if (tool_has_press_ || drag_from_) return;  // another button is down
    const bool pans = pansAnyway(*event);
    if (event->button() != Qt::LeftButton && !pans) return;
    tool_has_press_ = !pans && tool_ && tool_->press(viewPoint(event->position()), view_);
    if (tool_has_press_) return update();
    drag_from_ = event->pos();
}

void MapView::mouseMoveEvent(QMouseEvent* event) {
    if (tool_ && !dragging_) {
        tool_->move(viewPoint(event->position()), view_);
        update();
    }
    if (!drag_from_) return;
    const QPoint by = event->pos() - *drag_from_;
    if (!dragging_ && by.manhattanLength() < kDragStart_px) return;
    dragging_ = true;
    drag_from_ = event->pos();
    setCursor(Qt::ClosedHandCursor);
    panBy({static_cast<double>(by.x()), static_cast<double>(by.y())});
}

void MapView::mouseReleaseEvent(QMouseEvent* event) {
    const bool clicked = drag_from_ && !dragging_ && !pansAnyway(*event);
    drag_from_.reset();
    dragging_ = false;
    if (!tool_) {
        const auto robot = clicked ? robotAt(viewPoint(event->position())) : std::nullopt;
        if (robot) emit robotClicked(*robot);
        return unsetCursor();
    }
    setCursor(tool_->cursor());
    if (std::exchange(tool_has_press_, false)) tool_->release(viewPoint(event->position()), view_);
    if (clicked) tool_->click(viewPoint(event->position()), view_);
    update();
}

}  // namespace hedr
