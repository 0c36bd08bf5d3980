#pragma once

#include <cstdint>
#include <span>

namespace hedr {

// Consistent overhead byte stuffing (Cheshire and Baker 1999) of at most 253 bytes, in place: a
// block's code byte is the distance to the next one, so that a code's place is where a zero was and
// no byte ever moves. block[0] is the first code; the bytes themselves are block[1], block[2], ...
// The block is at most 254 long.

// block[1...] are plain bytes; afterwards `block` is stuffed and free of zeros.
void cobsEncodeInPlace(std::span<std::uint8_t> block);

// Whether the codes lead exactly to the end of `block`, which must be free of zeros. Only then
// block[1...] are the plain bytes afterwards; otherwise nothing has changed.
bool cobsDecodeInPlace(std::span<std::uint8_t> block);

}  // namespace hedr
