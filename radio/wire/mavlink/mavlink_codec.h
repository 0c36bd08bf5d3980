#pragma once

#include <bit>
#include <cstring>

#include "radio/wire/byte_order.h"
#include "radio/wire/mavlink/mavlink_fields.h"
#include "radio/wire/mavlink/mavlink_frame.h"

namespace hedr {

template <std::size_t Bytes>
using UnsignedOf = std::conditional_t<
    Bytes == 1, std::uint8_t,
    std::conditional_t<Bytes == 2, std::uint16_t,
                       std::conditional_t<Bytes == 4, std::uint32_t, std::uint64_t>>>;

// What is missing at the end reads as zero; what is longer than known is left.
class MavlinkPayloadReader {
  public:
    explicit MavlinkPayloadReader(std::span<const std::uint8_t> payload) {
        if (!payload.empty()) std::memcpy(bytes_.data(), payload.data(), payload.size());
    }
    template <class T>
    void operator()(const char*, T& value) {
        value = std::bit_cast<T>(loadLittle<UnsignedOf<sizeof(T)>>(&bytes_[at_]));
        at_ += sizeof(T);
    }
    template <class T, std::size_t N>
    void operator()(const char* name, std::array<T, N>& values) {
        for (T& value : values) (*this)(name, value);
    }
    void extensions() {}

  private:
    std::array<std::uint8_t, kMaxMavlinkPayloadBytes> bytes_{};
    std::size_t at_ = 0;
};

class MavlinkPayloadWriter {
  public:
    template <class T>
    void operator()(const char*, const T& value) {
        storeLittle(std::bit_cast<UnsignedOf<sizeof(T)>>(value), &bytes_[size_]);
        size_ += sizeof(T);
    }
    template <class T, std::size_t N>
    void operator()(const char* name, const std::array<T, N>& values) {
        for (const T& value : values) (*this)(name, value);
    }
    void extensions() {}
    std::span<const std::uint8_t> payload() const { return std::span(bytes_).first(size_); }

  private:
    std::array<std::uint8_t, kMaxMavlinkPayloadBytes> bytes_{};
    std::size_t size_ = 0;
};

// `payload`: at most kMaxMavlinkPayloadBytes, of that message.
template <class Message>
Message readMavlink(std::span<const std::uint8_t> payload) {
    Message message;
    MavlinkPayloadReader reader(payload);
    mavlinkFields(reader, message);
    return message;
}

// The frame's payload in full length; version 1 goes without the extensions. Unsigned.
MavlinkBytes encodeMavlinkFrame(const MavlinkFrame& frame);

// `header.payload` and `header.message_id` are the message's.
template <class Message>
MavlinkBytes encodeMavlink(const Message& message, MavlinkFrame header) {
    MavlinkPayloadWriter writer;
    mavlinkFields(writer, message);
    header.message_id = Message::kId;
    header.payload = writer.payload();
    return encodeMavlinkFrame(header);
}

}  // namespace hedr
