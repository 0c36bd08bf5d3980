#include "ui/site/site_desk.h"

#include <QAbstractButton>
#include <QFileDialog>
#include <QShortcut>
#include <algorithm>

#include "ui/map/map_view.h"
#include "ui/site/align_page.h"
#include "ui/site/corridors_page.h"
#include "ui/site/crop_page.h"
#include "ui/site/file_dialog_look.h"
#include "ui/site/layers_card.h"
#include "ui/site/straighten_page.h"
#include "ui/site/tie_page.h"
#include "ui/site/walls_page.h"

namespace hedr {

SiteDesk::SiteDesk(MapView& map, QWidget* window)
    : QObject(window),
      map_(map),
      header_(new DeskHeader(window)),
      align_(new AlignPage(site_, map_)),
      straighten_(new StraightenPage(site_, &map_)),
      walls_(new WallsPage(site_, &map_)),
      crop_(new CropPage(site_, &map_)),
      corridors_(new CorridorsPage(site_, &map_)),
      tie_(new TiePage(site_, &map_)),
      layers_(new LayersCard(site_, map_)),
      pages_{align_, straighten_, walls_, crop_, corridors_, tie_} {
    connect(&site_, &SiteModel::changed, this, &SiteDesk::showSite);
    connect(header_, &DeskHeader::undoWished, this, &SiteDesk::undo);
    connect(header_, &DeskHeader::cancelWished, this, &SiteDesk::cancel);
    connect(header_, &DeskHeader::doneWished, this, [this] {
        if (page_) page_->accept();
    });
    connectPages();
    connectLayers();
}

void SiteDesk::connectPages() {
    connect(align_, &AlignPage::straightenWished, this, [this](std::size_t plan) {
        align_->cancel();
        straighten(plan);
    });
    connect(align_, &AlignPage::pointsFileWished, this, &SiteDesk::choosePointsFile);
    for (DeskPage* page : pages_) connectPage(*page);
}

void SiteDesk::connectPage(DeskPage& page) {
    // A click leaves the keys with the map: the arrows, and Escape.
    for (auto* button : page.card()->findChildren<QAbstractButton*>())
        button->setFocusPolicy(Qt::TabFocus);
    auto* escape = new QShortcut(Qt::Key_Escape, page.card());
    escape->setContext(Qt::WidgetWithChildrenShortcut);
    connect(escape, &QShortcut::activated, this, &SiteDesk::cancel);
    connect(&page, &DeskPage::finished, this, &SiteDesk::closePage);
    connect(&page, &DeskPage::changed, this, [this, page = &page] {
        if (page != page_) return;
        header_->show(*page);
        map_.update();
        emit pageChanged();
    });
}

void SiteDesk::join(DeskPage& page) {
    connectPage(page);
    pages_.push_back(&page);
    page.card()->setTheme(theme_);
}

void SiteDesk::connectLayers() {
    connect(layers_, &LayersCard::openWished, this, &SiteDesk::openWished);
    connect(layers_, &LayersCard::removeFloorWished, this, &SiteDesk::removeFloorWished);
    connect(layers_, &LayersCard::alignWished, this, &SiteDesk::align);
    connect(layers_, &LayersCard::wallsWished, this, &SiteDesk::drawWalls);
    connect(layers_, &LayersCard::straightenWished, this, &SiteDesk::straighten);
    connect(layers_, &LayersCard::cropWished, this, &SiteDesk::crop);
    connect(layers_, &LayersCard::corridorsWished, this, &SiteDesk::tellCorridors);
    connect(layers_, &LayersCard::tieWished, this, &SiteDesk::tieToGlobe);
    connect(layers_, &LayersCard::openSiteWished, this, &SiteDesk::openSiteWished);
    connect(layers_, &LayersCard::saveSiteWished, this, &SiteDesk::saveSiteWished);
    connect(layers_, &LayersCard::copyWished, this, &SiteDesk::copyWished);
}

void SiteDesk::setTheme(const Theme& theme) {
    theme_ = theme;
    header_->setTheme(theme);
    layers_->setTheme(theme);
    for (DeskPage* page : pages_) page->card()->setTheme(theme);
}

bool SiteDesk::addImage(const PlanImage& image, int page) { return site_.addImage(image, page); }

// A page that is open may be at work on it.
void SiteDesk::withdrawImage(const std::filesystem::path& file, int page, std::size_t floor) {
    if (page_) page_->cancel();
    site_.withdrawImage(file, page, floor);
}

bool SiteDesk::ready(std::size_t plan) const {
    const auto& plans = site_.floor().plans;
    return plan < plans.size() && !plans[plan].locked && site_.image(plans[plan]);
}

void SiteDesk::tellWhyNot(std::size_t plan) {
    const SitePlan& wanted = site_.floor().plans.at(plan);
    QString why = tr("The pixels of %1 are not there. Put its file where it was, then open it.");
    if (site_.image(wanted) && !site_.wholeImage(wanted))
        why = tr("%1 is still being loaded. Wait a moment.");
    if (wanted.locked) why = tr("%1 is locked. Unlock it in the layers (L) first.");
    emit refused(why.arg(QString::fromStdString(wanted.image_file.filename().string())));
}

std::optional<std::size_t> SiteDesk::topmost() {
    const std::size_t count = site_.floor().plans.size();
    for (std::size_t plan = count; plan-- > 0;) {
        if (ready(plan)) return plan;
    }
    if (count > 0) {
        tellWhyNot(count - 1);
    } else {
        emit refused(tr("This floor has no plan yet. Open one (P) first."));
    }
    return std::nullopt;
}

void SiteDesk::alignTopmost() {
    if (open()) return;
    if (const auto plan = topmost()) align(*plan);
}

void SiteDesk::align(std::size_t plan) {
    if (!ready(plan)) return tellWhyNot(plan);
    align_->choose(plan);
    showPage(align_);
}

void SiteDesk::crop(std::size_t plan) {
    if (!ready(plan)) return tellWhyNot(plan);
    crop_->choose(plan);
    showPage(crop_);
}

void SiteDesk::toggleLayers() {
    layers_open_ = !layers_open_;
    layers_->setVisible(layers_open_ && !page_);
    emit pageChanged();
}

void SiteDesk::changeFloor(int by) {
    if (open()) return;
    site_.showFloor(site_.floorIndex() + static_cast<std::size_t>(by));
}

void SiteDesk::straighten(std::size_t plan) {
    if (open()) return;
    if (!ready(plan) || !straighten_->choose(plan)) return tellWhyNot(plan);
    showPage(straighten_);
    map_.fit();
}

void SiteDesk::straightenTopmost() {
    if (open()) return;
    if (const auto plan = topmost()) straighten(*plan);
}

void SiteDesk::drawWalls() {
    if (!open()) showPage(walls_);
}

void SiteDesk::tellCorridors() {
    if (!open()) showPage(corridors_);
}

void SiteDesk::tieToGlobe() {
    if (!open()) showPage(tie_);
}

void SiteDesk::undo() { page_ ? page_->undo() : site_.undo(); }

void SiteDesk::redo() {
    if (!page_) site_.redo();
}

void SiteDesk::cancel() {
    if (page_) return page_->cancel();
    if (layers_open_) toggleLayers();
}

bool SiteDesk::nudge(Vector<View> by) { return page_ && page_->nudge(by); }

void SiteDesk::showPage(DeskPage* page) {
    if (page_) page_->cancel();
    page_ = page;
    page->begin();
    layers_->setVisible(false);
    page->card()->setVisible(true);
    map_.setTool(page);
    map_.setFocus();
    header_->show(*page);
    emit pageChanged();
}

void SiteDesk::closePage() {
    if (!page_) return;
    page_->card()->setVisible(false);
    page_ = nullptr;
    layers_->setVisible(layers_open_);
    map_.setTool(nullptr);
    header_->setVisible(false);
    emit pageChanged();
}

void SiteDesk::choosePointsFile() {
    auto* dialog = new QFileDialog(map_.window(), tr("Choose a file of points"), {},
                                   tr("Points (*.csv *.points);;All files (*)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dress(*dialog, theme_);
    connect(dialog, &QFileDialog::fileSelected, align_, [this](const QString& file) {
        if (page_ == align_) align_->takePointsOf(file);
    });
    dialog->open();
}

void SiteDesk::showSite() { map_.setPlans(site_.mapPlans(site_.floor())); }

Card* SiteDesk::card() const {
    if (page_) return page_->card();
    return layers_open_ ? layers_ : nullptr;
}

bool SiteDesk::takesRoom() const { return card() != nullptr; }

int SiteDesk::placeCards(const QRect& free) const {
    Card* shown = card();
    if (!shown) return 0;
    const QLayout& layout = *shown->layout();
    const int width = std::min(shown->sizeHint().width(), shown->maximumWidth());
    const int height =
        layout.hasHeightForWidth() ? layout.totalHeightForWidth(width) : shown->sizeHint().height();
    shown->resize(QSize(width, height).boundedTo(free.size()));
    shown->move(free.right() + 1 - shown->width(), free.top());
    return shown->width();
}

}  // namespace hedr
