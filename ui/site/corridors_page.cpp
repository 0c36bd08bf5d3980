#include "ui/site/corridors_page.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/geometry/angle.h"
#include "core/site/plan_cropping.h"
#include "ui/error_text.h"
#include "ui/map/qt_geometry.h"
#include "ui/site/corridors_card.h"
#include "ui/site/map_marks.h"

namespace hedr {
namespace {

constexpr double kShortestLine_px = 12.0;

// 1, 2, 5, 10 … metres, so that the lines are at least this far apart on the screen.
double spacing_m(double pixels_per_metre) {
    constexpr double kLeast_px = 90.0;
    const double least_m = kLeast_px / pixels_per_metre;
    const double decade = std::pow(10.0, std::floor(std::log10(least_m)));
    for (const double step : {1.0, 2.0, 5.0}) {
        if (step * decade >= least_m) return step * decade;
    }
    return 10.0 * decade;
}

// All over the view, at right angles too, as corridors run.
void drawGrid(QPainter& painter, double direction_rad, const ViewTransform& view,
              const QColor& colour) {
    const double apart_m = spacing_m(view.pixels_per_metre);
    const double reach_m = 0.5 * std::hypot(view.width_px, view.height_px) / view.pixels_per_metre;
    const Vector<World> centre = view.centre - Point<World>{};
    painter.setPen(QPen(colour, 1.5, Qt::DashLine));
    for (const double angle_rad : {direction_rad, direction_rad + 0.5 * kPi}) {
        const Vector<World> along{std::cos(angle_rad), std::sin(angle_rad)};
        const Vector<World> across{-along.y, along.x};
        const double middle_m = along.x * centre.x + along.y * centre.y;
        const double beside_m = across.x * centre.x + across.y * centre.y;
        const double last = std::floor((beside_m + reach_m) / apart_m);
        for (double k = std::ceil((beside_m - reach_m) / apart_m); k <= last; k += 1.0) {
            const Point<World> on_line = Point<World>{} + k * apart_m * across + middle_m * along;
            painter.drawLine(toQt(view.viewFromWorld() * (on_line + (-reach_m) * along)),
                             toQt(view.viewFromWorld() * (on_line + reach_m * along)));
        }
    }
}

}  // namespace

CorridorsPage::CorridorsPage(SiteModel& site, QWidget* map)
    : DeskPage(map), site_(site), card_(new CorridorsCard(map)) {
    connect(card_, &CorridorsCard::planWished, this, &CorridorsPage::look);
    connect(card_, &CorridorsCard::noneWished, this, [this] { step({}); });
    connect(&looking_, &BackgroundJob::progressed, card_, [this](double share) {
        if (looking_.running()) card_->setProgress(share);
    });
}

QString CorridorsPage::title() const { return tr("Corridors"); }

QString CorridorsPage::hint() const {
    return tr("HEDR keeps the heading to these lines. Drag along a corridor to turn them.");
}

Card* CorridorsPage::card() { return card_; }

const SitePlan* CorridorsPage::plan() const {
    const auto& plans = site_.floor().plans;
    const auto seen = std::find_if(plans.rbegin(), plans.rend(), [this](const SitePlan& plan) {
        return plan.visible && site_.image(plan);
    });
    return seen == plans.rend() ? nullptr : &*seen;
}

void CorridorsPage::begin() {
    const SitePlan* seen = plan();
    history_ = History<Told>({site_.site().direction_rad, seen && seen->tells_direction, 1.0});
    line_.reset();
    trouble_.clear();
    card_->offerPlan(seen != nullptr);
    show();
    if (seen && !site_.site().direction_rad) look();
}

void CorridorsPage::look() {
    const SitePlan* seen = plan();
    if (!seen) return;
    card_->setProgress(0.0);
    looking_.start(
        [image = *site_.image(*seen), crop = seen->crop](const PlanProgress& progress) {
            return shownPlan(image, crop).and_then([&](const PlanImage& shown) {
                return findDirections(shown, progress);
            });
        },
        [this](const Result<PlanDirections>& found) { showFound(found); });
    show();
}

void CorridorsPage::showFound(const Result<PlanDirections>& found) {
    card_->setProgress(std::nullopt);
    trouble_.clear();
    const SitePlan* seen = plan();
    if (!found) {
        trouble_ = errorText(found.error());
    } else if (!found->direction_rad) {
        trouble_ =
            tr("This plan has no dominant direction: its lines run every way. Drag along a "
               "corridor, or tell none.");
    } else if (seen) {
        return step(
            {*found->direction_rad + seen->placement.origin.heading_rad, true, found->confidence});
    }
    show();
}

void CorridorsPage::step(const Told& told) {
    looking_.cancel();
    card_->setProgress(std::nullopt);
    trouble_.clear();
    history_.add(told);
    show();
}

void CorridorsPage::show() {
    card_->show(direction_rad(), advice());
    emit changed();
}

std::optional<double> CorridorsPage::direction_rad() const {
    if (!line_) return history_.now().direction_rad;
    const Vector<World> drawn = line_->to - line_->from;
    return std::atan2(drawn.y, drawn.x);
}

QString CorridorsPage::advice() const {
    if (looking_.running()) return tr("Looking for the direction of the plan's walls…");
    if (!trouble_.isEmpty()) return trouble_;
    const Told& told = history_.now();
    if (line_ || (told.direction_rad && !told.by_plan)) {
        return tr("As it was drawn. The estimators are told when it is done.");
    }
    if (!told.direction_rad) {
        return tr(
            "The estimators learn the direction while the robot drives, and may take the "
            "start for it.");
    }
    const QString name =
        plan() ? QString::fromStdString(plan()->image_file.filename().string()) : QString();
    return canUndo()
               ? tr("So run the walls of %1 (%2\u00a0% sure). Do they run along its corridors?")
                     .arg(name)
                     .arg(qRound(100.0 * told.confidence))
               : tr("So run the walls of %1. It turns with the plan.").arg(name);
}

void CorridorsPage::undo() {
    looking_.cancel();
    card_->setProgress(std::nullopt);
    history_.undo();
    show();
}

void CorridorsPage::cancel() {
    looking_.cancel();
    card_->setProgress(std::nullopt);
    emit finished();
}

void CorridorsPage::accept() {
    const Told told = history_.now();
    const SitePlan* by = told.by_plan ? plan() : nullptr;
    const auto at = by ? by - site_.floor().plans.data() : 0;
    looking_.cancel();
    card_->setProgress(std::nullopt);
    if (history_.canUndo()) {
        Site site = site_.site();
        site.direction_rad = told.direction_rad;
        for (SiteFloor& floor : site.floors) {
            for (SitePlan& plan : floor.plans) plan.tells_direction = false;
        }
        auto& plans = site.floors.at(site_.floorIndex()).plans;
        if (by) plans.at(static_cast<std::size_t>(at)).tells_direction = true;
        site_.edit(std::move(site));
    }
    emit finished();
}

bool CorridorsPage::press(Point<View> at, const ViewTransform& view) {
    const Point<World> from = view.worldFromView() * at;
    line_ = DrawnLine{from, from};
    return true;
}

void CorridorsPage::move(Point<View> at, const ViewTransform& view) {
    if (!line_) return;
    line_->to = view.worldFromView() * at;
    show();
}

void CorridorsPage::release(Point<View>, const ViewTransform& view) {
    const auto drawn = std::exchange(line_, std::nullopt);
    if (!drawn) return;
    const Vector<World> way = drawn->to - drawn->from;
    if (way.length() * view.pixels_per_metre < kShortestLine_px) return show();
    step({std::atan2(way.y, way.x), false, 0.0});
}

void CorridorsPage::click(Point<View>, const ViewTransform&) {}  // a press takes it

void CorridorsPage::paint(QPainter& painter, const ViewTransform& view, const Theme& theme) const {
    constexpr int kOpacity = 170;  // the plan must be seen through it
    QColor colour = theme.accent;
    colour.setAlpha(kOpacity);
    if (const auto direction = direction_rad()) drawGrid(painter, *direction, view, colour);
    if (!line_) return;
    const auto view_from_world = view.viewFromWorld();
    drawLine(painter, toQt(view_from_world * line_->from), toQt(view_from_world * line_->to),
             theme.accent, theme);
}

}  // namespace hedr
