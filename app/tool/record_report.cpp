#include "app/tool/record_report.h"

#include <array>
#include <chrono>
#include <cstdio>
#include <iostream>
#include <utility>

#include "app/tool/command.h"
#include "radio/robot_key.h"
#include "ui/link/link_advice.h"

namespace hedr::tool {

namespace {

// By then it is known why nothing is understood, and a robot that is switched on is there.
constexpr std::chrono::seconds kPatience{3};

}  // namespace

RecordReport::RecordReport(std::string port, std::string mission)
    : port_(std::move(port)), mission_(std::move(mission)) {}

void RecordReport::take(const LiveBatch& batch) {
    link_.note(batch, ReceiveClock::now());
    last_ = batch;
    last_.tracks.clear();
    last_.link_samples.clear();
    if (batch.port == PortState::kOpen && !std::exchange(was_open_, true))
        std::cerr << "Recording " << port_ << " to " << mission_ << ", Ctrl+C ends it\n";
    if (!was_open_ && isAwaited(batch) && !std::exchange(told_waiting_, true))
        std::cerr << "Waiting for the robot to connect to " << port_ << ", Ctrl+C ends it\n";
    for (const Error& warning : batch.warnings) warn(warning);
    tellOfTrust(batch);
}

// The recording goes on, for every byte is kept.
void RecordReport::tellOfTrust(const LiveBatch& batch) {
    if (batch.key_error && !std::exchange(told_key_error_, true)) warn(*batch.key_error);
    const bool strange = batch.signing.no_key + batch.signing.bad_tag > 0;
    if (strange && batch.signing.signed_frames == 0 && !std::exchange(told_no_key_, true)) {
        std::cerr << "hedr: The robot signs what it says, and this computer has no key for it: "
                     "nothing of it is believed. Copy its key file into "
                  << defaultKeyFolder().string()
                  << " and start again. What is recorded until then can be computed with hedr "
                     "fuse --key.\n";
    }
}

void RecordReport::tellLink() {
    if (!was_open_) return;
    const auto now = ReceiveClock::now();
    const LinkVerdict link = judgeLink(link_.facts(), now);
    const LinkTrouble trouble = link.trouble;
    if (trouble != trouble_) trouble_since_ = now;
    trouble_ = trouble;
    const bool lasts = trouble == LinkTrouble::kNone || now - trouble_since_ >= kPatience;
    if (!lasts || trouble == told_) return;
    told_ = trouble;
    std::string said = linkAdvice(last_, link, Clock{}).toStdString();
    if (trouble == LinkTrouble::kNone) said = "The robot is heard again.";
    std::cerr << "hedr: " << said << '\n';
}

void RecordReport::finish() const {
    if (!was_open_) return;
    const auto begin = last_.mission_begin;
    const std::chrono::duration<double> duration =
        begin ? ReceiveClock::now() - *begin : ReceiveClock::duration{};
    std::array<char, 32> seconds{};
    std::snprintf(seconds.data(), seconds.size(), "%.1f", duration.count());
    std::cerr << "Recorded " << seconds.data() << " s: " << last_.link.bytes << " bytes, "
              << last_.link.good_frames << " good frames";
    if (last_.robot) std::cerr << " of " << last_.robot->vehicle;
    if (last_.link.bad_frames > 0) std::cerr << ", " << last_.link.bad_frames << " bad ones";
    std::cerr << '\n';
}

}  // namespace hedr::tool
