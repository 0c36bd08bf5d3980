#pragma once

#include <QRect>
#include <optional>
#include <vector>

#include "core/site/plan_copy.h"
#include "ui/site/desk_header.h"
#include "ui/site/desk_page.h"
#include "ui/site/site_model.h"

namespace hedr {

class AlignPage;
class CorridorsPage;
class CropPage;
class LayersCard;
class MapView;
class StraightenPage;
class TiePage;
class WallsPage;

// The operator's work on floor plans: the site, the page that is open, and what the map shows of
// both. At most one page is open at a time.
class SiteDesk : public QObject {
    Q_OBJECT

  public:
    SiteDesk(MapView& map, QWidget* window);  // the map outlives the desk

    SiteModel& site() { return site_; }
    DeskHeader* header() const { return header_; }
    void setTheme(const Theme& theme);

    bool addImage(const PlanImage& image, int page);  // false: its plan was there
    void withdrawImage(const std::filesystem::path& file, int page, std::size_t floor);
    void alignTopmost();
    void toggleLayers();
    void changeFloor(int by);  // up or down
    void straighten(std::size_t plan);
    void straightenTopmost();
    void drawWalls();
    void tellCorridors();
    void tieToGlobe();
    void join(DeskPage& page);      // another's, which is told what is done on the map
    void showPage(DeskPage* page);  // that has joined; cancels the one that is open
    bool open() const { return page_ != nullptr; }
    void undo();  // of the page that is open, else of the site
    void redo();
    void cancel();
    bool nudge(Vector<View> by);  // of the page that is open; false: it has no use for it
    bool takesRoom() const;       // beside the map
    int placeCards(const QRect& free) const;  // to the right of it; how much of it they take, px

  signals:
    void pageChanged();  // also what it needs of room
    void openWished();   // another image
    void removeFloorWished(std::size_t floor);
    void openSiteWished();
    void saveSiteWished();
    void copyWished(std::size_t plan, hedr::PlanCopyKind kind);
    void refused(const QString& why);  // what was wished, in one sentence

  private:
    void connectPages();
    void connectPage(DeskPage& page);
    void connectLayers();
    void align(std::size_t plan);
    void crop(std::size_t plan);
    std::optional<std::size_t> topmost();  // that is ready; says why there is none
    bool ready(std::size_t plan) const;    // its pixels are there, and it may be changed
    void tellWhyNot(std::size_t plan);     // it is not ready
    Card* card() const;                    // of what is open; nullptr: none
    void closePage();
    void choosePointsFile();  // for the align page
    void showSite();

    MapView& map_;
    SiteModel site_;
    DeskHeader* header_;
    AlignPage* align_;
    StraightenPage* straighten_;
    WallsPage* walls_;
    CropPage* crop_;
    CorridorsPage* corridors_;
    TiePage* tie_;
    LayersCard* layers_;
    bool layers_open_ = false;
    std::vector<DeskPage*> pages_;
    DeskPage* page_ = nullptr;
    Theme theme_ = dayTheme();
};

}  // namespace hedr
