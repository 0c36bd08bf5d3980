#include "ui/panels/legend.h"

#include <gtest/gtest.h>

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
        QObject::connect(&legend_, &Legend::trailHidden,
                         [this](const std::string& name, bool hidden) { hidden_[name] = hidden; });
    }
    void hear(const std::vector<std::string>& names) {
        model_.apply(batchOf(names), ReceiveClock::now());
        legend_.show(model_);
    }

    LiveModel model_;
    Legend legend_;
    std::map<std::string, bool> hidden_;
};

TEST_F(LegendOfTrails, ShowsTheMainTrailsAndKeepsTheOthersReady) {
    hear({"hedr", "odometry", "gyro", "robot"});
    EXPECT_FALSE(hidden_.at("hedr"));
    EXPECT_FALSE(hidden_.at("odometry"));
    EXPECT_TRUE(hidden_.at("gyro"));
    rowOf(legend_, "gyro")->click();
    EXPECT_FALSE(hidden_.at("gyro"));
}

TEST_F(LegendOfTrails, ANewTrailDoesNotBringHiddenOnesBack) {
    hear({"hedr", "odometry"});
    rowOf(legend_, "odometry")->click();
    hear({"robot"});
    EXPECT_TRUE(hidden_.at("odometry"));
    EXPECT_FALSE(rowOf(legend_, "odometry")->isChecked());
}

}  // namespace
}  // namespace hedr
