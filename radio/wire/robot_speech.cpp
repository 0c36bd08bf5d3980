#include "radio/wire/robot_speech.h"

#include <algorithm>
#include <limits>

#include "radio/wire/codec.h"

namespace hedr {

namespace {

constexpr std::uint64_t kSureOfMavlink = 3;  // its checksum has 16 bits only
constexpr std::uint8_t kFrameEnd = 0;        // of protocol 1

WireCounters operator+(const WireCounters& a, const WireCounters& b) {
    return {.bytes = 0,
            .good_frames = a.good_frames + b.good_frames,
            .bad_frames = a.bad_frames + b.bad_frames,
            .lost_frames = a.lost_frames + b.lost_frames,
            .late_frames = a.late_frames + b.late_frames,
            .unknown_frames = a.unknown_frames + b.unknown_frames};
}

}  // namespace

void RobotSpeech::feed(std::span<const std::uint8_t> bytes, const OnReport& on_report) {
    bytes_ += bytes.size();
    // Byte by byte, so that the one that decides is the same however they are cut.
    for (; language_ == RobotLanguage::kUnknown && !bytes.empty(); bytes = bytes.subspan(1)) {
        listenForLanguage(bytes.first(1), on_report);
    }
    while (language_ != RobotLanguage::kHedr && !bytes.empty()) {
        const auto end = std::ranges::find(bytes, kFrameEnd);
        const auto size =
            static_cast<std::size_t>(end - bytes.begin()) + (end == bytes.end() ? 0U : 1U);
        listenForSignatures(bytes.first(size), on_report);
        bytes = bytes.subspan(size);
    }
    if (!bytes.empty()) hedr_.feed(bytes, on_report);
}

// A robot that signs is listened to from its first signed frame on, whatever others said before it
// was there. `bytes` hold at most one end of a frame, so that the frame that decides is the same
// however they are cut.
void RobotSpeech::listenForSignatures(std::span<const std::uint8_t> bytes,
                                      const OnReport& on_report) {
    if (language_ == RobotLanguage::kMavlink) mavlink_.feed(bytes, on_report);
    if (language_ == RobotLanguage::kText) text_.feed(bytes, on_report);
    std::vector<Report> hedr;
    const std::uint64_t believed_before = hedrBelieved();
    const std::uint64_t bad_before = hedr_.counters().bad_frames;
    hedr_.feed(bytes, [&](const Report& report) { hedr.push_back(report); });
    overheard_bad_ += hedr_.counters().bad_frames - bad_before;
    if (!verifier().demandsSigning()) {
        overheard_ += hedrBelieved() - believed_before;
        return;
    }
    language_ = RobotLanguage::kHedr;
    for (const Report& report : hedr) on_report(report);
}

// What the byte completes counts where it shows the language; what came before does not. Where
// signing is demanded only the language that can sign is listened to: another one would be a way
// around the signatures.
void RobotSpeech::listenForLanguage(std::span<const std::uint8_t> byte, const OnReport& on_report) {
    std::vector<Report> hedr;
    std::vector<Report> mavlink;
    std::vector<Report> text;
    hedr_.feed(byte, [&](const Report& report) { hedr.push_back(report); });
    if (!verifier().demandsSigning()) {
        mavlink_.feed(byte, [&](const Report& report) { mavlink.push_back(report); });
        text_.feed(byte, [&](const Report& report) { text.push_back(report); });
    }
    language_ = recognised();
    const auto& said = language_ == RobotLanguage::kHedr      ? hedr
                       : language_ == RobotLanguage::kMavlink ? mavlink
                                                              : text;
    if (language_ == RobotLanguage::kUnknown) return;
    for (const Report& report : said) on_report(report);
}

RobotSpeech::Heard RobotSpeech::heard() const {
    return {.hedr = hedr_.counters().good_frames - overheard_,
            .mavlink = mavlink_.vehicle() ? mavlink_.counters().good_frames : 0,
            .text = text_.recognised() ? text_.counters().good_frames : 0};
}

RobotLanguage RobotSpeech::recognised() const {
    const Heard now = heard();
    if (now.hedr > before_.hedr) return RobotLanguage::kHedr;
    if (now.mavlink >= before_.mavlink + kSureOfMavlink) return RobotLanguage::kMavlink;
    if (now.text > before_.text) return RobotLanguage::kText;
    return RobotLanguage::kUnknown;
}

void RobotSpeech::portOpened() {
    hedr_.portOpened();
    mavlink_.portOpened();
    text_.portOpened();
    before_ = heard();
    mavlink_frames_before_ = mavlink_.counters().good_frames;
    language_ = RobotLanguage::kUnknown;
}

std::uint64_t RobotSpeech::believedFrames() const {
    return hedrBelieved() - overheard_ + mavlink_.robotFrames() + heard().text;
}

bool RobotSpeech::makesSense() const {
    const Heard now = heard();
    return now.hedr > before_.hedr || now.text > before_.text ||
           mavlink_.counters().good_frames >= mavlink_frames_before_ + kSureOfMavlink;
}

// Of the languages that were understood. A robot's bytes are damaged frames to the others.
WireCounters RobotSpeech::counters() const {
    const Heard all = heard();
    WireCounters sum;
    if (all.hedr > 0) {
        sum = sum + hedr_.counters();
        sum.good_frames -= overheard_;
        sum.bad_frames -= overheard_bad_;
    }
    if (all.mavlink > 0) sum = sum + mavlink_.counters();
    if (all.text > 0) sum = sum + text_.counters();
    if (all.hedr + all.mavlink + all.text == 0) sum.bad_frames = hedr_.counters().bad_frames;
    sum.bytes = bytes_;
    return sum;
}

double RobotSpeech::clockPeriod_s() const {
    const bool wraps = language_ == RobotLanguage::kHedr || language_ == RobotLanguage::kUnknown;
    return wraps ? kRobotClockPeriod_s : std::numeric_limits<double>::infinity();
}

std::vector<std::uint8_t> RobotSpeech::spoken(const Request& request) {
    const std::uint16_t sequence = request_sequence_++;
    if (language_ == RobotLanguage::kText) return {};
    if (language_ == RobotLanguage::kMavlink) {
        const auto frame = encodeMavlinkRequest(request, static_cast<std::uint8_t>(sequence),
                                                mavlink_.vehicle().value_or(MavlinkAddress{}),
                                                mavlink_.parameterCoding());
        return frame ? std::vector<std::uint8_t>(frame->view().begin(), frame->view().end())
                     : std::vector<std::uint8_t>();
    }
    const FrameBytes frame = encodeRequest(request, sequence);
    return {frame.view().begin(), frame.view().end()};
}

std::vector<std::vector<std::uint8_t>> RobotSpeech::wishesSpoken() {
    std::vector<std::vector<std::uint8_t>> wishes;
    if (language_ != RobotLanguage::kMavlink || !mavlink_.vehicle()) return wishes;
    for (const std::uint32_t message : mavlink_.neededMessages()) {
        const auto sequence = static_cast<std::uint8_t>(request_sequence_++);
        const MavlinkBytes frame =
            encodeMessageInterval(message, 1.0 / kWishedRate_hz, sequence, *mavlink_.vehicle());
        wishes.emplace_back(frame.view().begin(), frame.view().end());
    }
    return wishes;
}

}  // namespace hedr
