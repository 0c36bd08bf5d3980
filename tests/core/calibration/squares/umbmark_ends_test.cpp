#include "core/calibration/squares/umbmark_ends.h"

#include <gtest/gtest.h>

namespace hedr {
namespace {

Error errorOf(std::string_view csv) {
    const auto ends = parseUmbmarkEnds(csv, "ends.csv");
    EXPECT_FALSE(ends) << csv;
    return ends ? Error{} : ends.error();
}

TEST(UmbmarkEnds, AreReadInAnyOrderOfRowsAndColumns) {
    const auto ends =
        parseUmbmarkEnds("y_m,run,x_m\n-0.1,2,0.3\n0.05,1,-0.2\n", "ends.csv").value();
    ASSERT_EQ(ends.size(), 2U);
    EXPECT_EQ(ends[0].run, 2U);
    EXPECT_EQ(ends[0].way, (Vector<Robot>{0.3, -0.1}));
    EXPECT_EQ(ends[1].run, 1U);
    EXPECT_FALSE(ends[0].said);
}

TEST(UmbmarkEnds, MaySayWhichWayWasDriven) {
    const auto ends = parseUmbmarkEnds(
                          "run,x_m,y_m,direction\n1,0,0,clockwise\n2,0,0,\n"
                          "3,0,0,counter-clockwise\n",
                          "ends.csv")
                          .value();
    EXPECT_EQ(ends[0].said, Turning::kClockwise);
    EXPECT_FALSE(ends[1].said);
    EXPECT_EQ(ends[2].said, Turning::kCounterClockwise);
}

TEST(UmbmarkEnds, NameTheLineThatIsWrong) {
    EXPECT_EQ(errorOf("run,x_m,y_m\n1,0,0\n2,left,0\n").subject, "ends.csv:3");
    EXPECT_EQ(errorOf("run,x_m,y_m\n1,0,nan\n").subject, "ends.csv:2");
    EXPECT_EQ(errorOf("run,x_m,y_m\n0,0,0\n").detail, "run must be a whole number from 1 on");
    EXPECT_EQ(errorOf("run,x_m,y_m\n,0,0\n").subject, "ends.csv:2");
    EXPECT_EQ(errorOf("run,x_m,y_m\n1.5,0,0\n").subject, "ends.csv:2");
    EXPECT_EQ(errorOf("run,x_m,y_m\n1,0,0\n1,0,0\n").detail, "run 1 twice");
    const Error direction = errorOf("run,x_m,y_m,direction\n1,0,0,left\n");
    EXPECT_EQ(direction.subject, "ends.csv:2");
    EXPECT_EQ(direction.detail, "direction must be clockwise or counter-clockwise");
}

TEST(UmbmarkEnds, NeedTheirColumns) {
    EXPECT_EQ(errorOf("run,x_m\n1,0\n").code, ErrorCode::kMissingColumn);
    EXPECT_EQ(errorOf("").code, ErrorCode::kFileEmpty);
    EXPECT_TRUE(parseUmbmarkEnds("run,x_m,y_m\n", "ends.csv").value().empty());
}

}  // namespace
}  // namespace hedr
