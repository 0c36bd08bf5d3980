#include "radio/wire/signing/siphash.h"

#include <sodium.h>

namespace hedr {

static_assert(crypto_shorthash_siphash24_KEYBYTES == std::tuple_size_v<SigningKey>);
static_assert(crypto_shorthash_siphash24_BYTES == std::tuple_size_v<SigningTag>);

SigningTag sipHash(const SigningKey& key, std::span<const std::uint8_t> bytes) {
    SigningTag tag{};
    crypto_shorthash_siphash24(tag.data(), bytes.data(), bytes.size(), key.data());
    return tag;
}

bool isTag(const SigningTag& expected, std::span<const std::uint8_t> tag) {
    return tag.size() == expected.size() &&
           sodium_memcmp(expected.data(), tag.data(), expected.size()) == 0;
}

}  // namespace hedr
