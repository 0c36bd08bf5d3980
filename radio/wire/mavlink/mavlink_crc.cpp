#include "radio/wire/mavlink/mavlink_crc.h"

#include <array>
#include <cstddef>

#include "radio/wire/byte_order.h"

namespace hedr {
namespace {

constexpr unsigned kPolynomial = 0x8408U;

// Eight bytes are looked up at once, as in crc32c.cpp: table k holds the effect of a byte that is
// followed by k more ones.
using Tables = std::array<std::array<std::uint16_t, 256>, 8>;

constexpr Tables makeTables() {
    Tables tables{};
    for (unsigned byte = 0; byte < 256; ++byte) {
        unsigned crc = byte;
        for (int bit = 0; bit < 8; ++bit) {
            crc = (crc >> 1) ^ ((crc & 1U) != 0 ? kPolynomial : 0U);
        }
        tables[0][byte] = static_cast<std::uint16_t>(crc);
    }
    for (std::size_t k = 1; k < tables.size(); ++k) {
        for (std::size_t byte = 0; byte < 256; ++byte) {
            const unsigned shorter = tables[k - 1][byte];
            tables[k][byte] =
                static_cast<std::uint16_t>((shorter >> 8) ^ tables[0][shorter & 0xFFU]);
        }
    }
    return tables;
}

constexpr Tables kTables = makeTables();

}  // namespace

std::uint16_t mavlinkCrc(std::span<const std::uint8_t> bytes, std::uint16_t crc) {
    const std::uint8_t* p = bytes.data();
    std::size_t left = bytes.size();
    unsigned sum = crc;
    for (; left >= 8; left -= 8, p += 8) {
        const std::uint32_t low = sum ^ loadLittle<std::uint32_t>(p);
        const auto high = loadLittle<std::uint32_t>(p + 4);
        sum = static_cast<unsigned>(kTables[7][low & 0xFFU] ^ kTables[6][(low >> 8) & 0xFFU] ^
                                    kTables[5][(low >> 16) & 0xFFU] ^ kTables[4][low >> 24] ^
                                    kTables[3][high & 0xFFU] ^ kTables[2][(high >> 8) & 0xFFU] ^
                                    kTables[1][(high >> 16) & 0xFFU] ^ kTables[0][high >> 24]);
    }
    for (; left > 0; --left, ++p) {
        sum = (sum >> 8) ^ kTables[0][(sum ^ *p) & 0xFFU];
    }
    return static_cast<std::uint16_t>(sum);
}

}  // namespace hedr
