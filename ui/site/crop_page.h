#pragma once

#include <QLabel>
#include <QPushButton>
#include <optional>

#include "ui/site/desk_page.h"
#include "ui/site/history.h"
#include "ui/site/site_model.h"
#include "ui/site/straighten_marks.h"

namespace hedr {

// The card of the crop page: how large the part is, and a way back to the whole image.
class CropCard : public Card {
    Q_OBJECT

  public:
    explicit CropCard(QWidget* parent);
    void setTheme(const Theme& theme) override;
    void show(const PlanCrop& crop, double resolution_m);

  signals:
    void wholeWished();

  private:
    QLabel* size_;
    QLabel* advice_;
    QPushButton* whole_;
};

// Says which part of an image is shown: the corners of a frame are dragged.
class CropPage : public DeskPage {
    Q_OBJECT

  public:
    CropPage(SiteModel& site, QWidget* map);

    void choose(std::size_t plan) { plan_ = plan; }

    QString title() const override;
    QString hint() const override;
    Card* card() override { return card_; }
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
    const SitePlan& plan() const { return site_.floor().plans.at(plan_); }
    PlanCrop wholeImage() const;
    ViewCorners corners(const ViewTransform& view) const;
    Transform<World, Plan> worldFromImage() const;
    void step(const PlanCrop& crop);
    void show();

    SiteModel& site_;
    CropCard* card_;
    std::size_t plan_ = 0;
    History<PlanCrop> history_{};
    PlanCrop crop_{};  // as it is being dragged
    std::optional<std::size_t> held_{};
};

}  // namespace hedr
