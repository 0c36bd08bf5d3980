#include "core/reproduction/papers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hedr {
namespace {

const Figure& figure(const Reproduction& reproduction, std::string_view name) {
    const auto found = std::find_if(reproduction.figures.begin(), reproduction.figures.end(),
                                    [name](const Figure& each) { return each.name == name; });
    if (found == reproduction.figures.end()) {
        ADD_FAILURE() << "no figure " << name;
        return reproduction.figures.front();
    }
    return *found;
}

double ours(const Reproduction& reproduction, std::string_view name) {
    return figure(reproduction, name).ours.value();
}

TEST(Papers, AreFoundByName) {
    for (const Paper& paper : paperTable()) EXPECT_EQ(findPaper(paper.name), &paper);
    EXPECT_EQ(findPaper("moon"), nullptr);
}

TEST(Papers, GiveTheSameFiguresAgainAndTellTheirProgress) {
    for (const Paper& paper : paperTable()) {
        int last = 0;
        int end = -1;
        const ReproductionOptions once{.seeds = 1, .progress = [&](int done, int total) {
                                           EXPECT_EQ(done, last + 1) << paper.name;
                                           last = done;
                                           end = total;
                                       }};
        const Reproduction first = paper.reproduce(once);
        EXPECT_EQ(last, end) << paper.name;
        const Reproduction second = paper.reproduce({.seeds = 1});
        ASSERT_EQ(first.figures.size(), second.figures.size());
        for (std::size_t i = 0; i < first.figures.size(); ++i) {
            EXPECT_EQ(first.figures[i].ours, second.figures[i].ours) << first.figures[i].name;
            EXPECT_TRUE(std::isfinite(first.figures[i].ours.value_or(0.0)));
        }
        EXPECT_FALSE(first.remarks.empty()) << paper.name;
    }
}

// A number alone does not tell why.
TEST(Papers, SayWhyWhereTheyDisagreeOrAreSetToMatch) {
    for (const Paper& paper : paperTable()) {
        for (const Figure& each : paper.reproduce({.seeds = 5}).figures) {
            EXPECT_TRUE(!each.needsReason() || !each.note.empty())
                << paper.name << ": " << each.name;
        }
    }
}

TEST(Figure, AgreesOnlyWhereThereIsSomethingToAgreeWith) {
    EXPECT_FALSE((Figure{.name = "a", .place = "", .paper = "", .ours = 1.0}).agrees());
    Figure open{.name = "a",
                .place = "",
                .paper = "",
                .ours = {},
                .unit = "",
                .agrees_within = atLeast(2.0)};
    EXPECT_FALSE(open.agrees().has_value());
    EXPECT_TRUE(open.needsReason());
    open.ours = 2.0;
    EXPECT_EQ(open.agrees(), true);
    EXPECT_FALSE(open.needsReason());
    open.set_to_match = true;
    EXPECT_TRUE(open.needsReason());
    open.set_to_match = false;
    open.ours = 1.9;
    EXPECT_EQ(open.agrees(), false);
    EXPECT_TRUE(open.needsReason());
}

TEST(Gyrodometry1996, KeepsTheHeadingOverFifteenBumps) {
    const Reproduction paper = reproduceGyrodometry({});
    EXPECT_LE(ours(paper, "the same, worst seed"), 0.5);
    EXPECT_GE(ours(paper, "odometry over gyrodometry"), 18.0);
    EXPECT_GE(ours(paper, "gyro over gyrodometry"), 8.0);
    EXPECT_TRUE(figure(paper, "odometry: heading error at the end").set_to_match);
}

TEST(GyroErrorModel1994, KeepsTheHeadingForTenMinutes) {
    const Reproduction paper = reproduceGyroErrorModel({});
    EXPECT_EQ(figure(paper, "gyro, nothing taken off: drift").agrees(), true);
    EXPECT_LE(ours(paper, "the same, worst seed"), 5.0);
    EXPECT_GE(ours(paper, "gain over the gyro, nothing taken off"), 7.0);
    EXPECT_GE(ours(paper, "gain over the gyro less its standing bias"), 5.0);
    EXPECT_FALSE(figure(paper, "fit: C1").agrees().has_value());
}

TEST(Umbmark1996, FindsTheErrorsThatWerePutInAndGainsAnOrderOfMagnitude) {
    const Reproduction paper = reproduceUmbmark({});
    EXPECT_NEAR(ours(paper, "E_d, found (1.002 was put in)"), 1.002, 0.0002);
    EXPECT_NEAR(ours(paper, "E_b, found (1.005 was put in)"), 1.005, 0.001);
    EXPECT_GE(ours(paper, "before over after"), 10.0);
    EXPECT_NEAR(ours(paper, "E_b, least squares"), 1.005, 0.0001);
    EXPECT_GE(ours(paper, "before over after, least squares"),
              2.0 * ours(paper, "before over after"));
}

TEST(GhFusion2019, PredictsWhatAWrongWheelbaseCostsPlainOdometry) {
    const Reproduction paper = reproduceGhFusion({.seeds = 5});
    for (const char* name :
         {"wheelbase +4 mm", "wheelbase -4 mm", "wheelbase +8 mm", "wheelbase -8 mm"}) {
        const Figure& each = figure(paper, std::string(name) + ": odometry");
        EXPECT_NEAR(*each.ours, std::stod(each.paper), 0.25 * std::stod(each.paper)) << name;
    }
}

// The paper's prose says 4 of 5 and 3 of 4.
TEST(GhFusion2019, CountsWhatThePapersOwnTablesShow) {
    const Reproduction paper = reproduceGhFusion({.seeds = 1});
    EXPECT_EQ(figure(paper, "gh_combined better than odometry, wheelbase").paper, "1 of 4");
    EXPECT_EQ(figure(paper, "gh_combined better than odometry, wheels").paper, "3 of 4");
}

TEST(Hedr2010, IsAnOrderOfMagnitudeBetterInCorridors) {
    const Reproduction paper = reproduceHedr({.seeds = 5});
    EXPECT_GE(ours(paper, "corridors: gyro over hedr_bayes"), 10.0);
    EXPECT_EQ(figure(paper, "corridors: heading error, hedr").agrees(), true);
}

}  // namespace
}  // namespace hedr
