#include "ui/panels/legend.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace hedr {
namespace {

LiveBatch batchOf(const std::vector<std::string>& names) {
    LiveBatch batch;
    for (const std::string& name : names) batch.tracks.push_back({name, {TrackPoint{}}});
    return batch;
}

QAbstractButton* rowOf(const Legend& legend, const std::string& name) {
    for (LegendRow* row : legend.findChildren<LegendRow*>()) {
        if (row->name() == name) return row;
    }
    return nullptr;
}

class LegendOfTrails : public ::testing::Test {
  protected:
    LegendOfTrails() {
        map_.show();
        QObject::connect(&legend_, &Legend::trailHidden,
                         [this](const std::string& name, bool hidden) { hidden_[name] = hidden; });
    }
    void hear(const std::vector<std::string>& names) {
        model_.apply(batchOf(names), ReceiveClock::now());
        legend_.show(model_);
    }

    LiveModel model_;
    QWidget map_;
    Legend legend_{&map_};
    std::map<std::string, bool> hidden_;
};

TEST_F(LegendOfTrails, ShowsTheMainTrailsAndKeepsTheOthersReady) {
    hear({"hedr_bayes", "odometry", "gyro", "robot"});
    EXPECT_FALSE(hidden_.at("hedr_bayes"));
    EXPECT_FALSE(hidden_.at("odometry"));
    EXPECT_TRUE(hidden_.at("gyro"));
    rowOf(legend_, "gyro")->click();
    EXPECT_FALSE(hidden_.at("gyro"));
}

TEST_F(LegendOfTrails, ANewTrailDoesNotBringHiddenOnesBack) {
    hear({"hedr_bayes", "odometry"});
    rowOf(legend_, "odometry")->click();
    hear({"robot"});
    EXPECT_TRUE(hidden_.at("odometry"));
    EXPECT_FALSE(rowOf(legend_, "odometry")->isChecked());
}

int needed_px(const Legend& legend, bool across) {
    int all = 0;
    for (const LegendRow* row : legend.findChildren<LegendRow*>()) {
        const QSize size = row->sizeHint();
        all = across ? std::max(all, size.width()) : all + size.height();
    }
    return all;
}

TEST_F(LegendOfTrails, HasRoomForRowsThatComeWhileItIsInSight) {
    hear({"hedr_bayes", "odometry", "gyro"});
    hear({"robot"});
    ASSERT_TRUE(legend_.isVisible());
    EXPECT_EQ(legend_.findChildren<LegendRow*>().size(), 4);
    EXPECT_GT(legend_.height(), needed_px(legend_, false));
    EXPECT_GT(legend_.width(), needed_px(legend_, true));
}

TEST_F(LegendOfTrails, IsSmallerWhereTheMapIsNarrow) {
    hear({"hedr_bayes", "odometry", "gyro", "robot"});
    const QSize before = legend_.size();
    legend_.setCompact(true);
    EXPECT_LT(legend_.width(), before.width() - 60);
    EXPECT_LT(legend_.height(), before.height());
    EXPECT_GT(legend_.height(), needed_px(legend_, false));
    EXPECT_GT(legend_.width(), needed_px(legend_, true));
    hear({"gyrodometry"});
    EXPECT_GT(legend_.height(), needed_px(legend_, false));
}

}  // namespace
}  // namespace hedr
