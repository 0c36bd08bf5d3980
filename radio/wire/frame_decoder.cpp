#include "radio/wire/frame_decoder.h"

#include <algorithm>
#include <utility>

#include "radio/wire/byte_order.h"
#include "radio/wire/cobs.h"
#include "radio/wire/crc32c.h"

namespace hedr {
namespace {

// The frame in an unstuffed block, where its checksum is right.
std::optional<Frame> checkedFrame(std::span<const std::uint8_t> block) {
    const auto checked = block.subspan(1, block.size() - 1 - kChecksumBytes);
    if (crc32c(checked) != loadLittle<std::uint32_t>(checked.data() + checked.size())) {
        return std::nullopt;
    }
    return Frame{.id = checked[0],
                 .sequence = loadLittle<std::uint16_t>(&checked[1]),
                 .payload = checked.subspan(kFrameHeaderBytes)};
}

}  // namespace

void FrameDecoder::append(std::span<const std::uint8_t> bytes) {
    if (size_ + bytes.size() > block_.size()) {
        appendOverlong(bytes);
    } else if (!bytes.empty()) {
        std::memcpy(&block_[size_], bytes.data(), bytes.size());
        size_ += bytes.size();
    }
}

// Only the last bytes can still be a frame.
void FrameDecoder::appendOverlong(std::span<const std::uint8_t> bytes) {
    if (!overlong_) {
        overlong_ = true;
        ++counters_.bad_frames;
    }
    bytes = bytes.last(std::min(bytes.size(), block_.size()));
    const std::size_t keep = block_.size() - bytes.size();
    if (keep < size_) {
        std::memmove(block_.data(), &block_[size_ - keep], keep);
        size_ = keep;
    }
    std::copy(bytes.begin(), bytes.end(), &block_[size_]);
    size_ += bytes.size();
}

std::optional<Frame> FrameDecoder::finishRun() {
    const auto run = std::span(block_).first(std::exchange(size_, 0));
    const bool counted = std::exchange(overlong_, false);
    if (run.empty()) {
        return std::nullopt;
    }
    if (!counted && run.size() >= kMinBlockBytes && cobsDecodeInPlace(run)) {
        if (const std::optional<Frame> frame = checkedFrame(run)) {
            ++counters_.good_frames;
            return frame;
        }
        cobsEncodeInPlace(run);
    }
    counters_.bad_frames += counted ? 0 : 1;
    return salvage(run);
}

// Noise that ran into a frame: tries each place from which the codes lead exactly to the end.
std::optional<Frame> FrameDecoder::salvage(std::span<const std::uint8_t> run) {
    std::array<bool, kMaxBlockBytes + 1> leads_to_end{};
    leads_to_end[run.size()] = true;
    for (std::size_t start = run.size(); start-- > 0;) {
        const std::size_t next = start + run[start];
        leads_to_end[start] = next <= run.size() && leads_to_end[next];
        if (!leads_to_end[start] || run.size() - start < kMinBlockBytes) {
            continue;
        }
        const auto tail = run.subspan(start);
        std::copy(tail.begin(), tail.end(), salvaged_.begin());
        const auto block = std::span(salvaged_).first(tail.size());
        if (cobsDecodeInPlace(block)) {
            if (const std::optional<Frame> frame = checkedFrame(block)) {
                ++counters_.good_frames;
                return frame;
            }
        }
    }
    return std::nullopt;
}

}  // namespace hedr
