#pragma once

#include <QObject>
#include <optional>
#include <utility>
#include <vector>

#include "core/site/site.h"
#include "ui/map/map_plan.h"
#include "ui/site/history.h"

namespace hedr {

// The site as the operator edits it: its value with every earlier one, the images' pixels, the
// floor that is shown and the one that the robot is on. A site has at least one floor.
class SiteModel : public QObject {
    Q_OBJECT

  public:
    explicit SiteModel(QObject* parent = nullptr);  // with one empty floor

    const Site& site() const { return preview_ ? *preview_ : history_.now(); }
    std::size_t floorIndex() const { return floor_; }  // shown
    std::size_t robotFloorIndex() const { return robot_floor_; }
    bool showsRobotFloor() const { return floor_ == robot_floor_; }
    const SiteFloor& floor() const { return site().floors.at(floor_); }
    // Without what is only a preview: what a file may hold.
    const Site& settled() const { return history_.now(); }
    const PlanImage* image(const SitePlan& plan) const;       // nullptr: its pixels are not there
    const PlanImage* wholeImage(const SitePlan& plan) const;  // nullptr also for a preview
    // What a map of that floor draws: the visible plans, with their pixels.
    std::vector<MapPlan> mapPlans(const SiteFloor& floor) const;
    std::vector<SitePlan> plansWithoutImage() const;

    // Nothing says how large it is and where it lies, and nobody has aligned it yet.
    bool liesByGuess(const SitePlan& plan) const;
    // What is wrong with its image file, for the operator; empty: nothing.
    QString warning(const SitePlan& plan) const;
    void warn(const SitePlan& plan, const QString& warning);

    void open(Site site);  // another site: its history begins here
    // As a new plan on top of the floor; false: it is there, and has got these pixels.
    bool addImage(const PlanImage& image, int page = 1);
    // Of a floor: it never came whole. No step of the history remembers it.
    void withdrawImage(const std::filesystem::path& file, int page, std::size_t floor);
    void giveImage(const SitePlan& plan, PlanImage image);  // the pixels of one there is
    void edit(Site next);                                   // a step that undo takes back
    void preview(Site next);                                // seen, but not a step yet
    void dropPreview();
    void showFloor(std::size_t floor);      // to look at it: the robot stays where it is
    void moveRobot(std::size_t floor);      // as the operator says; shows it
    void turnToRobotOn(std::size_t floor);  // another robot is meant now, and it is there
    void removeFloor(std::size_t floor);    // a step; the last one stays
    void undo();
    void redo();

  signals:
    void changed();                      // what is to be seen
    void kept(const hedr::Site& site);   // after a step, also after undo and redo
    void floorShown(std::size_t floor);  // after changed()
    void robotMoved(std::size_t floor);

  private:
    void settle();  // after a step

    History<Site> history_;
    std::optional<Site> preview_;
    std::size_t floor_ = 0;
    std::size_t robot_floor_ = 0;
    std::vector<std::pair<SitePlan, PlanImage>> images_;
    std::vector<std::pair<SitePlan, QString>> warnings_;
};

}  // namespace hedr
