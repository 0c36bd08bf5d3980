#include "radio/wire/codec.h"

#include <cassert>
#include <utility>

#include "radio/wire/frame_encoder.h"
#include "radio/wire/messages.h"
#include "radio/wire/payload_io.h"

namespace hedr {
namespace {

template <class Message, class Any>
bool decodeAs(const Frame& frame, tl::expected<Any, DecodeFailure>& result) {
    if (frame.id != kMessageId<Message>) {
        return false;
    }
    PayloadReader reader(frame.payload);
    Message message;
    fields(reader, message);
    if (reader.failed()) {
        result = tl::make_unexpected(DecodeFailure::kTooShort);
    } else {
        result = std::move(message);
    }
    return true;
}

template <class... Messages>
tl::expected<std::variant<Messages...>, DecodeFailure> decode(
    const Frame& frame, std::type_identity<std::variant<Messages...>>) {
    tl::expected<std::variant<Messages...>, DecodeFailure> result =
        tl::make_unexpected(DecodeFailure::kUnknownId);
    (decodeAs<Messages>(frame, result) || ...);
    return result;
}

template <class Message>
std::uint8_t writeMessage(PayloadWriter& writer, const Message& message) {
    fields(writer, message);
    return kMessageId<Message>;
}

}  // namespace

tl::expected<Report, DecodeFailure> decodeReport(const Frame& frame) {
    return decode(frame, std::type_identity<Report>{});
}

tl::expected<Request, DecodeFailure> decodeRequest(const Frame& frame) {
    return decode(frame, std::type_identity<Request>{});
}

std::optional<FrameBytes> encodeReport(const Report& report, std::uint16_t sequence) {
    PayloadWriter writer;
    const std::uint8_t id = std::visit(
        [&writer](const auto& message) { return writeMessage(writer, message); }, report);
    if (writer.failed()) {
        return std::nullopt;
    }
    return encodeFrame({.id = id, .sequence = sequence, .payload = writer.payload()});
}

FrameBytes encodeRequest(const Request& request, std::uint16_t sequence) {
    PayloadWriter writer;
    const std::uint8_t id = std::visit(
        [&writer](const auto& message) { return writeMessage(writer, message); }, request);
    assert(!writer.failed());
    return encodeFrameAfterSilence({.id = id, .sequence = sequence, .payload = writer.payload()});
}

}  // namespace hedr
