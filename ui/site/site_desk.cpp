#include "ui/site/site_desk.h"

#include "ui/map/map_view.h"
#include "ui/site/align_page.h"
#include "ui/site/straighten_page.h"
#include "ui/site/walls_page.h"

namespace hedr {

SiteDesk::SiteDesk(MapView& map, QWidget* window)
    : QObject(window),
      map_(map),
      header_(new DeskHeader(window)),
      align_(new AlignPage(site_, &map_)),
      straighten_(new StraightenPage(site_, &map_)),
      walls_(new WallsPage(site_, &map_)),
      pages_{align_, straighten_, walls_} {
    connect(&site_, &SiteModel::changed, this, &SiteDesk::showSite);
    connect(header_, &DeskHeader::undoWished, this, &SiteDesk::undo);
    connect(header_, &DeskHeader::cancelWished, this, &SiteDesk::cancel);
    connect(header_, &DeskHeader::doneWished, this, [this] {
        if (page_) page_->accept();
    });
    connect(align_, &AlignPage::straightenWished, this, [this](std::size_t plan) {
        align_->cancel();
        straighten(plan);
    });
    for (DeskPage* page : pages_) {
        connect(page, &DeskPage::finished, this, &SiteDesk::closePage);
        connect(page, &DeskPage::changed, this, [this, page] {
            if (page != page_) return;
            header_->show(*page);
            map_.update();
            emit pageChanged();
        });
    }
}

void SiteDesk::setTheme(const Theme& theme) {
    header_->setTheme(theme);
    for (DeskPage* page : pages_) page->card()->setTheme(theme);
}

void SiteDesk::addImage(const PlanImage& image) { site_.addImage(image); }

void SiteDesk::alignTopmost() {
    if (open() || site_.floor().plans.empty()) return;
    align_->choose(site_.floor().plans.size() - 1);
    showPage(align_);
}

void SiteDesk::straighten(std::size_t plan) {
    if (open() || plan >= site_.floor().plans.size() || !straighten_->choose(plan)) return;
    showPage(straighten_);
    map_.fit();
}

void SiteDesk::straightenTopmost() {
    if (!site_.floor().plans.empty()) straighten(site_.floor().plans.size() - 1);
}

void SiteDesk::drawWalls() {
    if (!open()) showPage(walls_);
}

void SiteDesk::undo() { page_ ? page_->undo() : site_.undo(); }

void SiteDesk::redo() {
    if (!page_) site_.redo();
}

void SiteDesk::cancel() {
    if (page_) page_->cancel();
}

void SiteDesk::showPage(DeskPage* page) {
    if (page_) page_->cancel();
    page_ = page;
    page->begin();
    page->card()->setVisible(true);
    map_.setTool(page);
    header_->show(*page);
    emit pageChanged();
}

void SiteDesk::closePage() {
    if (!page_) return;
    page_->card()->setVisible(false);
    page_ = nullptr;
    map_.setTool(nullptr);
    header_->setVisible(false);
    emit pageChanged();
}

void SiteDesk::showSite() { map_.setPlans(site_.mapPlans(site_.floor())); }

int SiteDesk::placeCards(const QRect& free) const {
    if (!page_) return 0;
    Card* card = page_->card();
    card->resize(card->sizeHint().boundedTo(free.size()));
    card->move(free.right() + 1 - card->width(), free.top());
    return card->width();
}

}  // namespace hedr
