#include "radio/wire/mavlink/mavlink_decoder.h"

#include "radio/wire/byte_order.h"
#include "radio/wire/mavlink/mavlink_crc.h"
#include "radio/wire/mavlink/mavlink_messages.h"

namespace hedr {

std::optional<MavlinkDecoder::Candidate> MavlinkDecoder::candidateAt(
    std::span<const std::uint8_t> bytes) {
    const bool is_v1 = bytes[0] == kMavlinkMagic1;
    const std::size_t header = is_v1 ? kMavlinkHeader1Bytes : kMavlinkHeader2Bytes;
    if (bytes.size() < header) return std::nullopt;
    const std::uint8_t* sender = &bytes[is_v1 ? 2 : 4];
    const std::size_t length = bytes[1];
    const std::uint8_t flags = is_v1 ? std::uint8_t{0} : bytes[2];
    const unsigned id = is_v1 ? sender[3] : loadLittle<std::uint32_t>(&sender[2]) >> 8;

    Candidate candidate{.frame = {.version = is_v1 ? 1 : 2,
                                  .is_signed = (flags & kMavlinkSignedFlag) != 0,
                                  .sequence = sender[0],
                                  .system = sender[1],
                                  .component = sender[2],
                                  .message_id = id},
                        .size = header + length + kMavlinkChecksumBytes};
    const MavlinkMessageInfo* info = findMavlinkMessage(id);
    candidate.known = info != nullptr && (flags & ~kMavlinkSignedFlag) == 0;
    if (!candidate.known) return candidate;
    candidate.crc_extra = info->crc_extra;
    // Version 1 knows neither truncation nor extensions; some send these nevertheless.
    candidate.possible = !is_v1 || (length >= info->min_length && length <= info->max_length);
    if (bytes.size() >= candidate.size) candidate.frame.payload = bytes.subspan(header, length);
    return candidate;
}

bool MavlinkDecoder::checked(const Candidate& candidate, std::span<const std::uint8_t> bytes) {
    const std::size_t end = candidate.size - kMavlinkChecksumBytes;
    const std::uint16_t crc =
        mavlinkCrc({&candidate.crc_extra, 1}, mavlinkCrc(bytes.subspan(1, end - 1)));
    return crc == loadLittle<std::uint16_t>(&bytes[end]);
}

void MavlinkDecoder::accept(const Candidate& candidate) {
    if (passage_) noise();  // a frame in the middle of it: it was none
    passage_.reset();
    in_noise_ = false;
    const MavlinkFrame& frame = candidate.frame;
    ++counters_.good_frames;
    counters_.lost_frames +=
        static_cast<std::uint64_t>(sequences_.heard(frame.system, frame.component, frame.sequence));
    if (!frame.is_signed) return;
    ++signed_frames_;
    passage_ = {.left = kMavlinkSignatureBytes, .is_signature = true};
}

// Its magic byte is passed like any other.
void MavlinkDecoder::refuse(const Candidate& candidate) {
    if (!candidate.known && !passage_) {
        passage_ = {.left = candidate.size +
                            (candidate.frame.is_signed ? kMavlinkSignatureBytes : std::size_t{0}),
                    .frame = candidate.frame};
    }
    pass(1);
}

// Bytes that begin no frame.
void MavlinkDecoder::pass(std::size_t bytes) {
    if (bytes == 0) return;
    if (passage_ && bytes <= passage_->left) {
        passage_->left -= bytes;
        return;
    }
    passage_.reset();
    noise();
}

// At a magic byte: whether the passage ends right here, as it should.
void MavlinkDecoder::endPassage() {
    if (!passage_ || passage_->left > 0) return;
    const MavlinkFrame& frame = passage_->frame;
    if (!passage_->is_signature) {
        ++counters_.unknown_frames;
        in_noise_ = false;
        // Of senders that spoke in a good frame, or else noise would make some up.
        if (sequences_.knows(frame.system, frame.component)) countMissing(frame);
    }
    passage_.reset();
}

void MavlinkDecoder::countMissing(const MavlinkFrame& frame) {
    const int more = sequences_.heard(frame.system, frame.component, frame.sequence);
    counters_.lost_frames += static_cast<std::uint64_t>(std::int64_t{more});
}

void MavlinkDecoder::noise() {
    if (!in_noise_) ++counters_.bad_frames;
    in_noise_ = true;
}

}  // namespace hedr
