#pragma once

#include <QObject>
#include <map>
#include <optional>
#include <vector>

#include "core/site/site.h"
#include "ui/map/map_plan.h"
#include "ui/site/history.h"

namespace hedr {

// The site as the operator edits it: its value with every earlier one, and the images' pixels. The
// site always has a floor.
class SiteModel : public QObject {
    Q_OBJECT

  public:
    explicit SiteModel(QObject* parent = nullptr);

    const Site& site() const { return preview_ ? *preview_ : history_.now(); }
    const SiteFloor& floor() const { return site().floors[floor_]; }
    std::size_t floorIndex() const { return floor_; }
    const PlanImage* image(const SitePlan& plan) const;
    // What the map draws of the floor shown: the visible plans whose pixels are there.
    std::vector<MapPlan> mapPlans() const;

    void open(const Site& site);  // another site: nothing to undo
    // Pixels of a plan that the site has, or a new plan on top of the floor. Gives its index.
    std::size_t addImage(const PlanImage& image);
    void showFloor(std::size_t index);

    void edit(Site next, const QString& what);  // a step that undo takes back
    void preview(Site next);                    // seen, but not a step yet
    void dropPreview();
    bool canUndo() const { return history_.canUndo(); }
    bool canRedo() const { return history_.canRedo(); }
    QString undoText() const { return history_.undoText(); }
    void undo();
    void redo();

  signals:
    void changed();  // what is to be seen
    void edited();   // what is to be kept: not while it is only a preview
    void floorChanged();

  private:
    void settle();  // after a step

    History<Site> history_;
    std::optional<Site> preview_;
    std::size_t floor_ = 0;
    std::map<std::filesystem::path, PlanImage> images_;
};

// The site with one plan changed; `floor` and `plan` count from 0.
Site withPlan(Site site, std::size_t floor, std::size_t plan, const SitePlan& changed);

}  // namespace hedr
