#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>

#include "core/robot/report.h"
#include "radio/wire/byte_order.h"
#include "radio/wire/frame.h"

namespace hedr {

// PayloadWriter and PayloadReader have the same functions, so that one description of a message
// (radio/wire/messages.h) serves both directions. A Wire type is the integer that goes on the line,
// `unit` is what one of it stands for.

// The nearest integer, saturating; not-a-number gives the smallest one.
template <class Wire>
Wire saturatingRound(double value) {
    constexpr auto kMin = static_cast<double>(std::numeric_limits<Wire>::min());
    constexpr auto kMax = static_cast<double>(std::numeric_limits<Wire>::max());
    const double rounded = std::round(value);
    if (!(rounded > kMin)) {
        return std::numeric_limits<Wire>::min();
    }
    return rounded < kMax ? static_cast<Wire>(rounded) : std::numeric_limits<Wire>::max();
}

// The nearest integer modulo 2^32; not-a-number and infinity give 0.
inline std::uint32_t wrappingRound(double value) {
    const double rest = std::fmod(std::round(value), 4294967296.0);
    return std::isfinite(rest) ? static_cast<std::uint32_t>(static_cast<std::int64_t>(rest)) : 0U;
}

// Stands for "no gyro" in the place of its angle, which a real angle steps over.
inline constexpr std::uint32_t kNoGyroAngle = 0x80000000U;

class PayloadWriter {
  public:
    // Without a value for what a message must have, or with too much text.
    bool failed() const { return failed_; }
    std::span<const std::uint8_t> payload() const { return std::span(bytes_).first(size_); }

    template <class Wire, class Value>
    void integer(const Value& value) {
        put(static_cast<Wire>(value));
    }
    template <class Wire>
    void scaled(double value, double unit) {
        put(saturatingRound<Wire>(value / unit));
    }
    template <class Wire>
    void wrapping(double value, double unit) {
        put(static_cast<Wire>(wrappingRound(value / unit)));
    }
    template <class Wire, class Value>
    void scaledOrNone(const std::optional<Value>& value, double unit) {
        constexpr Wire kNone = std::numeric_limits<Wire>::min();
        const Wire raw = value ? saturatingRound<Wire>(static_cast<double>(*value) / unit) : kNone;
        put(value && raw == kNone ? static_cast<Wire>(kNone + 1) : raw);
    }
    void angleOrNone(const Gyro& gyro) {
        failed_ = failed_ || std::holds_alternative<GyroRate>(gyro);
        const auto* angle = std::get_if<GyroAngle>(&gyro);
        put(angle == nullptr ? kNoGyroAngle
                             : angle->urad + (angle->urad == kNoGyroAngle ? 1U : 0U));
    }
    template <class Enum>
    void choice(Enum value, Enum) {
        put(static_cast<std::uint8_t>(value));
    }
    template <class Part, class... Parts, class Describe>
    void oneOf(const std::variant<Parts...>& value, Describe describe) {
        const Part* part = std::get_if<Part>(&value);
        failed_ = failed_ || part == nullptr;
        describe(part == nullptr ? Part{} : *part);
    }
    template <class Part, class Describe>
    void trailing(const std::optional<Part>& value, std::size_t, Describe describe) {
        if (value) {
            describe(*value);
        }
    }
    // At most `longest` bytes, cut between two characters.
    void text(const std::string& value, std::size_t longest) {
        std::size_t size = std::min(value.size(), longest);
        while (size < value.size() && size > 0 && (value[size] & 0xC0) == 0x80) {
            --size;
        }
        put(static_cast<std::uint8_t>(size));
        for (std::size_t i = 0; i < size; ++i) {
            put(static_cast<std::uint8_t>(value[i]));
        }
    }
    template <class Describe>
    void bits16(Describe describe) {
        Bits bits;
        describe(bits);
        put(bits.word);
    }

  private:
    struct Bits {
        std::uint16_t word = 0;
        int used = 0;

        void flag(bool value) { take(value ? 1U : 0U, 1); }
        template <class Enum>
        void choice(Enum value, Enum, int width) {
            take(static_cast<unsigned>(value), width);
        }
        void take(unsigned value, int width) {
            word = static_cast<std::uint16_t>(word | value << used);
            used += width;
        }
    };

    template <class Wire>
    void put(Wire value) {
        if (size_ + sizeof(Wire) > bytes_.size()) {
            failed_ = true;
            return;
        }
        storeLittle(value, &bytes_[size_]);
        size_ += sizeof(Wire);
    }

    std::array<std::uint8_t, kMaxPayloadBytes> bytes_{};
    std::size_t size_ = 0;
    bool failed_ = false;
};

class PayloadReader {
  public:
    explicit PayloadReader(std::span<const std::uint8_t> payload) : rest_(payload) {}

    // The payload is too short. What is left over at its end is a newer version's and ignored.
    bool failed() const { return failed_; }

    template <class Wire, class Value>
    void integer(Value& value) {
        value = static_cast<Value>(get<Wire>());
    }
    template <class Wire>
    void scaled(double& value, double unit) {
        value = static_cast<double>(get<Wire>()) * unit;
    }
    template <class Wire>
    void wrapping(double& value, double unit) {
        scaled<Wire>(value, unit);
    }
    template <class Wire, class Value>
    void scaledOrNone(std::optional<Value>& value, double unit) {
        const Wire raw = get<Wire>();
        value.reset();
        if (raw != std::numeric_limits<Wire>::min()) {
            value = static_cast<Value>(static_cast<double>(raw) * unit);
        }
    }
    void angleOrNone(Gyro& gyro) {
        const auto raw = get<std::uint32_t>();
        gyro = raw == kNoGyroAngle ? Gyro{} : Gyro{GyroAngle{raw}};
    }
    // A number above `last` is a newer version's and reads as the enumeration's zero.
    template <class Enum>
    void choice(Enum& value, Enum last) {
        const auto raw = get<std::uint8_t>();
        value = raw <= static_cast<std::uint8_t>(last) ? static_cast<Enum>(raw) : Enum{};
    }
    template <class Part, class... Parts, class Describe>
    void oneOf(std::variant<Parts...>& value, Describe describe) {
        describe(value.template emplace<Part>());
    }
    template <class Part, class Describe>
    void trailing(std::optional<Part>& value, std::size_t bytes, Describe describe) {
        value.reset();
        if (rest_.size() >= bytes) {
            describe(value.emplace());
        }
    }
    void text(std::string& value, std::size_t) {
        const std::size_t size = get<std::uint8_t>();
        failed_ = failed_ || size > rest_.size();
        if (!failed_) {
            value.assign(rest_.begin(), rest_.begin() + static_cast<std::ptrdiff_t>(size));
            rest_ = rest_.subspan(size);
        }
    }
    template <class Describe>
    void bits16(Describe describe) {
        Bits bits{get<std::uint16_t>()};
        describe(bits);
    }

  private:
    struct Bits {
        unsigned word;

        void flag(bool& value) { value = take(1) != 0; }
        template <class Enum>
        void choice(Enum& value, Enum last, int width) {
            const unsigned raw = take(width);
            value = raw <= static_cast<unsigned>(last) ? static_cast<Enum>(raw) : Enum{};
        }
        unsigned take(int width) {
            const unsigned value = word & ((1U << width) - 1U);
            word >>= width;
            return value;
        }
    };

    template <class Wire>
    Wire get() {
        if (failed_ || rest_.size() < sizeof(Wire)) {
            failed_ = true;
            return Wire{};
        }
        const Wire value = loadLittle<Wire>(rest_.data());
        rest_ = rest_.subspan(sizeof(Wire));
        return value;
    }

    std::span<const std::uint8_t> rest_;
    bool failed_ = false;
};

}  // namespace hedr
