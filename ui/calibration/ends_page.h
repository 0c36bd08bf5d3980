#pragma once

#include <optional>

#include "ui/calibration/clicked_ends.h"
#include "ui/site/desk_page.h"
#include "ui/site/history.h"

namespace hedr {

class EndsCard;

// Clicks on the map where square drives began and ended, instead of measuring it by tape.
class EndsPage : public DeskPage {
    Q_OBJECT

  public:
    explicit EndsPage(QWidget* map);
    void choose(const ClickedEnds& earlier);  // to go on from, at the next begin()

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

  signals:
    void clicked(const hedr::ClickedEnds& ends);  // and done

  private:
    // A mark on which the pointer was pressed. Ends lie close together: without a drag it is a
    // click like any other.
    struct Grabbed {
        std::size_t mark = 0;
        Point<View> from{};
        bool dragged = false;
        ClickedEnds ends{};  // as they are while it is dragged
    };
    const ClickedEnds& ends() const { return grabbed_ ? grabbed_->ends : history_.now(); }
    void step(const ClickedEnds& next);
    void show();
    void lookFrom(Point<View> at, const ViewTransform& view);
    QString advice() const;

    EndsCard* card_;
    History<ClickedEnds> history_{};
    History<ClickedEnds> taken_{};  // as it was when it was done last
    std::optional<Grabbed> grabbed_{};
    std::optional<Point<World>> pointer_{};
    double pixel_m_ = 0.0;   // of the screen, when the pointer moved last
    bool too_near_ = false;  // the last click does not count
};

}  // namespace hedr
