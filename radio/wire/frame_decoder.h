#pragma once

#include <array>
#include <cstring>
#include <optional>

#include "radio/wire/frame.h"

namespace hedr {

struct FrameCounters {
    std::uint64_t bytes = 0;
    std::uint64_t good_frames = 0;
    std::uint64_t bad_frames = 0;  // runs between zeros that were no frame, or not only a frame
    friend bool operator==(const FrameCounters&, const FrameCounters&) = default;
};

// Finds frames in a stream of bytes, however the stream is cut. Noise costs no good frame: where a
// run of bytes up to a 0x00 is not a frame, one that ends it is still found. Memory is constant.
class FrameDecoder {
  public:
    // Calls on_frame(const Frame&) for each good frame; its payload is valid during the call.
    template <class OnFrame>
    void feed(std::span<const std::uint8_t> bytes, OnFrame&& on_frame) {
        counters_.bytes += bytes.size();
        while (!bytes.empty()) {
            const void* zero = std::memchr(bytes.data(), 0, bytes.size());
            if (zero == nullptr) {
                append(bytes);
                return;
            }
            const auto run =
                static_cast<std::size_t>(static_cast<const std::uint8_t*>(zero) - bytes.data());
            append(bytes.first(run));
            if (const std::optional<Frame> frame = finishRun()) {
                on_frame(*frame);
            }
            bytes = bytes.subspan(run + 1);
        }
    }

    const FrameCounters& counters() const { return counters_; }

    // Forgets the bytes of an unfinished frame: what follows does not continue them.
    void startAgain() {
        size_ = 0;
        overlong_ = false;
    }

  private:
    using Block = std::array<std::uint8_t, kMaxBlockBytes>;

    void append(std::span<const std::uint8_t> bytes);
    void appendOverlong(std::span<const std::uint8_t> bytes);
    std::optional<Frame> finishRun();
    std::optional<Frame> salvage(std::span<const std::uint8_t> run);

    Block block_{};     // the run so far, of an overlong one its end
    Block salvaged_{};  // a frame found behind noise
    std::size_t size_ = 0;
    bool overlong_ = false;
    FrameCounters counters_;
};

}  // namespace hedr
