#include "ui/panels/legend.h"

#include <gtest/gtest.h>

#include <QScrollBar>
#include <QTest>
#include <algorithm>

#include "ui/panels/legend_row.h"
#include "ui/trail_style.h"

namespace hedr {
namespace {

LiveBatch batchOf(const std::vector<std::string>& names) {
    LiveBatch batch;
    for (const std::string& name : names) batch.tracks.push_back({name, {TrackPoint{}}});
    return batch;
}

// As the window does it: wishes change the model, the model changes the legend.
class LegendOfTrails : public ::testing::Test {
  protected:
    LegendOfTrails() {
        map_.resize(800, 600);
        map_.show();
        map_.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&map_));
        QObject::connect(&legend_, &Legend::showWished, [this](const std::string& name, bool show) {
            robot_.model.showTrail(name, show);
            legend_.show(robot_, {});
        });
        QObject::connect(&legend_, &Legend::primaryWished, [this](const std::string& name) {
            robot_.model.choosePrimary(name);
            legend_.show(robot_, {});
        });
    }
    void hear(const std::vector<std::string>& names) {
        robot_.model.apply(batchOf(names), ReceiveClock::now());
        legend_.show(robot_, {});
    }
    void hearAll() {
        std::vector<std::string> names;
        for (const TrailStyle& style : trailStyles()) names.emplace_back(style.name);
        hear(names);
    }
    LegendRow* row(const std::string& name) const {
        for (auto* row : legend_.findChildren<LegendRow*>()) {
            if (row->trail() == name) return row;
        }
        return nullptr;
    }
    bool listed(const std::string& name) const { return row(name)->isVisible(); }
    bool shown(const std::string& name) const { return isShown(robot_.model.choice(), name); }
    QPushButton* more() const { return legend_.findChild<QPushButton*>(); }
    int listedRows() const {
        const auto rows = legend_.findChildren<LegendRow*>();
        return static_cast<int>(
            std::count_if(rows.begin(), rows.end(), [](auto* row) { return row->isVisible(); }));
    }

    FleetRobot robot_;
    QWidget map_;
    Legend legend_{&map_};
};

TEST_F(LegendOfTrails, ListsTheMainTrailsAndKeepsTheOthersBehindMore) {
    hear({"hedr_bayes", "odometry", "gyro", "hedr", "robot"});
    EXPECT_TRUE(listed("hedr_bayes") && listed("odometry") && listed("robot"));
    EXPECT_FALSE(listed("gyro") || listed("hedr"));
    EXPECT_EQ(more()->text(), "2 more");
    more()->click();
    ASSERT_TRUE(listed("gyro"));
    EXPECT_EQ(more()->text(), "Fewer");
    EXPECT_FALSE(shown("gyro"));
    row("gyro")->toggle()->click();
    EXPECT_TRUE(shown("gyro"));
    more()->click();
    EXPECT_TRUE(listed("gyro")) << "what is shown is listed";
    EXPECT_FALSE(listed("hedr"));
}

TEST_F(LegendOfTrails, HasNoMoreWhereNothingIsHidden) {
    hear({"hedr_bayes", "odometry"});
    EXPECT_FALSE(more()->isVisible());
    EXPECT_EQ(row("gyro"), nullptr) << "only what has points is listed";
}

TEST_F(LegendOfTrails, LetsASecondClickUndoTheFirst) {
    hear({"hedr_bayes", "odometry"});
    row("odometry")->toggle()->click();
    EXPECT_FALSE(shown("odometry"));
    ASSERT_TRUE(listed("odometry"));
    row("odometry")->toggle()->click();
    EXPECT_TRUE(shown("odometry"));
}

TEST_F(LegendOfTrails, ANewTrailDoesNotBringHiddenOnesBack) {
    hear({"hedr_bayes", "odometry"});
    row("odometry")->toggle()->click();
    hear({"robot"});
    EXPECT_FALSE(shown("odometry"));
    EXPECT_FALSE(row("odometry")->toggle()->isChecked());
}

TEST_F(LegendOfTrails, MarksOneTrailAsPrimaryAndMakesAnotherOneSo) {
    hear({"hedr_bayes", "odometry", "robot"});
    EXPECT_TRUE(row("hedr_bayes")->mark()->isChecked());
    row("odometry")->mark()->click();
    EXPECT_EQ(robot_.model.primary()->name, "odometry");
    EXPECT_TRUE(row("odometry")->mark()->isChecked());
    EXPECT_FALSE(row("hedr_bayes")->mark()->isChecked());
    row("odometry")->mark()->click();
    EXPECT_TRUE(row("odometry")->mark()->isChecked()) << "a second click changes nothing";
    EXPECT_EQ(row("odometry")->toggle()->accessibleDescription(), "primary");
    EXPECT_TRUE(row("robot")->toggle()->accessibleDescription().contains("apart"));
}

TEST_F(LegendOfTrails, DoesNotLetAHiddenTrailCarryTheRobot) {
    hear({"hedr_bayes", "odometry", "gyro"});
    more()->click();
    EXPECT_FALSE(row("gyro")->mark()->isEnabled());
    row("gyro")->mark()->click();
    EXPECT_EQ(robot_.model.primary()->name, "hedr_bayes");
    row("gyro")->toggle()->click();
    EXPECT_TRUE(row("gyro")->mark()->isEnabled());
}

TEST_F(LegendOfTrails, SaysWhichTrailHasLostTheBuilding) {
    LiveBatch batch = batchOf({"hedr_bayes", "odometry", "robot"});
    batch.statuses = {{"robot", {.state = HedrState::kActive, .lost = true}}};
    robot_.model.apply(batch, ReceiveClock::now());
    legend_.show(robot_, {});
    EXPECT_EQ(row("robot")->toggle()->accessibleDescription(), "LOST LOCK");
    EXPECT_TRUE(row("odometry")->toggle()->accessibleDescription().contains("apart"));
}

TEST_F(LegendOfTrails, IsWorkedByKeys) {
    hear({"hedr_bayes", "odometry", "robot"});
    row("hedr_bayes")->mark()->setFocus();
    const auto tab = [] { QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab); };
    tab();
    EXPECT_EQ(QApplication::focusWidget(), row("hedr_bayes")->toggle());
    tab();
    ASSERT_EQ(QApplication::focusWidget(), row("robot")->mark());
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
    EXPECT_EQ(robot_.model.primary()->name, "robot");
    tab();
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
    EXPECT_FALSE(shown("robot"));
    EXPECT_EQ(robot_.model.primary()->name, "robot") << "any set may be shown";
}

TEST_F(LegendOfTrails, HasTargetsAsLargeAsTheOtherButtons) {
    hear({"hedr_bayes", "odometry"});
    for (const bool compact : {false, true}) {
        legend_.setCompact(compact);
        for (auto* button : legend_.findChildren<LegendButton*>()) {
            EXPECT_GE(button->width(), 48) << button->accessibleName().toStdString();
            EXPECT_GE(button->height(), 48) << button->accessibleName().toStdString();
        }
    }
}

TEST_F(LegendOfTrails, HasRoomForRowsThatComeWhileItIsInSight) {
    hear({"hedr_bayes", "odometry"});
    const int before = legend_.height();
    hear({"robot"});
    ASSERT_TRUE(legend_.isVisible());
    EXPECT_EQ(legend_.height(), before + LegendRow::kHeight_px);
    EXPECT_GE(legend_.width(), row("robot")->sizeHint().width() + 16);
}

TEST_F(LegendOfTrails, IsNarrowerWhereTheMapIsNarrow) {
    hear({"hedr_bayes", "odometry", "robot"});
    const QSize before = legend_.size();
    legend_.setCompact(true);
    EXPECT_LT(legend_.width(), before.width() - 60);
    EXPECT_GE(legend_.width(), row("robot")->sizeHint().width() + 16);
}

TEST_F(LegendOfTrails, ScrollsWhatDoesNotFit) {
    hearAll();
    legend_.setMostHeight(300);
    EXPECT_LE(legend_.height(), 300);
    more()->click();
    EXPECT_EQ(listedRows(), static_cast<int>(trailStyles().size()));
    EXPECT_LE(legend_.height(), 300);
    EXPECT_LE(more()->geometry().bottom(), legend_.height());
    auto* bar = legend_.findChild<QScrollArea*>()->verticalScrollBar();
    EXPECT_TRUE(bar->isVisible());
    row(trailStyles().front().name)->mark()->setFocus();
    for (std::size_t i = 0; i < 2 * trailStyles().size(); ++i) {
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        auto* focus = QApplication::focusWidget();
        if (focus == more()) break;
        EXPECT_FALSE(focus->visibleRegion().isEmpty()) << focus->accessibleName().toStdString();
    }
    EXPECT_GT(bar->value(), 0);
}

}  // namespace
}  // namespace hedr
