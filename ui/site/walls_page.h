#pragma once

#include <optional>
#include <vector>

#include "ui/background_job.h"
#include "ui/site/desk_page.h"
#include "ui/site/history.h"
#include "ui/site/site_model.h"
#include "ui/site/wall_layer.h"

namespace hedr {

class WallsCard;

// Shows what a floor's plans say of walls and free space, and lets the operator draw what they do
// not say.
class WallsPage : public DeskPage {
    Q_OBJECT

  public:
    WallsPage(SiteModel& site, QWidget* map);

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
    using Strokes = std::vector<WallStroke>;
    struct Picture {  // of more than the view, and everything but the stroke that is being drawn
        ViewTransform view{};
        ThemeName theme{};
        QImage image{};
    };

    void look();  // for walls
    void show();  // what has changed
    QString verdict() const;
    const Picture& picture(const ViewTransform& view, const Theme& theme,
                           double device_ratio) const;

    SiteModel& site_;
    WallsCard* card_;
    History<Strokes> history_{};
    std::optional<WallStroke> drawn_{};
    std::optional<Result<std::vector<WallCells>>> found_{};  // none: not yet
    mutable std::optional<Picture> picture_{};
    BackgroundJob looking_{};
};

}  // namespace hedr
