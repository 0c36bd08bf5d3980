#include "ui/calibration/ends_page.h"

#include <utility>

#include "ui/calibration/ends_card.h"
#include "ui/format.h"
#include "ui/map/qt_geometry.h"
#include "ui/site/map_marks.h"

namespace hedr {
namespace {

constexpr double kCoarsePixel_m = 0.01;  // a tape is that good at least
constexpr double kLeastDrag_px = 4.0;
constexpr double kDotRadius_px = 5.0;
constexpr QPointF kNumberBeside_px{18.0, -18.0};

// The nearest mark within reach of the pointer.
std::optional<std::size_t> markAt(const ClickedEnds& ends, Point<View> at,
                                  const ViewTransform& view) {
    std::optional<std::size_t> found;
    double reach_px = kMarkReach_px;
    for (std::size_t i = 0; i < ends.marks().size(); ++i) {
        if (!ends.marks()[i]) continue;
        const double away_px = (view.viewFromWorld() * *ends.marks()[i] - at).length();
        if (away_px > reach_px) continue;
        reach_px = away_px;
        found = i;
    }
    return found;
}

void drawCross(QPainter& painter, QPointF at, const QColor& colour, const Theme& theme) {
    constexpr double kArm_px = 10.0;
    const QPointF along(kArm_px, 0.0);
    const QPointF across(0.0, kArm_px);
    drawLine(painter, at - along, at + along, colour, theme);
    drawLine(painter, at - across, at + across, colour, theme);
}

}  // namespace

EndsPage::EndsPage(QWidget* map) : DeskPage(map), card_(new EndsCard(map)) {
    connect(card_, &EndsCard::skipWished, this, [this] {
        ClickedEnds next = history_.now();
        next.skipRun();
        step(next);
    });
}

// What was taken earlier can still be taken back step by step.
void EndsPage::choose(const ClickedEnds& earlier) {
    history_ = taken_.now() == earlier ? taken_ : History(earlier);
}

QString EndsPage::title() const { return tr("Ends of the squares"); }

QString EndsPage::hint() const {
    switch (history_.now().next()) {
        case ClickedEnds::Next::kStart:
            return tr("Click the mark where every square starts.");
        case ClickedEnds::Next::kAhead:
            return tr("Click a place straight ahead of it, along the first side; far is good.");
        default:
            return tr("Click where run %1 ended.").arg(history_.now().nextRun());
    }
}

Card* EndsPage::card() { return card_; }

void EndsPage::begin() {
    grabbed_.reset();
    pointer_.reset();
    pixel_m_ = 0.0;
    too_near_ = false;
    show();
}

void EndsPage::undo() {
    history_.undo();
    too_near_ = false;
    show();
}

void EndsPage::cancel() { emit finished(); }

void EndsPage::accept() {
    taken_ = history_;
    emit clicked(history_.now());
    emit finished();
}

void EndsPage::step(const ClickedEnds& next) {
    history_.add(next);
    too_near_ = false;
    show();
}

void EndsPage::show() {
    card_->show(ends(), pointer_, advice());
    emit changed();
}

bool EndsPage::press(Point<View> at, const ViewTransform& view) {
    const auto mark = markAt(history_.now(), at, view);
    if (mark) grabbed_ = Grabbed{.mark = *mark, .from = at, .ends = history_.now()};
    return mark.has_value();
}

void EndsPage::move(Point<View> at, const ViewTransform& view) {
    lookFrom(at, view);
    if (grabbed_) {
        grabbed_->dragged = grabbed_->dragged || (at - grabbed_->from).length() > kLeastDrag_px;
        if (grabbed_->dragged) grabbed_->ends.move(grabbed_->mark, *pointer_);
    }
    show();
}

void EndsPage::release(Point<View> at, const ViewTransform& view) {
    const auto grabbed = std::exchange(grabbed_, std::nullopt);
    if (!grabbed) return;
    grabbed->dragged ? step(grabbed->ends) : click(at, view);
}

void EndsPage::lookFrom(Point<View> at, const ViewTransform& view) {
    pointer_ = view.worldFromView() * at;
    pixel_m_ = 1.0 / view.pixels_per_metre;
}

QString EndsPage::advice() const {
    if (too_near_) {
        return tr(
            "That is less than a metre from the start. A place further away tells the "
            "direction better.");
    }
    if (pixel_m_ <= kCoarsePixel_m) return {};
    return tr("One pixel is %1 here. Zoom in before you click.").arg(formatResolution(pixel_m_));
}

void EndsPage::click(Point<View> at, const ViewTransform& view) {
    ClickedEnds next = history_.now();
    if (next.add(view.worldFromView() * at)) return step(next);
    too_near_ = true;
    show();
}

void EndsPage::paint(QPainter& painter, const ViewTransform& view, const Theme& theme) const {
    const auto& marks = ends().marks();
    const auto at = [&](std::size_t mark) { return toQt(view.viewFromWorld() * *marks[mark]); };
    for (std::size_t i = ClickedEnds::kFirstEnd; i < marks.size(); ++i) {
        if (!marks[i]) continue;
        drawDot(painter, at(i), kDotRadius_px, theme.accent, theme);
        drawNumber(painter, at(i) + kNumberBeside_px, ends().runOf(i), theme.accent, theme);
    }
    if (marks.size() > 1) {
        drawLine(painter, at(0), at(1), theme.dim, theme);
        drawDot(painter, at(1), kDotRadius_px, theme.dim, theme);
    }
    if (!marks.empty()) drawCross(painter, at(0), theme.ink, theme);
}

}  // namespace hedr
