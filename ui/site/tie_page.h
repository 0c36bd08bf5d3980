#pragma once

#include <optional>

#include "ui/site/desk_page.h"
#include "ui/site/history.h"
#include "ui/site/site_model.h"
#include "ui/site/tie_draft.h"

namespace hedr {

class TieCard;

// Ties the map's metres to latitude and longitude: one place and a bearing, or two places.
class TiePage : public DeskPage {
    Q_OBJECT

  public:
    TiePage(SiteModel& site, QWidget* map);

    QString title() const override;
    QString hint() const override;
    Card* card() override;
    void begin() override;
    bool canUndo() const override { return history_.canUndo(); }
    void undo() override;
    bool canAccept() const override { return !tieOf(history_.now()).error; }
    void cancel() override;
    void accept() override;

    bool press(Point<View> at, const ViewTransform& view) override;
    void move(Point<View> at, const ViewTransform& view) override;
    void release(Point<View> at, const ViewTransform& view) override;
    void click(Point<View> at, const ViewTransform& view) override;
    void paint(QPainter& painter, const ViewTransform& view, const Theme& theme) const override;

  private:
    void takePlace(std::size_t place, const QString& text);
    void takeBearing(const QString& text);
    void step(TieDraft next);
    void show();
    TieDraft draft() const;  // with the mark where it is being dragged

    SiteModel& site_;
    TieCard* card_;
    History<TieDraft> history_{};
    QString trouble_{};
    std::optional<std::size_t> held_{};
    std::optional<Point<World>> dragged_{};
};

}  // namespace hedr
