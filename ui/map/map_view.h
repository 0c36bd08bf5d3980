#pragma once

#include <QPushButton>
#include <QWidget>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "ui/fleet.h"
#include "ui/map/base_keeper.h"
#include "ui/map/call_sign.h"
#include "ui/map/map_tool.h"
#include "ui/map/marks.h"
#include "ui/map/robot_symbol.h"
#include "ui/map/view_transform.h"
#include "ui/theme.h"

namespace hedr {

// A trail on the map, and whose it is.
struct MapTrail {
    const FleetRobot* robot;
    const LiveTrail* trail;
};

// The live map: of the chosen robot all that is known, of the others where they are and have been.
// A frame is a blit of the cached base image, the ends of the trails that it does not
// show yet, and the robot; a new base image is drawn elsewhere and swapped in when it is ready.
class MapView : public QWidget {
    Q_OBJECT

  public:
    explicit MapView(const Fleet& fleet, QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    void setPlans(std::vector<MapPlan> plans);  // the lowest first
    bool hasPlan() const { return !plans_.empty(); }
    void setTool(MapTool* tool);                  // gets the mouse first; nullptr: none
    void showChosenTrails();                      // another choice of trails, or of the robot
    void setMargins(const ViewMargins& margins);  // covered by cards
    void forgetTrails();
    void setFloor(std::size_t floor);            // to be shown; the robot may be on another one
    void refresh(ReceiveClock::time_point now);  // the models or their age have changed

    void setFollowing(bool following);
    bool following() const { return following_; }
    void fit();
    void zoomBy(double factor);
    void panBy(Vector<View> content_moves);
    const ViewTransform& view() const { return view_; }
    // A floor with those plans, and what has been driven on it; for a worker to draw.
    MapScene sceneOf(std::vector<MapPlan> plans, std::size_t floor) const;
    QRectF dialRect() const;
    bool isSharp() const;  // nothing better is being drawn

  signals:
    void followingChanged(bool following);
    void robotClicked(hedr::RobotId robot);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

  private:
    // Points that the base image does not show yet. It takes in the first number of each trail;
    // where more of a robot come at once, another image is drawn; beyond the third number a frame
    // waits for it, as drawing them would be felt.
    static constexpr std::size_t kTailToTakeIn = 128;
    static constexpr std::size_t kTailForNewBase = 1200;
    static constexpr std::size_t kMostTailInAFrame = 6000;
    // What is taken in lies above what was there: after this many points of a robot all trails are
    // drawn in their order again.
    static constexpr std::size_t kGrownForNewBase = 1500;

    void setView(const ViewTransform& view);
    void keepBaseFresh();
    void takeTailsIn();
    bool baseIsGoodEnough() const;
    std::size_t tailPoints() const;
    const LiveModel& model() const { return fleet_.chosen().model; }
    bool showsRobot() const { return floor_ == model().floor(); }  // it is on this floor
    // The primary one of each stretch after its others.
    std::vector<SceneTrail> earlierTrails(std::size_t floor) const;
    // Of the other robots the primary one each, then those of the chosen one, its primary one last.
    std::vector<MapTrail> trailsOn(std::size_t floor) const;
    std::vector<MapTrail> drawnTrails() const { return trailsOn(floor_); }
    QPen penOf(const MapTrail& shown) const;
    std::optional<RobotSymbol> symbolOf(const FleetRobot& robot) const;  // if it is on this floor
    QString labelOf(const FleetRobot& robot) const;                      // empty: it is alone
    void nameRobots();
    QRectF callSignRect(const FleetRobot& robot, const RobotSymbol& symbol) const;
    std::optional<RobotId> robotAt(Point<View> place) const;  // another one than chosen
    std::optional<Spread> spread()
        const;  // where the primary trail tells it and it fits into the view
    QRectF freeRect() const;
    QRectF pointerRect() const;  // within which robots out of sight are pointed at
    QPointF dialCentre() const;
    void keepRobotInSight();
    QRegion partsOf(const FleetRobot& robot) const;
    QRegion movingParts() const;  // what changes from batch to batch
    void placeResumeButton();
    void paintBase(QPainter& painter, const QRect& exposed) const;
    void paintTails(QPainter& painter) const;
    void paintMarks(QPainter& painter, const QRegion& exposed) const;
    void paintWhereabouts(QPainter& painter) const;  // of the chosen robot
    void paintRobot(QPainter& painter, const FleetRobot& robot) const;
    void paintInstruments(QPainter& painter, const QRegion& exposed) const;

    const Fleet& fleet_;
    Theme theme_ = dayTheme();
    std::vector<MapPlan> plans_;
    std::size_t floor_ = 0;
    MapTool* tool_ = nullptr;
    bool tool_has_press_ = false;
    ViewTransform view_{};
    ViewMargins margins_{};
    ReceiveClock::time_point now_{};  // of the last refresh
    LinkVerdict link_{};
    double reach_m_ = 0.0;
    bool following_ = true;
    bool fitted_ = true;  // until the operator or the robot moves the map
    std::optional<QPoint> drag_from_;
    bool dragging_ = false;
    QRegion last_moving_parts_;
    int needle_deg_ = 0;
    std::map<RobotId, CallSign> call_signs_;  // as of the last refresh
    BaseKeeper keeper_;
    QPushButton* resume_;
};

}  // namespace hedr
