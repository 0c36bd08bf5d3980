#include "app/appearance.h"

#include <gtest/gtest.h>

#include <QTest>

#include "app/settings_store.h"
#include "ui/main_window.h"
#include "ui/panels/legend.h"
#include "ui/panels/legend_row.h"

namespace hedr {
namespace {

LegendRow* row(const MainWindow& window, const std::string& trail) {
    for (auto* row : window.findChildren<LegendRow*>()) {
        if (row->trail() == trail) return row;
    }
    return nullptr;
}

// A window of one start of the program, with a robot that gives these trails.
class Start {
  public:
    explicit Start(const std::vector<std::string>& trails) {
        rememberAppearance(window);
        window.show();
        LiveBatch batch;
        for (const std::string& name : trails) batch.tracks.push_back({name, {TrackPoint{}}});
        window.applyBatch(batch);
    }
    MainWindow window;
};

TEST(Appearance, RemembersTheTrailsFromOneStartToTheNext) {
    saveSettings({});
    {
        Start first({"hedr_bayes", "odometry", "gyro"});
        EXPECT_TRUE(row(first.window, "hedr_bayes")->state().primary);
        row(first.window, "gyro")->toggle()->click();
        row(first.window, "gyro")->mark()->click();
        row(first.window, "hedr_bayes")->toggle()->click();
    }
    {
        const Start without_gyro({"hedr_bayes", "odometry"});
        EXPECT_TRUE(row(without_gyro.window, "hedr_bayes")->state().primary);
        EXPECT_FALSE(row(without_gyro.window, "hedr_bayes")->state().shown);
    }
    const Start again({"hedr_bayes", "odometry", "gyro"});
    EXPECT_TRUE(row(again.window, "gyro")->state().primary);
    EXPECT_TRUE(row(again.window, "gyro")->state().shown);
    EXPECT_FALSE(row(again.window, "hedr_bayes")->state().shown);
    EXPECT_TRUE(row(again.window, "odometry")->state().shown) << "as it is at first";
}

}  // namespace
}  // namespace hedr
