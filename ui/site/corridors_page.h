#pragma once

#include <optional>

#include "core/site/survey/directions.h"
#include "ui/background_job.h"
#include "ui/site/desk_page.h"
#include "ui/site/history.h"
#include "ui/site/site_model.h"

namespace hedr {

class CorridorsCard;

// Says in which direction the corridors run, by the walls of a plan or by a line along one of them.
// The estimators are told when it is done; HEDR calls it the dominant direction.
class CorridorsPage : public DeskPage {
    Q_OBJECT

  public:
    CorridorsPage(SiteModel& site, QWidget* map);

    QString title() const override;
    QString hint() const override;
    Card* card() override;
    void begin() override;
    bool canUndo() const override { return history_.canUndo(); }
    void undo() override;
    void cancel() override;
    void accept() override;

    bool press(Point<View> at, const ViewTransform& view) override;
    void move(Point<View> at, const ViewTransform& view) override;
    void release(Point<View> at, const ViewTransform& view) override;
    void click(Point<View> at, const ViewTransform& view) override;
    void paint(QPainter& painter, const ViewTransform& view, const Theme& theme) const override;

  private:
    // What is to be told, and by whom it is known.
    struct Told {
        std::optional<double> direction_rad{};
        bool by_plan = false;     // the walls of the plan that is looked at
        double confidence = 0.0;  // of its walls' direction
    };
    struct DrawnLine {
        Point<World> from{};
        Point<World> to{};
    };

    const SitePlan* plan() const;  // the topmost one that is seen; nullptr: none
    void look();
    void showFound(const Result<PlanDirections>& found);
    void step(const Told& told);
    void show();
    QString advice() const;
    std::optional<double> direction_rad() const;

    SiteModel& site_;
    CorridorsCard* card_;
    History<Told> history_{};
    std::optional<DrawnLine> line_{};  // as it is being drawn
    QString trouble_{};                // why the plan tells none
    BackgroundJob looking_;
};

}  // namespace hedr
