#pragma once

#include <QObject>
#include <map>
#include <optional>
#include <vector>

#include "core/site/site.h"
#include "ui/map/map_plan.h"
#include "ui/site/history.h"

namespace hedr {

// The site as the operator edits it: its value with every earlier one, and the images' pixels.
class SiteModel : public QObject {
    Q_OBJECT

  public:
    explicit SiteModel(QObject* parent = nullptr);  // with one empty floor

    const Site& site() const { return preview_ ? *preview_ : history_.now(); }
    // The floor that the robot is on and that is shown.
    std::size_t floorIndex() const { return floor_; }
    const SiteFloor& floor() const { return site().floors.at(floor_); }
    const PlanImage* image(const SitePlan& plan) const;
    // What the map draws: the visible plans, with their pixels.
    std::vector<MapPlan> mapPlans() const;

    void addImage(const PlanImage& image);  // a new plan on top, or new pixels of one there is
    void edit(Site next);                   // a step that undo takes back
    void preview(Site next);                // seen, but not a step yet
    void dropPreview();
    void undo();
    void redo();

  signals:
    void changed();  // what is to be seen

  private:
    void settle();  // after a step

    History<Site> history_;
    std::size_t floor_ = 0;
    std::optional<Site> preview_;
    std::map<std::filesystem::path, PlanImage> images_;
};

}  // namespace hedr
