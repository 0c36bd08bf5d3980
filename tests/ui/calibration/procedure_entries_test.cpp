#include "ui/calibration/procedure_entries.h"

#include <gtest/gtest.h>

namespace hedr {
namespace {

TEST(ProcedureEntries, AreThoseThatCountForTheProcedure) {
    EXPECT_TRUE(procedureEntries(*findProcedure("gyro-bias"), {}).empty());
    const auto entries = procedureEntries(*findProcedure("gyro-scale"), {});
    ASSERT_EQ(entries.size(), 1U);
    EXPECT_EQ(entries[0].label, "Turns each time");
    EXPECT_EQ(entries[0].empty_means, "counted");
}

TEST(ProcedureEntries, AreTakenAsNumbersWithPointOrComma) {
    const Procedure& scale = *findProcedure("gyro-scale");
    EXPECT_EQ(settingsTyped(scale, {" 2 "}).turns, 2.0);
    EXPECT_EQ(settingsTyped(scale, {"2,0"}).turns, 2.0);
    EXPECT_EQ(settingsTyped(scale, {}).turns, std::nullopt);
    EXPECT_EQ(settingsTyped(*findProcedure("allan"), {"2"}).turns, std::nullopt);
}

TEST(ProcedureEntries, AskWhetherTheRoomMayChange) {
    const Procedure& warmup = *findProcedure("warmup");
    const auto entries = procedureEntries(warmup, {"2", kSwitchedOn.toString()});
    ASSERT_EQ(entries.size(), 2U);
    EXPECT_FALSE(entries[0].is_switch);
    EXPECT_TRUE(entries[1].is_switch);
    EXPECT_EQ(entries[1].text, kSwitchedOn);
    EXPECT_FALSE(settingsTyped(warmup, {"2"}).room_changes);
    EXPECT_FALSE(settingsTyped(warmup, {"2", ""}).room_changes);
    const ProcedureSettings both = settingsTyped(warmup, {"2", kSwitchedOn.toString()});
    EXPECT_TRUE(both.room_changes);
    EXPECT_EQ(both.on_before_s, 120.0);
}

TEST(ProcedureEntries, SayWhatIsNoNumberAndDoNotTakeIt) {
    const Procedure& scale = *findProcedure("gyro-scale");
    for (const char* wrong : {"two", "0", "-1", "nan"}) {
        EXPECT_EQ(procedureEntries(scale, {wrong})[0].label,
                  "Turns each time: a number above 0, please");
        EXPECT_EQ(procedureEntries(scale, {wrong})[0].text, wrong);
        EXPECT_EQ(settingsTyped(scale, {wrong}).turns, std::nullopt);
    }
}

TEST(ProcedureEntries, AskForTheEndOfOneRunAfterAnother) {
    const Procedure& squares = *findProcedure("umbmark");
    ASSERT_EQ(procedureEntries(squares, {}).size(), 2U);
    EXPECT_EQ(procedureEntries(squares, {})[1].label, "Run 1 ended at x y, m");
    const QStringList typed{"", "0.12 -0.03", "0,2; 0.1", "0.3", ""};
    const auto entries = procedureEntries(squares, typed);
    ASSERT_EQ(entries.size(), 5U);
    EXPECT_EQ(entries[3].label, "Run 3 ended at x y, m: two numbers, please");
    EXPECT_EQ(entries[4].label, "Run 4 ended at x y, m");
    const auto ends = settingsTyped(squares, typed).ends;
    ASSERT_EQ(ends.size(), 2U);
    EXPECT_EQ(ends[1].run, 2U);
    EXPECT_DOUBLE_EQ(ends[1].way.x, 0.2);
    EXPECT_DOUBLE_EQ(ends[1].way.y, 0.1);
}

TEST(ProcedureEntries, AskForTheFloorWhereItMatters) {
    const Procedure& wheels = *findProcedure("wheels");
    const auto entries = procedureEntries(wheels, {" carpet ", "10"}, {"carpet", "tiles"});
    EXPECT_EQ(entries[0].label, "Floor");
    EXPECT_EQ(entries[0].known, (QStringList{"carpet", "tiles"}));
    EXPECT_EQ(surfaceTyped(wheels, {" carpet ", "10"}), "carpet");
    EXPECT_EQ(settingsTyped(wheels, {" carpet ", "10"}).distance_m, 10.0);
    EXPECT_EQ(firstTyped(wheels, "tiles"), QStringList{"tiles"});
    EXPECT_TRUE(firstTyped(*findProcedure("gyro-scale"), "tiles").isEmpty());
    EXPECT_EQ(surfaceTyped(*findProcedure("gyro-scale"), {"2"}), "");
}

TEST(ProcedureEntries, TakeEndsFromTheMapToTheMillimetre) {
    const Procedure& squares = *findProcedure("umbmark");
    const std::vector<UmbmarkEnd> clicked{{1, {0.1234, -0.0301}}, {4, {-0.2, 0.0}}};
    const QStringList typed = withEnds(squares, {"tiles", "0.5 0.5", "0.1 0.1"}, {}, clicked);
    EXPECT_EQ(typed, (QStringList{"tiles", "0.123 -0.030", "0.1 0.1", "", "-0.200 0.000"}));
    EXPECT_EQ(settingsTyped(squares, typed).ends.size(), 3U);
    EXPECT_EQ(runsTyped(squares, typed), 4U);
    EXPECT_EQ(withoutEnds(squares, typed), QStringList{"tiles"});
}

TEST(ProcedureEntries, KeepWhatWasTypedInsteadOfAClick) {
    const Procedure& squares = *findProcedure("umbmark");
    const std::vector<UmbmarkEnd> before{{1, {0.1, 0.1}}, {2, {0.2, 0.2}}, {3, {0.3, 0.3}}};
    const std::vector<UmbmarkEnd> after{{1, {0.1, 0.1}}, {2, {0.25, 0.2}}};
    const QStringList typed{"", "0.11 0.1", "0.200 0.200", "0.300 0.300"};
    EXPECT_EQ(withEnds(squares, typed, before, after),
              (QStringList{"", "0.11 0.1", "0.250 0.200", ""}));
}

}  // namespace
}  // namespace hedr
