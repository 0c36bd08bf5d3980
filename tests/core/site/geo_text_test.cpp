#include "core/site/geo_text.h"

#include <gtest/gtest.h>

namespace hedr {
namespace {

TEST(LatLonFromText, TakesWhatPeopleCopy) {
    for (const char* text :
         {"52.2197, 21.0122", "52.2197,21.0122", "52.2197 21.0122", " 52.2197\t21.0122 ",
          "52.2197;21.0122", "52,2197; 21,0122", "52.2197 N 21.0122 E", "52.2197N, 21.0122E",
          "N 52.2197 E 21.0122", "21.0122E 52.2197N", "52.2197° N, 21.0122° E", "52,2197N 21,0122E",
          "52°13'10.92\"N 21°0'43.92\"E", "52° 13′ 10.92″ N, 21° 00′ 43.92″ E",
          "n52 13 10.92 e21 0 43.92"}) {
        const auto at = latLonFromText(text);
        ASSERT_TRUE(at) << text;
        EXPECT_NEAR(at->latitude_deg, 52.2197, 1e-9) << text;
        EXPECT_NEAR(at->longitude_deg, 21.0122, 1e-9) << text;
    }
}

TEST(LatLonFromText, KnowsSouthAndWest) {
    for (const char* text : {"-33.5, -70.25", "33.5 S 70.25 W", "33°30'S 70°15'W", "−33.5, −70.25",
                             "-33 30 0; -70 15 0"}) {
        const auto at = latLonFromText(text);
        ASSERT_TRUE(at) << text;
        EXPECT_NEAR(at->latitude_deg, -33.5, 1e-9) << text;
        EXPECT_NEAR(at->longitude_deg, -70.25, 1e-9) << text;
    }
}

TEST(LatLonFromText, KeepsTheMinusOfNoDegrees) {
    EXPECT_NEAR(latLonFromText("-0 30 0; 10").value().latitude_deg, -0.5, 1e-12);
}

TEST(LatLonFromText, RefusesWhatIsNoPlace) {
    for (const char* text : {"",
                             "52",
                             "nowhere",
                             "91, 0",
                             "0, 181",
                             "52.2197 N 21.0122 N",
                             "52.2197 E 21.0122 E",
                             "1 2 3",
                             "nan, nan",
                             "inf, 0",
                             "52 61 0 N 21 0 0 E",
                             "N",
                             "NE",
                             "52 N",
                             ",",
                             ";",
                             "1,2,3",
                             "52 -10 0 N 21 E",
                             "-33.9 S, 18 E",
                             "52.5 30 N 21 E"}) {
        const auto at = latLonFromText(text);
        ASSERT_FALSE(at) << text;
        EXPECT_EQ(at.error().code, ErrorCode::kBadValue);
    }
    EXPECT_FALSE(latLonFromText(std::string(100000, '1')));
}

TEST(WorldPointFromText, TakesMetresAndPlacesOnTheGlobe) {
    const GeoTie tie{{10.0, 20.0}, {52.2197, 21.0122}, 0.0};
    for (const char* text : {"12.5, -3.2", "12.5 m, -3.2 m", "12,5; -3,2", "12.5 -3.2"}) {
        const auto point = worldPointFromText(text, std::nullopt);
        ASSERT_TRUE(point) << text;
        EXPECT_EQ(*point, (Point<World>{12.5, -3.2})) << text;
    }
    const auto tied = worldPointFromText("52.2197 N, 21.0122 E", tie);
    ASSERT_TRUE(tied);
    EXPECT_NEAR((*tied - tie.point).length(), 0.0, 1e-6);
    EXPECT_EQ(worldPointFromText("52.2197° 21.0122°", std::nullopt).error().code,
              ErrorCode::kNoData);
    for (const char* text : {"", "12.5", "a, b", "nan, 1", "1e300, 0", "1 2 3", "12 13 0; 4"}) {
        const auto point = worldPointFromText(text, tie);
        ASSERT_FALSE(point) << text;
        EXPECT_EQ(point.error().code, ErrorCode::kBadValue) << text;
    }
}

TEST(LatLonText, IsReadBack) {
    const LatLon at{-33.4567891, 151.2};
    EXPECT_EQ(latLonText(at), "-33.4567891, 151.2000000");
    EXPECT_EQ(latLonFromText(latLonText(at)).value(), at);
}

}  // namespace
}  // namespace hedr
