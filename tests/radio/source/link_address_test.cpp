#include "radio/source/link_address.h"

#include <gtest/gtest.h>

namespace hedr {
namespace {

TEST(LinkAddress, IsReadFromTextAndWrittenBack) {
    const std::pair<const char*, LinkAddress> cases[] = {
        {"/dev/ttyUSB0", SerialAddress{"/dev/ttyUSB0"}},
        {"/dev/ttyUSB0:115200", SerialAddress{"/dev/ttyUSB0", 115200}},
        {"/dev/serial/by-path/pci:0:1.0-port0",
         SerialAddress{"/dev/serial/by-path/pci:0:1.0-port0"}},
        {"tcp://robot.local:4000", TcpAddress{"robot.local", 4000}},
        {"tcp://[fe80::1]:4000", TcpAddress{"fe80::1", 4000}},
        {"tcp://:4000", TcpListenAddress{"", 4000}},
        {"tcp://@127.0.0.1:4000", TcpListenAddress{"127.0.0.1", 4000}},
        {"udp://192.168.1.5:14550", UdpAddress{"192.168.1.5", 14550}},
        {"udp://:14550", UdpListenAddress{"", 14550}},
        {"udp://@127.0.0.1:14550", UdpListenAddress{"127.0.0.1", 14550}},
        {"/dev/strange.csv", SerialAddress{"/dev/strange.csv"}},
        {"file:///home/me/my mission.hedr", RecordingAddress{"/home/me/my mission.hedr"}},
        {"file:///m.hedr?speed=2.5", RecordingAddress{"/m.hedr", 2.5}},
        {"file:///100%25 sure%3F#1.csv", RecordingAddress{"/100% sure?#1.csv"}},
        {"sim://packbot-hall?seed=7", SimulatorAddress{"packbot-hall"}},
        {"sim://umbmark?seed=18446744073709551615&speed=20",
         SimulatorAddress{"umbmark", 18446744073709551615U, 20.0}}};
    for (const auto& [text, address] : cases) {
        const auto parsed = parseLinkAddress(text);
        ASSERT_TRUE(parsed) << text;
        EXPECT_EQ(*parsed, address) << text;
        EXPECT_EQ(toText(address), text);
    }
}

TEST(LinkAddress, TakesTheNameOfARecordingForWhatItIs) {
    EXPECT_EQ(parseLinkAddress("/home/me/Drive.HEDR"),
              LinkAddress(RecordingAddress{"/home/me/Drive.HEDR"}));
    EXPECT_EQ(parseLinkAddress("/data/c:1/sensors.csv"),
              LinkAddress(RecordingAddress{"/data/c:1/sensors.csv"}));
    const auto here = parseLinkAddress("m.hedr");
    ASSERT_TRUE(here);
    EXPECT_TRUE(std::get<RecordingAddress>(*here).file.endsWith("/m.hedr"));
    EXPECT_TRUE(std::get<RecordingAddress>(*here).file.startsWith('/'));
    EXPECT_EQ(parseLinkAddress("sim://umbmark"), LinkAddress(SimulatorAddress{"umbmark"}));
}

TEST(LinkAddress, RefusesWhatCannotBeReached) {
    for (const char* text :
         {"tcp://robot", "udp://", "tcp://:0", "udp://:70000", "http://robot:80", "tcp://a b:1",
          "tcp://host/path:1", "file://m.hedr", "file:///m.hedr?speed=0",
          "file:///m.hedr?speed=nan", "file:///m.hedr?seed=1", "file:///m.hedr?loud=1", "sim://",
          "sim://mars", "sim://umbmark?seed=-1", "sim://umbmark?seed=18446744073709551616",
          "sim://umbmark?speed=1e9", "sim://umbmark?speed"}) {
        const auto parsed = parseLinkAddress(text);
        ASSERT_FALSE(parsed) << text;
        EXPECT_EQ(parsed.error().code, ErrorCode::kBadValue);
    }
}

}  // namespace
}  // namespace hedr
