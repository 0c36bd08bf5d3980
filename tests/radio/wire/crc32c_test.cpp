#include "radio/wire/crc32c.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string_view>
#include <vector>

namespace hedr {
namespace {

std::uint32_t crcOf(std::string_view text) {
    return crc32c(std::vector<std::uint8_t>(text.begin(), text.end()));
}

std::uint32_t bitByBit(const std::vector<std::uint8_t>& bytes) {
    std::uint32_t crc = 0xFFFFFFFFU;
    for (const std::uint8_t byte : bytes) {
        crc ^= byte;
        for (int bit = 0; bit < 8; ++bit) {
            crc = (crc >> 1) ^ ((crc & 1U) != 0 ? 0x82F63B78U : 0U);
        }
    }
    return ~crc;
}

TEST(Crc32c, GivesThePublishedValues) {
    EXPECT_EQ(crcOf(""), 0x00000000U);
    EXPECT_EQ(crcOf("a"), 0xC1D04330U);
    EXPECT_EQ(crcOf("123456789"), 0xE3069283U);
    // RFC 3720, B.4
    EXPECT_EQ(crc32c(std::vector<std::uint8_t>(32, 0x00)), 0x8A9136AAU);
    EXPECT_EQ(crc32c(std::vector<std::uint8_t>(32, 0xFF)), 0x62A8AB43U);
}

RC_GTEST_PROP(Crc32c, AgreesWithTheDefinitionAtEveryLength,
              (const std::vector<std::uint8_t>& bytes)) {
    RC_ASSERT(crc32c(bytes) == bitByBit(bytes));
}

}  // namespace
}  // namespace hedr
