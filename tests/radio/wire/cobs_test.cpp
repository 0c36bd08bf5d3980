#include "radio/wire/cobs.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <vector>

namespace hedr {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes stuffed(Bytes plain) {
    plain.insert(plain.begin(), 0);
    cobsEncodeInPlace(plain);
    return plain;
}

TEST(Cobs, StuffsTheKnownExamples) {
    EXPECT_EQ(stuffed({}), (Bytes{0x01}));
    EXPECT_EQ(stuffed({0x00}), (Bytes{0x01, 0x01}));
    EXPECT_EQ(stuffed({0x11, 0x22, 0x00, 0x33}), (Bytes{0x03, 0x11, 0x22, 0x02, 0x33}));
    EXPECT_EQ(stuffed({0x11, 0x00, 0x00, 0x00}), (Bytes{0x02, 0x11, 0x01, 0x01, 0x01}));
    EXPECT_EQ(stuffed(Bytes(253, 0x55)).front(), 254);
}

TEST(Cobs, LeavesABlockAloneWhoseCodesMissTheEnd) {
    const Bytes beyond{0x03, 0x11, 0x22, 0x09, 0x33};
    Bytes block = beyond;
    EXPECT_FALSE(cobsDecodeInPlace(block));
    EXPECT_EQ(block, beyond);
    Bytes nothing;
    EXPECT_FALSE(cobsDecodeInPlace(nothing));
}

RC_GTEST_PROP(Cobs, GivesBackWhatWasStuffedAndHasNoZero, ()) {
    const auto plain = *rc::gen::resize(
        253, rc::gen::container<Bytes>(rc::gen::oneOf(rc::gen::just(std::uint8_t{0}),
                                                      rc::gen::arbitrary<std::uint8_t>())));
    RC_PRE(plain.size() <= 253U);
    Bytes block = stuffed(plain);
    RC_ASSERT(std::count(block.begin(), block.end(), 0) == 0);
    RC_ASSERT(cobsDecodeInPlace(block));
    RC_ASSERT(Bytes(block.begin() + 1, block.end()) == plain);
}

}  // namespace
}  // namespace hedr
