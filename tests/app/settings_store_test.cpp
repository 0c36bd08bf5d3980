#include "app/settings_store.h"

#include <gtest/gtest.h>

namespace hedr {
namespace {

TEST(SettingsStore, GivesBackWhatWasSaved) {
    const StoredSettings settings{.theme = "night",
                                  .window_geometry = "geometry",
                                  .primary_trail = "gyro",
                                  .shown_trails = {"gyro"},
                                  .hidden_trails = {"odometry", "robot"},
                                  .recent_plans = {"/plans/1.png", "/plans/0.pdf"},
                                  .declined_missions = {"/missions/a.hedr"}};
    saveSettings(settings);
    EXPECT_EQ(loadSettings(), settings);
    saveSettings({});
    EXPECT_EQ(loadSettings(), StoredSettings{});
}

TEST(SettingsStore, RemembersTheEightPlansThatWereOpenedLast) {
    saveSettings({});
    for (int i = 0; i < 10; ++i) rememberPlan(QStringLiteral("/plans/%1.png").arg(i));
    const QStringList plans = rememberPlan("/plans/../plans/5.png");
    EXPECT_EQ(plans.size(), 8);
    EXPECT_EQ(plans.front(), "/plans/5.png");
    EXPECT_EQ(plans[1], "/plans/9.png");
    EXPECT_EQ(plans.count("/plans/5.png"), 1);
    EXPECT_EQ(loadSettings().recent_plans, plans);
    saveSettings({});
}

TEST(SettingsStore, KeepsEachOpenMissionForItself) {
    const OpenMission first{"/missions/a b.hedr", 1, {.port = "/dev/ttyUSB0", .baud = 57600}};
    const OpenMission second{"/missions/a b-robot2.hedr", 2, {.port = "udp://:9000"}};
    rememberOpenMission(first);
    rememberOpenMission(second);
    saveSettings({});
    EXPECT_EQ(openMissions(), std::vector({second, first}));
    forgetOpenMission(second.file);
    EXPECT_EQ(openMissions(), std::vector({first}));
    forgetOpenMission(first.file);
    EXPECT_TRUE(openMissions().empty());
}

}  // namespace
}  // namespace hedr
