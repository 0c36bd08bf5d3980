#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QTimer>
#include <functional>
#include <vector>

#include "ui/background_job.h"
#include "ui/panels/card.h"
#include "ui/site/layer_row.h"

namespace hedr {

class FloorRow;
class MapView;
class RowArea;
class SiteModel;

// The floors of the site in small pictures, the highest first, and the images of the one that
// is shown, the topmost first. What is changed here is seen at once and is a step that undo takes
// back.
class LayersCard : public Card {
    Q_OBJECT

  public:
    LayersCard(SiteModel& site, MapView& map);
    void setTheme(const Theme& theme) override;

  signals:
    void openWished();  // another image
    void removeFloorWished(std::size_t floor);
    void openSiteWished();
    void saveSiteWished();
    void corridorsWished();  // to be told
    void tieWished();        // to the globe
    void wallsWished();      // to be drawn
    void alignWished(std::size_t plan);
    void straightenWished(std::size_t plan);
    void cropWished(std::size_t plan);
    void copyWished(std::size_t plan, hedr::PlanCopyKind kind);  // for another program

  protected:
    void showEvent(QShowEvent* event) override;

  private:
    void build();
    void showSite();
    void showFloors();
    void showPlans();
    void drawPictures();
    void addFloor();
    void rename();
    void connectRow(LayerRow& row);
    void act(LayerAction action, std::size_t plan);
    Site withPlan(std::size_t plan, const std::function<void(SitePlan&)>& change) const;

    SiteModel& site_;
    MapView& map_;
    QLabel* floors_title_;
    QPushButton* add_floor_;
    QWidget* floor_list_;
    RowArea* floor_area_;
    std::vector<FloorRow*> floor_rows_{};
    QLineEdit* name_;
    QPushButton* remove_floor_;
    std::size_t named_ = 0;  // the floor whose name that is
    QLabel* empty_;
    QWidget* plan_list_;
    RowArea* plan_area_;
    std::vector<LayerRow*> plan_rows_{};
    QPushButton* open_;
    QPushButton* walls_;
    QPushButton* site_button_;
    QMenu* site_menu_;
    QTimer picture_timer_;
    BackgroundJob pictures_;
};

}  // namespace hedr
