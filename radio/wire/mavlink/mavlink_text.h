#pragma once

#include <optional>
#include <string>

#include "radio/wire/mavlink/mavlink_messages.h"

namespace hedr {

// The characters before the first zero.
template <std::size_t N>
std::string_view mavlinkText(const std::array<char, N>& text) {
    const std::string_view all(text.data(), text.size());
    return all.substr(0, all.find('\0'));
}

// Joins the pieces of longer STATUSTEXTs. One whose piece is missing is given as far as it came.
class MavlinkTexts {
  public:
    // Calls on_text(std::string) for each text that is now complete, or will never be.
    template <class OnText>
    void add(const MavlinkStatustext& m, OnText&& on_text) {
        const bool goes_on = open_ && m.id == open_->id && m.chunk_seq == open_->next;
        if (!goes_on) end(on_text);
        if (m.id != 0 && !open_ && m.chunk_seq > 0) return;  // its beginning is lost
        if (!open_) open_ = Open{m.id, 0, std::string(severityWord(m.severity))};
        const std::string_view piece = mavlinkText(m.text);
        if (open_->text.size() < kLongestText) open_->text += piece;
        ++open_->next;
        age_ = 0;
        const bool last = m.id == 0 || piece.size() < m.text.size();
        if (!last) return;
        on_text(std::move(open_->text));
        open_.reset();
    }

    // Once a second or so: an end that did not come for two of these does not come.
    template <class OnText>
    void tick(OnText&& on_text) {
        if (open_ && ++age_ > 2) end(on_text);
    }

  private:
    struct Open {
        std::uint16_t id = 0;
        int next = 0;
        std::string text;
    };
    template <class OnText>
    void end(OnText&& on_text) {
        if (open_) on_text(open_->text + "…");
        open_.reset();
    }
    static std::string_view severityWord(std::uint8_t severity);

    static constexpr std::size_t kLongestText = 500;
    std::optional<Open> open_{};
    int age_ = 0;
};

}  // namespace hedr
