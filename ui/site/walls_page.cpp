#include "ui/site/walls_page.h"

#include <algorithm>
#include <utility>

#include "core/site/survey/walls.h"
#include "ui/error_text.h"
#include "ui/map/qt_geometry.h"
#include "ui/site/walls_card.h"

namespace hedr {
namespace {

constexpr double kStep_px = 3.0;  // between the points of a stroke

Result<std::vector<WallCells>> cellsOf(const std::vector<MapPlan>& plans,
                                       const PlanProgress& progress) {
    std::vector<WallCells> found;
    for (const MapPlan& plan : plans) {
        const auto count = static_cast<double>(plans.size());
        const auto before = static_cast<double>(found.size());
        auto space = freeSpaceOf(plan.image,
                                 [&](double share) { return progress((before + share) / count); });
        if (!space) return tl::make_unexpected(space.error());
        found.push_back(wallCells(*space, plan));
    }
    return found;
}

// The picture reaches beyond the view, so that panning only shifts it.
constexpr double kMargin_px = 160.0;

// Where the view's first pixel is in a wider one.
Point<View> cornerIn(const ViewTransform& wide, const ViewTransform& view) {
    return wide.viewFromWorld() * (view.worldFromView() * Point<View>{});
}

bool shows(const ViewTransform& wide, const ViewTransform& view) {
    if (wide.pixels_per_metre != view.pixels_per_metre || wide.rotation_rad != view.rotation_rad)
        return false;
    const Point<View> corner = cornerIn(wide, view);
    return corner.x >= 0.0 && corner.y >= 0.0 && corner.x + view.width_px <= wide.width_px &&
           corner.y + view.height_px <= wide.height_px;
}

}  // namespace

WallsPage::WallsPage(SiteModel& site, QWidget* map)
    : DeskPage(map), site_(site), card_(new WallsCard(map)) {
    connect(card_, &WallsCard::penChosen, this, [this] { emit changed(); });
    connect(&looking_, &BackgroundJob::progressed, card_, [this](double share) {
        if (looking_.running()) card_->setProgress(share);
    });
}

void WallsPage::begin() {
    history_ = History<Strokes>(site_.floor().wall_strokes);
    drawn_.reset();
    look();
    show();
}

void WallsPage::look() {
    found_.reset();
    card_->setProgress(0.0);
    looking_.start([plans = site_.mapPlans(site_.floor())](
                       const PlanProgress& progress) { return cellsOf(plans, progress); },
                   [this](Result<std::vector<WallCells>> found) {
                       found_ = std::move(found);
                       card_->setProgress(std::nullopt);
                       show();
                   });
}

void WallsPage::show() {
    picture_.reset();
    card_->setVerdict(verdict());
    emit changed();
}

QString WallsPage::verdict() const {
    if (!found_) return tr("Looking for walls…");
    if (!*found_) return errorText(found_->error());
    if (std::ranges::any_of(**found_, &WallCells::any_walls)) return {};
    return (*found_)->empty() ? tr("There is no plan here: draw the walls.")
                              : tr("No walls are found on the plan: draw them.");
}

QString WallsPage::title() const {
    return tr("Walls of %1").arg(QString::fromStdString(site_.floor().name));
}

QString WallsPage::hint() const {
    return card_->pen() == WallPen::kWall
               ? tr("Drag to draw a wall that the plan lacks. Hold Shift to move the map.")
               : tr("Drag over what is no wall, to make it free. Hold Shift to move the map.");
}

Card* WallsPage::card() { return card_; }

void WallsPage::undo() {
    history_.undo();
    show();
}

void WallsPage::cancel() {
    looking_.cancel();
    emit finished();
}

void WallsPage::accept() {
    looking_.cancel();
    if (history_.canUndo()) {
        Site site = site_.site();
        site.floors.at(site_.floorIndex()).wall_strokes = history_.now();
        site_.edit(std::move(site));
    }
    emit finished();
}

bool WallsPage::press(Point<View> at, const ViewTransform& view) {
    drawn_ = WallStroke{card_->pen(), card_->width_m(), {view.worldFromView() * at}};
    return true;
}

void WallsPage::move(Point<View> at, const ViewTransform& view) {
    if (!drawn_) return;
    const Point<View> last = view.viewFromWorld() * drawn_->points.back();
    if ((at - last).length() >= kStep_px) drawn_->points.push_back(view.worldFromView() * at);
}

void WallsPage::release(Point<View>, const ViewTransform&) {
    if (!drawn_) return;
    Strokes strokes = history_.now();
    strokes.push_back(*std::exchange(drawn_, std::nullopt));
    history_.add(std::move(strokes));
    show();
}

void WallsPage::click(Point<View>, const ViewTransform&) {}  // a press takes it

const WallsPage::Picture& WallsPage::picture(const ViewTransform& view, const Theme& theme,
                                             double device_ratio) const {
    const bool fits = picture_ && picture_->theme == theme.name &&
                      picture_->image.devicePixelRatio() == device_ratio &&
                      shows(picture_->view, view);
    if (fits) return *picture_;
    const ViewTransform wide = view.grown(kMargin_px);
    const bool found = found_ && *found_;
    QImage image =
        wallPicture(found ? **found_ : std::vector<WallCells>{}, wide, theme, device_ratio);
    drawStrokes(image, history_.now(), wide, theme);
    picture_ = Picture{wide, theme.name, std::move(image)};
    return *picture_;
}

void WallsPage::paint(QPainter& painter, const ViewTransform& view, const Theme& theme) const {
    const Picture& wide = picture(view, theme, painter.device()->devicePixelRatioF());
    QImage image = wide.image;
    if (drawn_) drawStrokes(image, {&*drawn_, 1}, wide.view, theme);
    painter.drawImage(-toQt(cornerIn(wide.view, view)), image);
}

}  // namespace hedr
