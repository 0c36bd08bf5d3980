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
        {"udp://@127.0.0.1:14550", UdpListenAddress{"127.0.0.1", 14550}}};
    for (const auto& [text, address] : cases) {
        const auto parsed = parseLinkAddress(text);
        ASSERT_TRUE(parsed) << text;
        EXPECT_EQ(*parsed, address) << text;
        EXPECT_EQ(toText(address), text);
    }
}

TEST(LinkAddress, RefusesWhatCannotBeReached) {
    for (const char* text : {"tcp://robot", "udp://", "tcp://:0", "udp://:70000", "http://robot:80",
                             "tcp://a b:1", "tcp://host/path:1"}) {
        const auto parsed = parseLinkAddress(text);
        ASSERT_FALSE(parsed) << text;
        EXPECT_EQ(parsed.error().code, ErrorCode::kBadValue);
    }
}

}  // namespace
}  // namespace hedr
