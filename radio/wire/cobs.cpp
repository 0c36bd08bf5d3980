#include "radio/wire/cobs.h"

#include <cassert>
#include <cstddef>

namespace hedr {

void cobsEncodeInPlace(std::span<std::uint8_t> block) {
    assert(!block.empty() && block.size() <= 254);
    std::size_t code = 0;
    for (std::size_t i = 1; i < block.size(); ++i) {
        if (block[i] == 0) {
            block[code] = static_cast<std::uint8_t>(i - code);
            code = i;
        }
    }
    block[code] = static_cast<std::uint8_t>(block.size() - code);
}

bool cobsDecodeInPlace(std::span<std::uint8_t> block) {
    std::size_t end = 0;
    while (end < block.size()) {
        end += block[end];
    }
    if (end != block.size() || end == 0) {
        return false;
    }
    for (std::size_t code = block[0]; code < block.size();) {
        const std::size_t step = block[code];
        block[code] = 0;
        code += step;
    }
    return true;
}

}  // namespace hedr
