#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace hedr {

// The wire is little endian, whatever the machine is.
template <class T>
constexpr T loadLittle(const std::uint8_t* bytes) {
    std::make_unsigned_t<T> value = 0;
    for (std::size_t i = 0; i < sizeof(T); ++i) {
        value = static_cast<std::make_unsigned_t<T>>(
            value | static_cast<std::make_unsigned_t<T>>(bytes[i]) << (8 * i));
    }
    return static_cast<T>(value);
}

template <class T>
constexpr void storeLittle(T value, std::uint8_t* bytes) {
    const auto raw = static_cast<std::make_unsigned_t<T>>(value);
    for (std::size_t i = 0; i < sizeof(T); ++i) {
        bytes[i] = static_cast<std::uint8_t>(raw >> (8 * i));
    }
}

}  // namespace hedr
