#include "radio/publish/json_line.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "tests/radio/publish/sample_pose.h"

namespace hedr {
namespace {

using test::samplePose;
using test::sampleTime;

// By another reader than the writer's own.
nlohmann::json objectOf(const PublishedPose& pose, double seconds) {
    const auto line = jsonLine(pose, sampleTime(seconds));
    EXPECT_TRUE(line);
    EXPECT_EQ(line->count('\n'), 1) << line->toStdString();
    EXPECT_TRUE(line->endsWith('\n'));
    return nlohmann::json::parse(line->toStdString());
}

TEST(JsonLine, HasEveryKeyInSi) {
    const nlohmann::json object = objectOf(samplePose(), 0.1);
    const auto wanted = nlohmann::json::parse(R"({
        "call_sign": "Robot 1", "time": "2026-05-04T09:08:07.150Z", "age_s": 0.1, "link": "live",
        "x_m": 12.5, "y_m": -3.25, "heading_rad": 0, "speed_m_s": 0.62, "trust": "good",
        "estimator": "hedr_bayes", "floor": "Ground", "var_x_m2": 0.25, "cov_xy_m2": 0,
        "var_y_m2": 0.039999999, "var_heading_rad2": 0.0025, "latitude_deg": 48.1374,
        "longitude_deg": 11.5755, "bearing_deg": 78})");
    EXPECT_EQ(object, wanted) << object.dump(1);
}

TEST(JsonLine, SaysHowOldItIs) {
    EXPECT_EQ(objectOf(samplePose(), 0.999)["link"], "live");
    EXPECT_EQ(objectOf(samplePose(), 1.0)["link"], "stale");
    const nlohmann::json lost = objectOf(samplePose(), 3.5);
    EXPECT_EQ(lost["link"], "lost");
    EXPECT_EQ(lost["age_s"], 3.5);
    EXPECT_EQ(lost["time"], "2026-05-04T09:08:03.750Z");
}

TEST(JsonLine, LeavesOutWhatIsNotKnown) {
    PublishedPose pose = samplePose();
    pose.tie.reset();
    pose.variance = {};
    pose.floor.clear();
    const nlohmann::json object = objectOf(pose, 0.1);
    for (const char* key : {"latitude_deg", "longitude_deg", "bearing_deg", "var_x_m2", "floor"}) {
        EXPECT_FALSE(object.contains(key)) << key;
    }
    EXPECT_EQ(object["x_m"], 12.5);
}

TEST(JsonLine, OfAPoseThatIsNoNumberIsNone) {
    PublishedPose pose = samplePose();
    pose.speed_m_s = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(jsonLine(pose, sampleTime(0.1)));
}

TEST(JsonLine, StaysOneLineOfJsonWhateverTheRobotIsCalled) {
    PublishedPose pose = samplePose();
    pose.call_sign = "\"},\\\r\n\x01\x7F\xC3(\xE2\x80\xAE";
    EXPECT_EQ(objectOf(pose, 0.1)["call_sign"], "\"},\\    \xEF\xBF\xBD(\xEF\xBF\xBD");
}

}  // namespace
}  // namespace hedr
