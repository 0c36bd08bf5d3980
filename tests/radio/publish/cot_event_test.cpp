#include "radio/publish/cot_event.h"

#include <gtest/gtest.h>

#include <QXmlStreamReader>
#include <limits>
#include <map>

#include "tests/radio/publish/sample_pose.h"

namespace hedr {
namespace {

using test::samplePose;
using test::sampleTime;

const QByteArray kStation = "station";

// "point.lat" and the like, and what stands between the tags.
std::map<QString, QString> valuesOf(const QByteArray& event) {
    std::map<QString, QString> values;
    QXmlStreamReader xml(event);
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) continue;
        const QString name = xml.name().toString();
        for (const auto& each : xml.attributes()) {
            values[name + '.' + each.name().toString()] = each.value().toString();
        }
        if (name == QLatin1String("remarks")) values[name] = xml.readElementText();
    }
    EXPECT_FALSE(xml.hasError()) << event.toStdString();
    return values;
}

TEST(CotEvent, IsAsTheSchemaSays) {
    const auto event = cotEvent(samplePose(), sampleTime(0.1), kStation);
    ASSERT_TRUE(event);
    EXPECT_EQ(event->toStdString(),
              R"(<?xml version="1.0" encoding="UTF-8"?><event version="2.0" )"
              R"(uid="hedr-e394387f-4816-5e31-8818-cf9e24530919" type="a-f-G-E-V" how="m-n" )"
              R"(time="2026-05-04T09:08:07.250Z" start="2026-05-04T09:08:07.150Z" )"
              R"(stale="2026-05-04T09:08:10.150Z"><point lat="48.13740000" lon="11.57550000" )"
              R"(hae="9999999.0" ce="0.50" le="9999999.0"/><detail><contact callsign="Robot 1"/>)"
              R"(<track course="78.00" speed="0.62"/>)"
              R"(<remarks>dead reckoning, trust good, floor Ground</remarks></detail></event>)"
              "\n");
}

TEST(CotEvent, OfAPoseThatIsStaleOrNoNumberIsNone) {
    const auto stale = cotEvent(samplePose(), sampleTime(1.0), kStation);
    ASSERT_FALSE(stale);
    EXPECT_EQ(stale.error().code, ErrorCode::kNoData);
    PublishedPose pose = samplePose();
    pose.pose.position.y = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(cotEvent(pose, sampleTime(0.1), kStation));
}

TEST(CotEvent, NeedsTheGlobe) {
    PublishedPose pose = samplePose();
    pose.tie.reset();
    const auto event = cotEvent(pose, sampleTime(0.1), kStation);
    ASSERT_FALSE(event);
    EXPECT_EQ(event.error().code, ErrorCode::kNotOnGlobe);
}

TEST(CotEvent, SaysThatTheErrorIsUnknown) {
    PublishedPose pose = samplePose();
    pose.variance = {};
    EXPECT_EQ(valuesOf(*cotEvent(pose, sampleTime(0.1), kStation))["point.ce"], "9999999.0");
    pose.variance = {1.0F, std::numeric_limits<float>::quiet_NaN(), 1.0F, 1.0F};
    EXPECT_EQ(valuesOf(*cotEvent(pose, sampleTime(0.1), kStation))["point.ce"], "9999999.0");
}

TEST(CotEvent, TellsTheErrorAlongItsWorstDirection) {
    PublishedPose pose = samplePose();
    pose.variance = {2.5F, 1.5F, 2.5F, 0.01F};  // 4 m2 along the diagonal, 1 m2 across
    EXPECT_EQ(valuesOf(*cotEvent(pose, sampleTime(0.1), kStation))["point.ce"], "2.00");
}

TEST(CotEvent, IsXmlWhateverTheRobotIsCalled) {
    PublishedPose pose = samplePose();
    pose.call_sign = "<\"Bob\" & 'co'>\n\x01\xFF\xEF\xBF\xBF]]>";
    pose.floor = "</remarks><event/>\x1B";
    const auto event = cotEvent(pose, sampleTime(0.1), kStation);
    ASSERT_TRUE(event);
    const auto values = valuesOf(*event);
    EXPECT_EQ(values.at("contact.callsign"),
              QStringLiteral("<\"Bob\" & 'co'>  %1%1]]>").arg(QChar(0xFFFD)));
    EXPECT_EQ(values.at("remarks"), "dead reckoning, trust good, floor </remarks><event/> ");
}

TEST(CotEvent, FitsIntoOneDatagram) {
    PublishedPose pose = samplePose();
    pose.call_sign = std::string(5000, '"');
    pose.floor = std::string(5000, '&');
    EXPECT_LT(cotEvent(pose, sampleTime(0.1), kStation)->size(), 1400);
}

TEST(CotEvent, KnowsARobotAgainAndTellsComputersApart) {
    EXPECT_EQ(cotUid("Robot 1", kStation), cotUid("Robot 1", kStation));
    EXPECT_NE(cotUid("Robot 1", kStation), cotUid("Robot 2", kStation));
    EXPECT_NE(cotUid("Robot 1", kStation), cotUid("Robot 1", "another"));
}

}  // namespace
}  // namespace hedr
