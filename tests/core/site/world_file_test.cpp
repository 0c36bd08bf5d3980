#include "core/site/world_file.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "core/geometry/angle.h"

namespace hedr {
namespace {

TEST(WorldFile, ReadsSixNumbersInTheOrderOfTheFormat) {
    const auto file = parseWorldFile("0.5\r\n0.1\r\n\n 0.1\n-0.5 \n+100\n2e2", "a.pgw");
    ASSERT_TRUE(file) << file.error().detail;
    EXPECT_EQ(*file, (WorldFile{0.5, 0.1, 0.1, -0.5, 100.0, 200.0}));
}

TEST(WorldFile, SpeaksOfTheCentreOfTheFirstPixel) {
    const auto placement = placementOf({0.5, 0.0, 0.0, -0.5, 100.0, 200.0}, 10, "a.pgw");
    ASSERT_TRUE(placement) << placement.error().detail;
    EXPECT_EQ(*placement, (PlanPlacement{0.5, {{99.75, 195.25}, 0.0}}));
}

RC_GTEST_PROP(WorldFile, ComesBackAsThePlacementThatWasWritten, ()) {
    const auto metres = [] { return 1e-3 * *rc::gen::inRange(-1000000, 1000000); };
    const PlanPlacement placement{1e-4 * *rc::gen::inRange(1, 100000),
                                  {{metres(), metres()}, 1e-4 * *rc::gen::inRange(-31000, 31000)}};
    const int height_px = *rc::gen::inRange(1, 10000);
    const auto text = worldFileText(worldFileOf(worldFromPlan(placement, height_px)));
    const auto read = parseWorldFile(text, "a.pgw");
    RC_ASSERT(read.has_value());
    const auto back = placementOf(*read, height_px, "a.pgw");
    RC_ASSERT(back.has_value());
    RC_ASSERT(std::abs(back->resolution_m / placement.resolution_m - 1.0) < 1e-12);
    RC_ASSERT((back->origin.position - placement.origin.position).length() < 1e-8);
    RC_ASSERT(std::abs(back->origin.heading_rad - placement.origin.heading_rad) < 1e-12);
}

struct Bad {
    const char* text;
    ErrorCode code;
    const char* where;
    const char* says;
};

TEST(WorldFile, SaysWhatIsWrongAndWhere) {
    for (const Bad& bad : {Bad{"", ErrorCode::kFileEmpty, "a.pgw", ""},
                           Bad{"1\n0\n0\n-1\n5\n", ErrorCode::kBadFormat, "a.pgw", "this one 5"},
                           Bad{"1\n0\n0\n-1\n5\n6\n7\n", ErrorCode::kBadFormat, "a.pgw:7", "six"},
                           Bad{"1\n0\nx\n-1\n5\n6\n", ErrorCode::kBadFormat, "a.pgw:3", "six"},
                           Bad{"1\n0\n0\nnan\n5\n6\n", ErrorCode::kBadValue, "a.pgw:4", "finite"},
                           Bad{"1\n0\n0\n-1\ninf\n6\n", ErrorCode::kBadValue, "a.pgw:5", "finite"},
                           Bad{"0\n0\n0\n-1\n5\n6\n", ErrorCode::kBadValue, "a.pgw", "no size"},
                           Bad{"1\n1\n1\n1\n5\n6\n", ErrorCode::kBadValue, "a.pgw", "no size"}}) {
        const auto file = parseWorldFile(bad.text, "a.pgw");
        ASSERT_FALSE(file) << bad.text;
        EXPECT_EQ(file.error().code, bad.code) << bad.text;
        EXPECT_EQ(file.error().subject, bad.where);
        EXPECT_NE(file.error().detail.find(bad.says), std::string::npos) << file.error().detail;
    }
}

TEST(WorldFile, IsNoPlacementWhereItMirrorsOrShears) {
    EXPECT_EQ(placementOf({1.0, 0.0, 0.0, 1.0}, 9, "a.pgw").error().detail,
              "the image is mirrored");
    EXPECT_EQ(placementOf({1.0, 0.0, 0.0, -1.1}, 9, "a.pgw").error().detail,
              "its pixels are not square");
    EXPECT_EQ(placementOf({1.0, 0.0, 0.1, -1.0}, 9, "a.pgw").error().detail,
              "its pixels are not square");
}

}  // namespace
}  // namespace hedr
