#include "radio/wire/crc32c.h"

#include <array>
#include <cstddef>

#include "radio/wire/byte_order.h"

namespace hedr {
namespace {

constexpr std::uint32_t kPolynomial = 0x82F63B78U;

// Eight bytes are looked up at once ("slicing by 8"): table k holds the effect of a byte that is
// followed by k more ones.
using Tables = std::array<std::array<std::uint32_t, 256>, 8>;

constexpr Tables makeTables() {
    Tables tables{};
    for (std::uint32_t byte = 0; byte < 256; ++byte) {
        std::uint32_t crc = byte;
        for (int bit = 0; bit < 8; ++bit) {
            crc = (crc >> 1) ^ ((crc & 1U) != 0 ? kPolynomial : 0U);
        }
        tables[0][byte] = crc;
    }
    for (std::size_t k = 1; k < tables.size(); ++k) {
        for (std::size_t byte = 0; byte < 256; ++byte) {
            const std::uint32_t shorter = tables[k - 1][byte];
            tables[k][byte] = (shorter >> 8) ^ tables[0][shorter & 0xFFU];
        }
    }
    return tables;
}

constexpr Tables kTables = makeTables();

}  // namespace

std::uint32_t crc32c(std::span<const std::uint8_t> bytes) {
    std::uint32_t crc = 0xFFFFFFFFU;
    const std::uint8_t* p = bytes.data();
    std::size_t left = bytes.size();
    for (; left >= 8; left -= 8, p += 8) {
        const std::uint32_t low = crc ^ loadLittle<std::uint32_t>(p);
        const auto high = loadLittle<std::uint32_t>(p + 4);
        crc = kTables[7][low & 0xFFU] ^ kTables[6][(low >> 8) & 0xFFU] ^
              kTables[5][(low >> 16) & 0xFFU] ^ kTables[4][low >> 24] ^ kTables[3][high & 0xFFU] ^
              kTables[2][(high >> 8) & 0xFFU] ^ kTables[1][(high >> 16) & 0xFFU] ^
              kTables[0][high >> 24];
    }
    for (; left > 0; --left, ++p) {
        crc = (crc >> 8) ^ kTables[0][(crc ^ *p) & 0xFFU];
    }
    return ~crc;
}

}  // namespace hedr
