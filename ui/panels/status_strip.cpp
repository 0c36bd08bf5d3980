#include "ui/panels/status_strip.h"

#include <QPainter>
#include <algorithm>
#include <iterator>
#include <numeric>

#include "ui/panels/status_tile_view.h"
#include "ui/style_sheet.h"

namespace hedr {
namespace {

constexpr int kHeight_px = 89;
constexpr int kLeft_px = 10;
constexpr int kRight_px = 24;
constexpr int kForDetails_px = 30;  // left for lines of detail that are longer than their value
constexpr int kValueSizes_px[] = {25, 23, 21, 19, 17, 15};

int sum(const std::vector<int>& numbers) {
    return std::accumulate(numbers.begin(), numbers.end(), 0);
}

}  // namespace

StatusStrip::StatusStrip(QWidget* parent) : QWidget(parent), button_(new QPushButton(this)) {
    setFixedHeight(kHeight_px);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setAccessibleName(tr("Status"));
    button_->setObjectName(QStringLiteral("connection"));
    button_->setToolTip(tr("Connect to a robot, or disconnect (C)"));
    connect(button_, &QPushButton::clicked, this, [this] {
        constexpr int kHold_ms = 1000;
        if (!held_.isValid() || held_.hasExpired(kHold_ms)) emit connectionToggled();
    });
    setConnected(false);
}

void StatusStrip::setTheme(const Theme& theme) {
    theme_ = theme;
    button_->setStyleSheet(buttonSheet(theme));
    for (StatusTileView* tile : tiles_) tile->setTheme(theme);
    update();
}

void StatusStrip::holdConnection() { held_.start(); }

void StatusStrip::setConnected(bool connected) {
    const QString text = connected ? tr("Disconnect") : tr("Connect");
    if (button_->text() == text) return;
    button_->setText(text);
    button_->setAccessibleName(text);
}

void StatusStrip::show(const std::vector<StatusTile>& tiles) {
    while (tiles_.size() < tiles.size()) {
        tiles_.push_back(new StatusTileView(this));
        tiles_.back()->setTheme(theme_);
        tiles_.back()->setVisible(true);
        const TileKind kind = tiles[tiles_.size() - 1].kind;
        tiles_.back()->setClickable(kind != TileKind::kPlain);
        connect(tiles_.back(), &StatusTileView::clicked, this,
                [this, kind] { emit tileClicked(kind); });
    }
    bool others_wide = false;
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        others_wide = tiles_[i]->setTile(tiles[i]) || others_wide;
    }
    if (others_wide) placeTiles();
}

std::vector<int> StatusStrip::widthsAt(int value_px) const {
    std::vector<int> widths;
    for (const StatusTileView* tile : tiles_) widths.push_back(tile->neededWidth(value_px));
    return widths;
}

// What is left over goes to the details that do not fit yet, then to all alike.
std::vector<int> StatusStrip::widthsWithin(int room, int value_px) const {
    std::vector<int> widths = widthsAt(value_px);
    std::vector<int> wishes;
    for (std::size_t i = 0; i < tiles_.size(); ++i) {
        wishes.push_back(tiles_[i]->wantedWidth(value_px) - widths[i]);
    }
    const int spare = std::max(0, room - sum(widths));
    const int wished = sum(wishes);
    const double part = wished > spare ? static_cast<double>(spare) / wished : 1.0;
    const int each = std::max(0, spare - wished) / static_cast<int>(tiles_.size());
    for (std::size_t i = 0; i < tiles_.size(); ++i) {
        widths[i] += static_cast<int>(part * wishes[i]) + each;
    }
    return widths;
}

void StatusStrip::placeTiles() {
    const int button_width = width() >= 1280 ? 156 : 132;
    button_->setGeometry(width() - kRight_px - button_width, (kHeight_px - 48) / 2, button_width,
                         48);
    if (tiles_.empty()) return;
    const int room = button_->x() - 16 - kLeft_px;
    const int* value_px =
        std::find_if(std::begin(kValueSizes_px), std::end(kValueSizes_px) - 1,
                     [&](int size) { return sum(widthsAt(size)) + kForDetails_px <= room; });
    int x = kLeft_px;
    const std::vector<int> widths = widthsWithin(room, *value_px);
    for (std::size_t i = 0; i < tiles_.size(); ++i) {
        tiles_[i]->setValueSize(*value_px);
        const QRect place(x, 0, widths[i] - 1, kHeight_px - 1);
        if (tiles_[i]->geometry() != place) update();  // the lines between them move too
        tiles_[i]->setGeometry(place);
        x += widths[i];
    }
}

void StatusStrip::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), theme_.chrome);
    painter.fillRect(0, height() - 1, width(), 1, theme_.hairline);
    for (std::size_t i = 1; i < tiles_.size(); ++i) {
        painter.fillRect(tiles_[i]->x() - 1, 14, 1, kHeight_px - 29, theme_.hairline);
    }
}

void StatusStrip::resizeEvent(QResizeEvent*) { placeTiles(); }

}  // namespace hedr
