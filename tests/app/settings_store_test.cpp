#include "app/settings_store.h"

#include <gtest/gtest.h>

namespace hedr {
namespace {

TEST(SettingsStore, GivesBackWhatWasSaved) {
    const StoredSettings settings{.theme = "night",
                                  .window_geometry = "geometry",
                                  .primary_trail = "gyro",
                                  .shown_trails = {"gyro"},
                                  .hidden_trails = {"odometry", "robot"}};
    saveSettings(settings);
    EXPECT_EQ(loadSettings(), settings);
    saveSettings({});
    EXPECT_EQ(loadSettings(), StoredSettings{});
}

}  // namespace
}  // namespace hedr
