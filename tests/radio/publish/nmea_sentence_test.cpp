#include "radio/publish/nmea_sentence.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <sstream>

#include "tests/radio/publish/sample_pose.h"

namespace hedr {
namespace {

using test::samplePose;
using test::sampleTime;

constexpr const char* kNothing =
    "$GPRMC,090807.25,V,,,,,,,040526,,,N*79\r\n"
    "$GPGGA,090807.25,,,,,0,00,,,M,,M,,*49\r\n";

std::string first(const std::string& sentences) {
    return sentences.substr(0, sentences.find('\r'));
}

// The field of a sentence, 0 its name.
std::string field(const std::string& sentence, int index) {
    std::istringstream fields(sentence);
    std::string text;
    for (int i = 0; i <= index; ++i) std::getline(fields, text, ',');
    return text;
}

TEST(NmeaSentence, HasTheChecksumOfTheUsualExample) {
    EXPECT_EQ(nmeaSentence("GPGGA,123519,4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,"),
              "$GPGGA,123519,4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,*47\r\n");
}

TEST(NmeaSentence, TellsPlaceSpeedCourseAndHeading) {
    EXPECT_EQ(nmeaSentences(samplePose(), sampleTime(0.1)),
              "$GPRMC,090807.15,A,4808.24400,N,01134.53000,E,1.21,78.0,040526,,,E*57\r\n"
              "$GPGGA,090807.15,4808.24400,N,01134.53000,E,6,00,,,M,,M,,*70\r\n"
              "$GPHDT,78.0,T*0A\r\n");
}

TEST(NmeaSentence, SaysNothingOfAPlaceThatIsNotTrueNow) {
    EXPECT_EQ(nmeaSentences(std::nullopt, sampleTime(0.0)), kNothing);
    EXPECT_EQ(nmeaSentences(samplePose(), sampleTime(1.0)), kNothing) << "it is stale";
    PublishedPose pose = samplePose();
    pose.tie.reset();
    EXPECT_EQ(nmeaSentences(pose, sampleTime(0.1)), kNothing) << "it is not on the globe";
    pose = samplePose();
    pose.pose.heading_rad = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(nmeaSentences(pose, sampleTime(0.1)), kNothing);
    pose = samplePose();
    pose.pose.position.x = 1e9;
    EXPECT_EQ(nmeaSentences(pose, sampleTime(0.1)), kNothing) << "it is out of the tie's reach";
}

TEST(NmeaSentence, NeverHasSixtyMinutes) {
    EXPECT_EQ(nmeaLatitude(47.9999999999), "4800.00000,N");
    EXPECT_EQ(nmeaLatitude(-47.9999999999), "4800.00000,S");
    EXPECT_EQ(nmeaLatitude(48.0 - 1.0 / 60.0 * 1e-5), "4759.99999,N");
    EXPECT_EQ(nmeaLongitude(9.99999999999), "01000.00000,E");
}

TEST(NmeaSentence, KnowsItsHemispheres) {
    EXPECT_EQ(nmeaLatitude(-33.5), "3330.00000,S");
    EXPECT_EQ(nmeaLatitude(-1e-12), "0000.00000,N");
    EXPECT_EQ(nmeaLatitude(90.0), "9000.00000,N");
    EXPECT_EQ(nmeaLongitude(-0.25), "00015.00000,W");
    EXPECT_EQ(nmeaLongitude(179.9999999999), "18000.00000,E");
    EXPECT_EQ(nmeaLongitude(-179.9999999999), "18000.00000,W");
    EXPECT_EQ(nmeaLongitude(180.0), "18000.00000,E");
}

RC_GTEST_PROP(NmeaSentence, ReadsBackToTwoCentimetres, ()) {
    const double deg = 1e-9 * static_cast<double>(*rc::gen::inRange<std::int64_t>(-180'000'000'000,
                                                                                  180'000'000'001));
    const std::string text = nmeaLongitude(deg);
    RC_ASSERT(text.size() == 13U);
    const double minutes = std::atof(text.substr(3, 8).c_str());
    RC_ASSERT(minutes < 60.0);
    const double back = std::atof(text.substr(0, 3).c_str()) + minutes / 60.0;
    RC_ASSERT(std::abs((text.back() == 'W' ? -back : back) - deg) <= 0.5001e-5 / 60.0);
}

TEST(NmeaSentence, CrossesTheAntimeridian) {
    PublishedPose pose = samplePose();
    pose.tie = GeoTie{{0.0, 0.0}, {10.0, 179.9999}, 0.0};  // 11 m west of it
    pose.pose.position = {50.0, 0.0};
    const std::string sentence = first(nmeaSentences(pose, sampleTime(0.1)));
    EXPECT_EQ(field(sentence, 6), "W");
    EXPECT_EQ(field(sentence, 5).substr(0, 5), "17959");
}

TEST(NmeaSentence, TurnsTheCourseRoundWhereItDrivesBackwards) {
    PublishedPose pose = samplePose();
    pose.speed_m_s = -0.5;
    const std::string sentences = nmeaSentences(pose, sampleTime(0.1));
    EXPECT_EQ(field(sentences, 7), "0.97");
    EXPECT_EQ(field(sentences, 8), "258.0");
    EXPECT_NE(sentences.find("$GPHDT,78.0,T"), std::string::npos);
}

TEST(NmeaSentence, HasNoCourseOf360Degrees) {
    PublishedPose pose = samplePose();
    pose.pose.heading_rad = radFromDeg(78.0 + 0.01);
    EXPECT_EQ(field(nmeaSentences(pose, sampleTime(0.1)), 8), "0.0");
    pose.pose.heading_rad = radFromDeg(78.0) + 1e-17 + 20.0 * kPi;
    EXPECT_EQ(field(nmeaSentences(pose, sampleTime(0.1)), 8), "0.0");
}

TEST(NmeaSentence, CountsTheDayFromTheMomentOfThePose) {
    PublishTime time = sampleTime(0.5);
    time.utc = std::chrono::system_clock::time_point(std::chrono::seconds(1798761600));
    const std::string sentence = first(nmeaSentences(samplePose(), time));  // half a second before
    EXPECT_EQ(field(sentence, 1), "235959.50");
    EXPECT_EQ(field(sentence, 9), "311226");
}

TEST(NmeaSentence, FitsIntoTheLineThatTheStandardAllows) {
    PublishedPose pose = samplePose();
    pose.tie->at = {-48.1374, -171.5755};
    pose.speed_m_s = 99.99;
    std::istringstream lines(nmeaSentences(pose, sampleTime(0.1)));
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size() + 1, 82U) << line;
}

}  // namespace
}  // namespace hedr
