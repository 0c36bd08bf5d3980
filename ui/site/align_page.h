#pragma once

#include <optional>

#include "ui/background_job.h"
#include "ui/site/align_marks.h"
#include "ui/site/align_method.h"
#include "ui/site/desk_page.h"
#include "ui/site/history.h"
#include "ui/site/placement_proposals.h"
#include "ui/site/site_model.h"

namespace hedr {

class AlignCard;
class MapView;

// Says where a plan lies: by points, by a known distance, by hand, or by choosing what is proposed
// from the plan's own lines or from the trail. Every step is seen on the live
// map at once and can be taken back.
class AlignPage : public DeskPage {
    Q_OBJECT

  public:
    AlignPage(SiteModel& site, MapView& map);

    void choose(std::size_t plan);  // of the site; its pixels must be there
    void setMethod(AlignMethod method);
    void takePointsOf(const QString& file);
    AlignMethod method() const { return method_; }
    const Alignment& alignment() const { return dragged_ ? *dragged_ : history_.now(); }

    QString title() const override;
    QString hint() const override;
    Card* card() override;
    void begin() override;
    bool canUndo() const override { return history_.canUndo(); }
    void undo() override;
    void cancel() override;
    void accept() override;
    bool nudge(Vector<View> by) override;

    bool press(Point<View> at, const ViewTransform& view) override;
    void move(Point<View> at, const ViewTransform& view) override;
    void release(Point<View> at, const ViewTransform& view) override;
    void click(Point<View> at, const ViewTransform& view) override;
    void paint(QPainter& painter, const ViewTransform& view, const Theme& theme) const override;

  signals:
    void straightenWished(std::size_t plan);
    void pointsFileWished();

  private:
    struct Drag {
        std::optional<GrabbedHandle> handle{};  // none: the whole plan
        Point<World> from{};
    };

    void connectCard();
    void setLocks(bool keep_scale, bool keep_rotation);
    void give(double distance_m);
    void take(Result<Alignment> next);
    void propose();
    void showProposals(Result<PlacementProposals> found);
    void step(Alignment next);
    void show();
    Site aligned() const;           // with the plan where it is now
    const PlanLevel& size() const;  // of the plan; its pixels do not matter here
    Point<World> middle() const;
    AlignMarks marks() const { return {alignment(), fit_, size()}; }
    bool holds(Point<World> at) const;  // the plan, that point
    Alignment dragged(Point<World> to) const;

    SiteModel& site_;
    MapView& map_;
    AlignCard* card_;
    std::size_t plan_ = 0;
    AlignMethod method_ = AlignMethod::kPoints;
    History<Alignment> history_{};
    std::optional<Alignment> dragged_{};
    std::optional<Drag> drag_{};
    AlignmentFit fit_{};
    QString trouble_{};  // with what was typed or read last
    PlacementProposals proposals_{};
    BackgroundJob proposing_;
};

}  // namespace hedr
