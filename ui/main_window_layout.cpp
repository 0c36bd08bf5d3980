#include <QLayout>
#include <algorithm>

#include "ui/link/link_card.h"
#include "ui/link/robot_card.h"
#include "ui/main_window.h"
#include "ui/map/map_view.h"
#include "ui/panels/banner.h"
#include "ui/panels/choice_note.h"
#include "ui/panels/connect_card.h"
#include "ui/panels/hint.h"
#include "ui/panels/legend.h"
#include "ui/panels/plan_progress_card.h"
#include "ui/panels/rail.h"
#include "ui/panels/robots_card.h"
#include "ui/panels/status_strip.h"
#include "ui/publish/publish_card.h"
#include "ui/site/plan_opener.h"
#include "ui/site/site_desk.h"

// Where things lie in the window; what they do is in main_window.cpp.
namespace hedr {
namespace {

constexpr int kGap_px = 16;
constexpr int kRoomy_px = 1280;  // a narrower map gets the compact legend
constexpr int kLeastNote_px = 360;

// Banners and notes, one below the other beside the cards; where these leave too little room, one
// above the other at the bottom.
class NoteStack {
  public:
    NoteStack(int left, int beside_cards, int right, int height)
        : at_bottom_(right - beside_cards < kLeastNote_px),
          left_(at_bottom_ ? left : beside_cards),
          right_(right),
          y_(at_bottom_ ? height - kGap_px : kGap_px + 4) {}

    int width() const { return right_ - left_; }
    void add(QWidget& note, const QSize& size) {
        if (at_bottom_) y_ -= size.height();
        note.setGeometry({{(left_ + right_ - size.width()) / 2, y_}, size});
        y_ += at_bottom_ ? -kGap_px / 2 : size.height() + kGap_px / 2;
    }

  private:
    bool at_bottom_;
    int left_;
    int right_;
    int y_;
};

}  // namespace

// Cards keep to the sides; what is left between them is the map's free part.
void MainWindow::placeOverlays() {
    const int left = kGap_px + rail_->sizeHint().width() + kGap_px;
    rail_->setGeometry(QRect({kGap_px, kGap_px + 4}, rail_->sizeHint()));
    legend_->setVisible(!desk_->takesRoom() && !model().trails().empty());
    legend_->setCompact(map_->width() < kRoomy_px);
    int legend_top = kGap_px + 4;
    robots_card_->setVisible(!desk_->takesRoom() && fleet_.several());
    robots_card_->setLeastWidth(legend_->isVisibleTo(map_) ? legend_->width() : 0);
    robots_card_->move(map_->width() - robots_card_->width() - kGap_px, legend_top);
    if (robots_card_->isVisibleTo(map_)) legend_top += robots_card_->height() + kGap_px / 2;
    legend_->setMostHeight(qRound(map_->dialRect().top()) - legend_top - kGap_px / 2);
    legend_->move(map_->width() - legend_->width() - kGap_px, legend_top);
    const int desk_px = desk_->placeCards({left, kGap_px + 4, map_->width() - left - kGap_px,
                                           qRound(map_->dialRect().top()) - 2 * kGap_px});
    int content_left = left;
    for (Card* card : sideCards()) {
        card->move(left, kGap_px + 4);
        if (card->isVisibleTo(map_)) content_left = left + card->width() + kGap_px;
    }
    if (Card* card = opener_->openCard()) {
        card->move(content_left, kGap_px + 4);
        content_left += card->width() + kGap_px;
    }
    int beside_px = desk_px;
    for (const Card* card : std::initializer_list<const Card*>{robots_card_, legend_}) {
        if (card->isVisibleTo(map_)) beside_px = std::max(beside_px, card->width());
    }
    const int content_right = map_->width() - kGap_px - (beside_px > 0 ? beside_px + kGap_px : 0);
    NoteStack stack(left, content_left, content_right, map_->height());
    for (Banner* banner : {link_banner_, error_banner_, note_banner_}) {
        if (!banner->isVisibleTo(map_)) continue;
        stack.add(*banner, banner->sizeWithin(std::min(760, stack.width())));
    }
    for (ChoiceNote* note : {resume_note_, floor_note_}) {
        if (!note->isVisibleTo(map_)) continue;
        const int width = note->widthWithin(stack.width());
        stack.add(*note, {width, note->layout()->totalHeightForWidth(width)});
    }
    hint_->move((content_left + map_->width() - hint_->width()) / 2,
                (map_->height() - hint_->height()) / 2);
    int bottom = map_->height() - 96;
    for (PlanProgressCard* progress : {plan_progress_, copy_progress_}) {
        if (!progress->isVisibleTo(map_)) continue;
        progress->resize(420, 72);
        bottom -= progress->height();
        progress->move((content_left + map_->width() - progress->width()) / 2, bottom);
        bottom -= kGap_px / 2;
    }
    const auto left_px = static_cast<double>(left);
    constexpr double kTop_px = 40.0;
    constexpr double kBottom_px = 84.0;  // the scale bar
    // What lies on the right is beside the plan and the robot and hides nothing of them.
    const double right_px = beside_px > 0 ? beside_px + 2.0 * kGap_px : left_px;
    map_->setMargins({left_px, kTop_px, right_px, kBottom_px});
}

// While something is done to the plans its words take the strip's place; what the link says is on
// the map all the same.
void MainWindow::showDesk() {
    if (!desk_->open() && !strip_->isVisible()) strip_->holdConnection();  // Done was there
    strip_->setVisible(!desk_->open());
    if (desk_->open()) {
        for (Card* card : sideCards()) card->hide();
    }
    showFloorNote();
    placeOverlays();
}

// They share the place beside the rail: one of them at a time.
std::array<Card*, 4> MainWindow::sideCards() const {
    return {connect_card_, link_card_, robot_card_, publish_card_};
}

void MainWindow::toggleCard(Card* card) {
    const bool opens = !card->isVisibleTo(map_);
    for (Card* each : sideCards()) each->setVisible(opens && each == card);
    if (!opens) map_->setFocus();
    refresh();
}

// Its keys are the map's again, or those of the card.
void MainWindow::showOpener() {
    if (!opener_->openCard()) map_->setFocus();
    refresh();
}

}  // namespace hedr
