#include "ui/site/tie_page.h"

#include <cmath>
#include <utility>

#include "core/geometry/angle.h"
#include "core/site/geo_text.h"
#include "ui/error_text.h"
#include "ui/map/qt_geometry.h"
#include "ui/site/map_marks.h"
#include "ui/site/tie_card.h"

namespace hedr {
namespace {

std::optional<double> bearingFromText(QString text) {
    text.remove(QChar(u'°')).replace(QChar(u'−'), QChar(u'-')).replace(QChar(u','), QChar(u'.'));
    bool ok = false;
    const double bearing_deg = text.trimmed().toDouble(&ok);
    if (!ok || !(std::abs(bearing_deg) <= 360.0)) return std::nullopt;
    return radFromDeg(bearing_deg);
}

}  // namespace

TiePage::TiePage(SiteModel& site, QWidget* map)
    : DeskPage(map), site_(site), card_(new TieCard(map)) {
    connect(card_, &TieCard::placeTyped, this, &TiePage::takePlace);
    connect(card_, &TieCard::bearingTyped, this, &TiePage::takeBearing);
    connect(card_, &TieCard::removeWished, this, [this](std::size_t place) {
        TieDraft next = history_.now();
        next.places.erase(next.places.begin() + static_cast<std::ptrdiff_t>(place));
        step(std::move(next));
    });
    connect(card_, &TieCard::untieWished, this, [this] { step({}); });
}

QString TiePage::title() const { return tr("Tie to the globe"); }

QString TiePage::hint() const {
    if (history_.now().places.size() == TieDraft::kMostPlaces) return tr("Drag a mark to move it.");
    return history_.now().places.empty()
               ? tr("Click a place on the map of which you know latitude and longitude.")
               : tr("Click a second place, or type the bearing. Drag a mark to move it.");
}

Card* TiePage::card() { return card_; }

void TiePage::begin() {
    history_ = History<TieDraft>(draftOf(site_.site().geo_tie));
    held_.reset();
    dragged_.reset();
    trouble_.clear();
    show();
}

void TiePage::takePlace(std::size_t place, const QString& text) {
    TieDraft next = history_.now();
    if (place >= next.places.size()) return;
    if (text.trimmed().isEmpty()) {
        next.places[place].at.reset();
        return step(std::move(next));
    }
    const auto at = latLonFromText(text.toStdString());
    if (!at) {
        trouble_ = tr("%1 is no place on the globe: type latitude and longitude, as in "
                      "52.2197, 21.0122.")
                       .arg(text.left(40));
        return show();
    }
    next.places[place].at = *at;
    step(std::move(next));
}

void TiePage::takeBearing(const QString& text) {
    const auto bearing_rad = bearingFromText(text);
    if (!bearing_rad) {
        trouble_ =
            tr("%1 is no bearing: type degrees clockwise from north, 0 to 360.").arg(text.left(40));
        return show();
    }
    TieDraft next = history_.now();
    next.bearing_of_y_rad = *bearing_rad;
    step(std::move(next));
}

void TiePage::step(TieDraft next) {
    trouble_.clear();
    if (next != history_.now()) history_.add(std::move(next));
    show();
}

TieDraft TiePage::draft() const {
    TieDraft draft = history_.now();
    if (held_ && dragged_) draft.places.at(*held_).world = *dragged_;
    return draft;
}

void TiePage::show() {
    const TieDraft shown = draft();
    card_->show(shown, tieOf(shown), trouble_);
    emit changed();
}

void TiePage::undo() {
    trouble_.clear();
    history_.undo();
    show();
}

void TiePage::cancel() { emit finished(); }

void TiePage::accept() {
    if (history_.canUndo()) {
        Site site = site_.site();
        site.geo_tie = tieOf(history_.now()).tie;
        site_.edit(std::move(site));
    }
    emit finished();
}

bool TiePage::press(Point<View> at, const ViewTransform& view) {
    held_.reset();
    double nearest_px = kMarkReach_px;
    const auto& places = history_.now().places;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const double away_px = (view.viewFromWorld() * places[i].world - at).length();
        if (away_px > nearest_px) continue;
        nearest_px = away_px;
        held_ = i;
    }
    return held_.has_value();
}

void TiePage::move(Point<View> at, const ViewTransform& view) {
    if (!held_) return;
    dragged_ = view.worldFromView() * at;
    show();
}

void TiePage::release(Point<View>, const ViewTransform&) {
    TieDraft next = draft();
    held_.reset();
    dragged_.reset();
    step(std::move(next));
}

void TiePage::click(Point<View> at, const ViewTransform& view) {
    TieDraft next = history_.now();
    if (next.places.size() == TieDraft::kMostPlaces) return;
    next.places.push_back({view.worldFromView() * at, std::nullopt});
    step(std::move(next));
}

void TiePage::paint(QPainter& painter, const ViewTransform& view, const Theme& theme) const {
    const TieDraft shown = draft();
    for (std::size_t i = 0; i < shown.places.size(); ++i) {
        drawNumber(painter, toQt(view.viewFromWorld() * shown.places[i].world), i + 1, theme.accent,
                   theme);
    }
}

}  // namespace hedr
