#pragma once

#include <QElapsedTimer>
#include <QPushButton>
#include <QWidget>
#include <vector>

#include "ui/panels/status_tiles.h"
#include "ui/theme.h"

namespace hedr {

class StatusTileView;

// The strip of tiles above the map. It gives each tile the room that its words need and makes the
// type smaller before anything touches.
class StatusStrip : public QWidget {
    Q_OBJECT

  public:
    explicit StatusStrip(QWidget* parent = nullptr);
    void setTheme(const Theme& theme);
    void show(const std::vector<StatusTile>& tiles);
    void setConnected(bool connected);
    // The button does nothing for a moment: who clicked something else there may click once more.
    void holdConnection();

  signals:
    void connectionToggled();
    void tileClicked(hedr::TileKind kind);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    void placeTiles();
    std::vector<int> widthsAt(int value_px) const;
    std::vector<int> widthsWithin(int room, int value_px) const;

    Theme theme_ = dayTheme();
    std::vector<StatusTileView*> tiles_;
    QPushButton* button_;
    QElapsedTimer held_{};
};

}  // namespace hedr
