#include "radio/publish/publish_target.h"

#include <gtest/gtest.h>

namespace hedr {
namespace {

PublishTarget target(PublishKind kind, const char* host, std::uint16_t port) {
    return {kind, QString::fromLatin1(host), port};
}

TEST(PublishTarget, IsThisComputerUnlessToldOtherwise) {
    EXPECT_EQ(parsePublishTarget("cot=udp://:4242"), target(PublishKind::kCot, "127.0.0.1", 4242));
    EXPECT_EQ(parsePublishTarget("nmea=tcp://:2000"),
              target(PublishKind::kNmea, "127.0.0.1", 2000));
    EXPECT_EQ(parsePublishTarget("json=tcp://:2001"),
              target(PublishKind::kJson, "127.0.0.1", 2001));
    for (const PublishKind kind : kPublishKinds) {
        EXPECT_FALSE(leavesThisComputer(defaultTarget(kind)));
        EXPECT_EQ(parsePublishTarget(publishWord(kind)), defaultTarget(kind));
    }
}

TEST(PublishTarget, GoesFurtherWhereAnAddressIsSaid) {
    EXPECT_EQ(parsePublishTarget("cot=udp://239.2.3.1:6969"),
              target(PublishKind::kCot, "239.2.3.1", 6969));
    EXPECT_EQ(parsePublishTarget("COT=udp://tak.example:6969"),
              target(PublishKind::kCot, "tak.example", 6969));
    EXPECT_EQ(parsePublishTarget("nmea=tcp://@0.0.0.0:2000"),
              target(PublishKind::kNmea, "0.0.0.0", 2000));
    EXPECT_EQ(parsePublishTarget("json=tcp://@[::1]:2000"),
              target(PublishKind::kJson, "::1", 2000));
    EXPECT_TRUE(leavesThisComputer(*parsePublishTarget("cot=udp://239.2.3.1:6969")));
    EXPECT_TRUE(leavesThisComputer(*parsePublishTarget("nmea=tcp://@0.0.0.0:2000")));
    EXPECT_FALSE(leavesThisComputer(*parsePublishTarget("json=tcp://@[::1]:2000")));
    EXPECT_FALSE(leavesThisComputer(*parsePublishTarget("cot=udp://localhost:4242")));
}

TEST(PublishTarget, ThatIsNoneIsRefusedInOneSentence) {
    for (const char* text :
         {"", "cot=", "=udp://:1", "kml=tcp://:1", "cot=tcp://:4242", "nmea=udp://:2000",
          "json=tcp://1.2.3.4:2000", "json=tcp://@example.org:2000", "cot=udp://@1.2.3.4:4242",
          "nmea=/dev/ttyUSB0", "nmea=tcp://:0", "nmea=tcp://:65536", "udp://:4242"}) {
        const auto parsed = parsePublishTarget(text);
        ASSERT_FALSE(parsed) << text;
        EXPECT_EQ(parsed.error().code, ErrorCode::kBadValue);
        EXPECT_EQ(parsed.error().subject, text);
        EXPECT_NE(parsed.error().detail.find("://"), std::string::npos) << "it says what is right";
    }
}

TEST(PublishTarget, ReadsBackAsItWasWritten) {
    for (const char* text :
         {"cot=udp://127.0.0.1:4242", "cot=udp://239.2.3.1:6969", "cot=udp://[ff02::1]:6969",
          "nmea=tcp://:2000", "json=tcp://@192.168.1.5:2000", "json=tcp://@[::1]:2000"}) {
        const auto parsed = parsePublishTarget(text);
        ASSERT_TRUE(parsed) << text;
        EXPECT_EQ(toText(*parsed), text);
        EXPECT_EQ(parsePublishAddress(parsed->kind, addressText(*parsed)), *parsed);
    }
}

}  // namespace
}  // namespace hedr
