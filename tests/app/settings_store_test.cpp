#include "app/settings_store.h"

#include <gtest/gtest.h>

namespace hedr {
namespace {

TEST(SettingsStore, GivesBackWhatWasSaved) {
    const StoredSettings settings{.theme = "night", .window_geometry = "geometry"};
    saveSettings(settings);
    EXPECT_EQ(loadSettings(), settings);
}

}  // namespace
}  // namespace hedr
