#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "radio/wire/hedr_reports.h"
#include "radio/wire/mavlink/mavlink_reports.h"
#include "radio/wire/reports.h"
#include "radio/wire/request.h"
#include "radio/wire/text_line/text_line_reports.h"

namespace hedr {

// Of what says how the robot moves: enough for quick turns, and what a radio of 57600 baud carries.
inline constexpr double kWishedRate_hz = 20.0;

enum class RobotLanguage : std::uint8_t { kUnknown, kHedr, kMavlink, kText };

// What a robot says, in whichever language: it is found out from the bytes alone, and the same
// bytes give the same reports, however they are cut. Once known, the language stays until the port
// is opened again, or a robot that signs is heard: then it is that one's.
class RobotSpeech {
  public:
    // `text`: of the vehicle file, for a robot whose lines do not name their columns.
    explicit RobotSpeech(const std::optional<TextLineFormat>& text = std::nullopt,
                         FrameVerifier verifier = FrameVerifier())
        : hedr_(std::move(verifier)), text_(text) {}

    void feed(std::span<const std::uint8_t> bytes, const OnReport& on_report);
    // Bytes that follow do not continue those before: another robot may be at the other end.
    void portOpened();

    RobotLanguage language() const { return language_; }
    FrameVerifier& verifier() { return hedr_.verifier(); }
    const FrameVerifier& verifier() const { return hedr_.verifier(); }
    std::vector<RejectedFrame> takeRejected() { return hedr_.takeRejected(); }
    WireCounters counters() const;
    // Good frames of the robot itself that were not rejected: none that others send beside it.
    std::uint64_t believedFrames() const;
    // Whether what came since the port was opened is no noise, though it may not be known yet whose
    // it is: a MAVLink robot says that once a second only.
    bool makesSense() const;
    // Lines of numbers come, but their names were said before anybody listened.
    bool namesMissing() const {
        return language_ == RobotLanguage::kUnknown && text_.namesMissing();
    }
    // Why text that looks like a robot's is not understood; empty where there is nothing to say.
    const std::string& refusal() const { return text_.refusal(); }
    // The robot's clock wraps at it; infinite: never.
    double clockPeriod_s() const;
    // A request in its language, protocol 1 where none is known yet; empty where it has no words
    // for it.
    std::vector<std::uint8_t> spoken(const Request& request);
    // What asks the robot to say kWishedRate_hz times a second how it moves, a request each; none
    // where its language has no words for that.
    std::vector<std::vector<std::uint8_t>> wishesSpoken();

  private:
    // So many good frames since the port was opened are no accident.
    struct Heard {
        std::uint64_t hedr = 0;
        std::uint64_t mavlink = 0;
        std::uint64_t text = 0;
    };
    Heard heard() const;
    RobotLanguage recognised() const;
    void listenForLanguage(std::span<const std::uint8_t> byte, const OnReport& on_report);
    void listenForSignatures(std::span<const std::uint8_t> bytes, const OnReport& on_report);
    std::uint64_t hedrBelieved() const {
        return hedr_.counters().good_frames - verifier().counters().rejected();
    }

    HedrReports hedr_;
    MavlinkReports mavlink_;
    TextLineReports text_;
    RobotLanguage language_ = RobotLanguage::kUnknown;
    Heard before_{};  // when the port was opened
    // Frames of protocol 1 beside another language: not the robot's.
    std::uint64_t overheard_ = 0;
    std::uint64_t overheard_bad_ = 0;
    std::uint64_t mavlink_frames_before_ = 0;
    std::uint64_t bytes_ = 0;
    std::uint16_t request_sequence_ = 0;
};

}  // namespace hedr
