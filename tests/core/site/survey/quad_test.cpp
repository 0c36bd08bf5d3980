#include "core/site/survey/quad.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace hedr {
namespace {

std::string refusal(const Quad& quad) {
    const auto checked = checkQuad(quad);
    if (checked) return {};
    EXPECT_EQ(checked.error().code, ErrorCode::kBadValue);
    EXPECT_EQ(checked.error().subject, "corners");
    return checked.error().detail;
}

TEST(CheckQuad, TakesWhatAPhotoShowsOfASheet) {
    EXPECT_EQ(refusal({{{{10, 20}, {110, 20}, {110, 90}, {10, 90}}}}), "");
    EXPECT_EQ(refusal({{{{300, 120}, {900, 180}, {1100, 700}, {50, 640}}}}), "");
    EXPECT_EQ(refusal({{{{-30, -20}, {110, 20}, {110, 90}, {10, 90}}}}), "") << "beside the photo";
}

TEST(CheckQuad, SaysInPlainWordsWhyThereIsNoRectangle) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(refusal({{{{10, nan}, {110, 20}, {110, 90}, {10, 90}}}}),
              "a coordinate is not a number");
    EXPECT_EQ(refusal({{{{10, 20}, {110, 20}, {110, 20}, {10, 90}}}}),
              "the upper right and the lower right corner are less than 8 px apart");
    EXPECT_EQ(refusal({{{{10, 20}, {60, 20}, {110, 20}, {10, 90}}}}),
              "the upper left, upper right and lower right corner lie on a line");
    EXPECT_EQ(refusal({{{{0, 0}, {100, 0}, {30, 30}, {0, 100}}}}),
              "the lower right corner lies inside of the triangle of the others");
    EXPECT_EQ(refusal({{{{0, 100}, {30, 30}, {100, 0}, {0, 0}}}}),
              "the upper right corner lies inside of the triangle of the others");
    EXPECT_EQ(refusal({{{{10, 20}, {110, 90}, {110, 20}, {10, 90}}}}),
              "the sides cross, they must run around the plan in order");
    EXPECT_EQ(refusal({{{{110, 20}, {10, 20}, {10, 90}, {110, 90}}}}),
              "they run anticlockwise, the plan would be mirrored");
    EXPECT_EQ(refusal({{{{995, 10}, {1005, 10}, {2000, 900}, {0, 900}}}}),
              "the far side is almost at the horizon, too little of the plan is seen");
}

TEST(OrderedQuad, FindsTheOrderWhateverTheClicks) {
    for (const double angle_rad : {-0.7, -0.3, 0.0, 0.4, 0.75}) {
        std::array<Point<Plan>, 4> corners{{{-200, -100}, {220, -90}, {180, 120}, {-190, 130}}};
        for (Point<Plan>& p : corners) {
            p = {500 + std::cos(angle_rad) * p.x - std::sin(angle_rad) * p.y,
                 400 + std::sin(angle_rad) * p.x + std::cos(angle_rad) * p.y};
        }
        const Quad quad{corners};
        std::array<std::size_t, 4> order{0, 1, 2, 3};
        do {
            EXPECT_EQ(orderedQuad({corners[order[0]], corners[order[1]], corners[order[2]],
                                   corners[order[3]]}),
                      quad)
                << angle_rad;
        } while (std::ranges::next_permutation(order).found);
    }
}

}  // namespace
}  // namespace hedr
