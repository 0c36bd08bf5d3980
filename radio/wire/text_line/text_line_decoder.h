#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace hedr {

// Cuts a stream of bytes into lines, however it is cut itself. A line ends with \n, \r or both;
// empty lines are nothing. Memory is constant.
class TextLineDecoder {
  public:
    static constexpr std::size_t kLongestLine = 512;  // bytes, without its end

    // Calls on_line(std::optional<std::string_view>) for each line; none stands for a bad one: too
    // long, or with control bytes other than a tab. The text is valid during the call.
    template <class OnLine>
    void feed(std::span<const std::uint8_t> bytes, OnLine&& on_line) {
        for (const std::uint8_t byte : bytes) {
            if (byte != '\n' && byte != '\r') {
                append(byte);
                continue;
            }
            if (bad_) {
                on_line(std::optional<std::string_view>());
            } else if (size_ > 0) {
                on_line(std::optional(std::string_view(line_.data(), size_)));
            }
            reset();
        }
    }

    // Forgets the bytes of an unfinished line.
    void reset() {
        size_ = 0;
        bad_ = false;
    }

  private:
    void append(std::uint8_t byte) {
        const bool control = (byte < 0x20 && byte != '\t') || byte == 0x7F;
        bad_ = bad_ || control || size_ == line_.size();
        if (!bad_) line_[size_++] = static_cast<char>(byte);
    }

    std::array<char, kLongestLine> line_{};
    std::size_t size_ = 0;
    bool bad_ = false;
};

}  // namespace hedr
