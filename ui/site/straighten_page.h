#pragma once

#include <optional>

#include "core/site/survey/rectification.h"
#include "ui/background_job.h"
#include "ui/site/desk_page.h"
#include "ui/site/history.h"
#include "ui/site/site_model.h"

namespace hedr {

class StraightenCard;

// Makes the photo of a plan flat: four corners of a rectangle in it, proposed and then dragged, and
// beside the map what becomes of it.
class StraightenPage : public DeskPage {
    Q_OBJECT

  public:
    StraightenPage(SiteModel& site, QWidget* map);

    bool choose(std::size_t plan);  // of the site; false: the pixels of its photo are not there
    const Straightening& straightening() const { return dragged_ ? *dragged_ : history_.now(); }

    QString title() const override;
    QString hint() const override;
    Card* card() override;
    void begin() override;
    bool canUndo() const override { return history_.canUndo() && !flattening_.running(); }
    bool canAccept() const override;
    void undo() override;
    void cancel() override;
    void accept() override;

    bool press(Point<View> at, const ViewTransform& view) override;
    void move(Point<View> at, const ViewTransform& view) override;
    void release(Point<View> at, const ViewTransform& view) override;
    void click(Point<View> at, const ViewTransform& view) override;
    void paint(QPainter& painter, const ViewTransform& view, const Theme& theme) const override;

  private:
    enum class Corners { kSought, kNotFound, kGiven };
    struct Drag {
        std::size_t corner = 0;
        Vector<View> off{};  // from the pointer to the corner
    };

    void propose();
    void chooseSides(std::optional<double> longer_by_shorter);
    void step(Straightening next);
    void showPhoto();  // on the map
    void showFlat();   // in the card
    void show();
    QString verdict() const;
    void finish(std::optional<Straightening> straightened, const PlanPlacement& placement);
    PlanCrop sheetOf(const Rectification& flat) const;
    std::optional<SheetAspect> seenAspect() const;
    Result<Rectification> rectificationOf(const Straightening& straightening) const;
    Transform<View, Plan> viewFromPhoto(const ViewTransform& view) const;
    Straightening withCorner(std::size_t corner, Point<View> at, const ViewTransform& view) const;

    SiteModel& site_;
    StraightenCard* card_;
    std::size_t plan_ = 0;
    PlanImage photo_{};  // as it lies while the page is open
    bool inverted_at_night_ = true;
    Corners corners_ = Corners::kSought;
    bool of_sheet_ = false;  // what is proposed: beside it there is no plan
    History<Straightening> history_{};
    std::optional<Straightening> dragged_{};
    std::optional<Drag> drag_{};
    Result<Rectification> rectification_{};
    std::optional<Error> error_{};  // of what was computed
    BackgroundJob seeking_{};
    BackgroundJob flattening_{};
};

}  // namespace hedr
