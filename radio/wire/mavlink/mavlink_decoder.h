#pragma once

#include <algorithm>
#include <cstring>
#include <optional>

#include "radio/wire/mavlink/mavlink_frame.h"
#include "radio/wire/mavlink/mavlink_sequences.h"
#include "radio/wire/reports.h"

namespace hedr {

// Finds MAVLink frames of both versions in a stream of bytes, however the stream is cut. A length
// is believed only once the checksum is right; where a candidate fails, the search goes on at the
// byte behind its magic byte: no noise hides a good frame. Memory is constant.
//
// The checksum of an id that is not known cannot be tested. Such a frame is looked through like
// noise, and counts as an unknown frame (and not as a bad one) if another magic byte follows where
// it ends. So do frames with flags that are not known.
class MavlinkDecoder {
  public:
    // Calls on_frame(const MavlinkFrame&) for each good frame; its payload is valid during the
    // call.
    template <class OnFrame>
    void feed(std::span<const std::uint8_t> bytes, OnFrame&& on_frame) {
        counters_.bytes += bytes.size();
        while (held_ > 0 && !bytes.empty()) {
            const std::size_t old = held_;
            const std::size_t more = std::min(bytes.size(), hold_.size() - old);
            std::memcpy(&hold_[old], bytes.data(), more);
            held_ += more;
            const std::size_t done = scan(std::span(hold_).first(held_), on_frame);
            if (done >= old) {  // what is left lies in `bytes` too
                held_ = 0;
                bytes = bytes.subspan(done - old);
            } else {
                held_ -= done;
                std::memmove(hold_.data(), &hold_[done], held_);
                bytes = bytes.subspan(more);
            }
        }
        if (bytes.empty()) return;
        const auto rest = bytes.subspan(scan(bytes, on_frame));
        std::ranges::copy(rest, hold_.begin());
        held_ = rest.size();
    }

    // Forgets the beginning of a frame: what follows does not continue it.
    void startAgain() {
        held_ = 0;
        passage_.reset();
        in_noise_ = false;
    }

    // Bad frames are counted in runs: bytes between two frames that are none are one.
    const WireCounters& counters() const { return counters_; }
    std::uint64_t signedFrames() const { return signed_frames_; }

  private:
    // Bytes that are passed, though looked through, without being noise.
    struct Passage {
        std::size_t left = 0;
        bool is_signature = false;  // otherwise a frame that is not known
        MavlinkFrame frame{};
    };
    struct Candidate {
        MavlinkFrame frame{};
        std::size_t size = 0;  // up to the checksum's end
        std::uint8_t crc_extra = 0;
        bool possible = true;
        bool known = true;
    };

    // Takes the frames out; how many bytes are done with. The rest is the beginning of a frame.
    template <class OnFrame>
    std::size_t scan(std::span<const std::uint8_t> bytes, OnFrame& on_frame) {
        std::size_t at = 0;
        while (true) {
            const std::size_t start = findMagic(bytes, at);
            pass(start - at);
            at = start;
            const auto rest = bytes.subspan(at);
            if (rest.empty()) return at;
            endPassage();
            const std::optional<Candidate> candidate = candidateAt(rest);
            if (!candidate) return at;
            const bool checkable = candidate->possible && candidate->known;
            if (checkable && rest.size() < candidate->size) return at;
            if (checkable && checked(*candidate, rest)) {
                accept(*candidate);
                on_frame(candidate->frame);
                at += candidate->size;
            } else {
                refuse(*candidate);
                ++at;
            }
        }
    }

    static std::size_t findMagic(std::span<const std::uint8_t> bytes, std::size_t from) {
        while (from < bytes.size() && bytes[from] != kMavlinkMagic2 &&
               bytes[from] != kMavlinkMagic1) {
            ++from;
        }
        return from;
    }
    // None where the header is not complete.
    static std::optional<Candidate> candidateAt(std::span<const std::uint8_t> bytes);
    static bool checked(const Candidate& candidate, std::span<const std::uint8_t> bytes);
    void accept(const Candidate& candidate);
    void refuse(const Candidate& candidate);
    void pass(std::size_t bytes);
    void endPassage();
    void countMissing(const MavlinkFrame& frame);
    void noise();

    // Twice the longest frame, so that its beginning and all of it fit together.
    std::array<std::uint8_t, 2 * kMaxMavlinkFrameBytes> hold_{};
    std::size_t held_ = 0;
    std::optional<Passage> passage_{};
    bool in_noise_ = false;
    MavlinkSequences sequences_{};
    WireCounters counters_{};
    std::uint64_t signed_frames_ = 0;
};

}  // namespace hedr
