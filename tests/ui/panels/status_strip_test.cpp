#include "ui/panels/status_strip.h"

#include <gtest/gtest.h>

#include "tests/ui/window_user.h"
#include "ui/fonts.h"
#include "ui/panels/status_tile_view.h"

namespace hedr {
namespace {

TEST(StatusStrip, GivesEveryTileItsRoomAtAnyWidth) {
    for (const int width : {1024, 1100, 1280, 1440, 1600, 2560}) {
        WindowUser w;
        w.window.resize(width, 700);
        w.live(1.0);
        w.hand.set(80.0);
        EXPECT_TRUE(soon([&] { return w.tile("LINK").startsWith("LOST"); }));
        int right = 0;
        for (const auto* tile : w.window.findChildren<StatusTileView*>()) {
            EXPECT_GE(tile->x(), right) << width;
            EXPECT_GE(tile->width(), tile->neededWidth(15)) << width;
            right = tile->geometry().right();
        }
        EXPECT_LT(right, w.button("Disconnect")->x()) << width;
    }
}

// The first words, where the window is at its narrowest; what follows them may be left out.
TEST(StatusStrip, CutsNoWordOfTrustInANarrowWindow) {
    const auto robotIs = [](SuspendReason reason) {
        return NamedStatus{"robot", {.state = HedrState::kSuspended, .reason = reason}};
    };
    for (const NamedStatus& status :
         {NamedStatus{"odometry", {}}, robotIs(SuspendReason::kSearching),
          robotIs(SuspendReason::kOffCorridors), robotIs(SuspendReason::kTurning)}) {
        WindowUser w;
        w.window.resize(1024, 640);
        LiveBatch batch = test::sampleBatch(1.0);
        batch.statuses = {status};
        w.window.setTrailChoice({.primary = status.name});
        w.hand.set(1.0);
        w.window.applyBatch(batch);
        for (const auto* tile : w.window.findChildren<StatusTileView*>()) {
            if (tile->accessibleName() != "TRUST") continue;
            const QString words = tile->toolTip().section('\n', 0, 0).section(" · ", 0, 0);
            EXPECT_FALSE(words.isEmpty());
            EXPECT_LE(figuresWidth(uiFont(13), words), tile->width() - 16) << words.toStdString();
        }
    }
}

}  // namespace
}  // namespace hedr
