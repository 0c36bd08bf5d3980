#pragma once

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QImage>
#include <QPainter>
#include <QTest>
#include <string>

#include "tests/ui/scene.h"
#include "ui/main_window.h"
#include "ui/map/map_view.h"
#include "ui/panels/banner.h"
#include "ui/panels/status_tile_view.h"

namespace hedr {

// Finds things in a window as a person would: by their words.
class WindowUser {
  public:
    WindowUser() : window(hand.clock()) {
        window.resize(1280, 800);
        window.show();
        window.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&window));
    }

    void live(double second) {
        hand.set(second);
        window.applyBatch(test::sampleBatch(second, second_ < 0.0 ? -1.0 : second_));
        second_ = second;
    }
    QString tile(const QString& label) const {
        for (const auto* view : window.findChildren<StatusTileView*>()) {
            if (view->accessibleName() == label) {
                return view->accessibleDescription().replace(QChar(0x00A0), QChar(' '));
            }
        }
        return {};
    }
    QAbstractButton* button(const QString& name) const {
        for (auto* candidate : window.findChildren<QAbstractButton*>()) {
            const bool named = candidate->text() == name || candidate->accessibleName() == name;
            if (named && candidate->isVisible()) return candidate;
        }
        return nullptr;
    }
    MapView& map() const { return *window.findChild<MapView*>(); }
    // Without the cards: the legend has the trails' colours too.
    QImage mapPicture() const {
        QImage picture(map().size(), QImage::Format_RGB32);
        map().render(&picture, {}, {}, QWidget::DrawWindowBackground);
        return picture;
    }
    // Of exactly this colour on the map, but for the needle of the dial.
    int pixels(const QColor& colour) const {
        QImage picture = mapPicture();
        QPainter(&picture).fillRect(map().dialRect(), map().palette().window());
        int count = 0;
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) count += picture.pixel(x, y) == colour.rgb();
        }
        return count;
    }
    QColor colourAt(const QPoint& place) const { return mapPicture().pixelColor(place); }
    QPoint robotAt(const LiveBatch& batch, const std::string& trail) const {
        for (const NamedPoints& track : batch.tracks) {
            if (track.name != trail) continue;
            const Point<View> at = map().view().viewFromWorld() * track.points.back().pose.position;
            return {qRound(at.x), qRound(at.y)};
        }
        return {};
    }
    QString banner() const {
        for (const auto* banner : window.findChildren<Banner*>()) {
            if (banner->isVisible()) return banner->text();
        }
        return {};
    }

    test::HandClock hand;
    MainWindow window;

  private:
    double second_ = -1.0;
};

template <class Condition>
testing::AssertionResult soon(Condition condition) {
    if (QTest::qWaitFor(condition, 20000)) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "not within two seconds";
}

}  // namespace hedr
