#include "radio/wire/signing/frame_verifier.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "radio/wire/codec.h"
#include "radio/wire/messages.h"

namespace hedr {
namespace {

bool hasRoomForSignature(const Frame& frame) { return frame.payload.size() >= kSignatureBytes; }

bool isOfKey(const SigningKey& key, const Frame& frame) {
    constexpr std::size_t kTagBytes = kSignatureBytes - kCounterBytes;
    const auto counted = frame.payload.first(frame.payload.size() - kTagBytes);
    return isTag(tagOf(key, frame, counted), frame.payload.last(kTagBytes));
}

}  // namespace

FrameVerifier::FrameVerifier(std::vector<Key> keys, Policy policy)
    : demands_signing_(policy == Policy::kSignedOnly) {
    for (Key& key : keys) {
        const ReplayWindow window(key.heard);
        keys_.push_back({std::move(key), window});
    }
}

FrameVerifier FrameVerifier::recomputing(std::vector<RejectedFrame> rejected) {
    FrameVerifier verifier;
    verifier.useRecord(std::move(rejected));
    return verifier;
}

void FrameVerifier::useRecord(std::vector<RejectedFrame> rejected) {
    recomputing_ = true;
    recorded_ = std::move(rejected);
    for (RejectedFrame& frame : recorded_) frame.index += next_index_;
    next_recorded_ = 0;
}

Judgement FrameVerifier::judge(const Frame& frame) {
    Judgement judgement{.index = next_index_++, .is_signed = isSigned(frame), .frame = frame};
    judgement.rejected = recomputing_ ? recordedReason(judgement) : reasonAgainst(frame);
    if (judgement.is_signed && !judgement.rejected) {
        judgement.frame = withoutSignature(frame);
    }
    // Follows from the judgements alone, so that a mission that goes on demands what it did.
    const bool verified = judgement.is_signed && !judgement.rejected;
    demands_signing_ =
        demands_signing_ || verified || judgement.rejected == RejectReason::kUnsigned;
    count(judgement);
    return judgement;
}

std::optional<RejectReason> FrameVerifier::recordedReason(const Judgement& judgement) {
    if (next_recorded_ < recorded_.size() && recorded_[next_recorded_].index == judgement.index) {
        return recorded_[next_recorded_++].reason;
    }
    // Such a frame was never accepted: the list is not this mission's.
    const bool impossible = judgement.is_signed && !hasRoomForSignature(judgement.frame);
    return impossible ? std::optional(RejectReason::kBadTag) : std::nullopt;
}

std::optional<RejectReason> FrameVerifier::reasonAgainst(const Frame& frame) {
    if (!isSigned(frame)) {
        return reasonAgainstUnsigned(frame);
    }
    if (keys_.empty()) {
        return RejectReason::kNoKey;
    }
    const std::optional<std::size_t> key = keyOf(frame);
    if (!key) {
        return RejectReason::kBadTag;
    }
    const bool is_ours = (frame.id & kFromLaptopBit) != 0;
    if (is_ours || !keys_[*key].window.take(counterOf(frame))) {
        return RejectReason::kReplayed;
    }
    follow(*key);
    return std::nullopt;
}

std::optional<RejectReason> FrameVerifier::reasonAgainstUnsigned(const Frame& frame) {
    const bool refused = demands_signing_ || saysNameOfAKey(frame);
    return refused ? std::optional(RejectReason::kUnsigned) : std::nullopt;
}

std::optional<std::size_t> FrameVerifier::keyOf(const Frame& frame) const {
    for (std::size_t i = 0; i < keys_.size() && hasRoomForSignature(frame); ++i) {
        if ((!robot_ || *robot_ == i) && isOfKey(keys_[i].key.key, frame)) {
            return i;
        }
    }
    return std::nullopt;
}

bool FrameVerifier::saysNameOfAKey(const Frame& frame) const {
    if (keys_.empty() || frame.id != kMessageId<HelloReport>) {
        return false;
    }
    const auto report = decodeReport(frame);
    return report && std::ranges::any_of(keys_, [&](const KnownKey& known) {
               return known.key.name == std::get<HelloReport>(*report).vehicle;
           });
}

void FrameVerifier::follow(std::size_t key) {
    if (!robot_) {
        robot_ = key;
        heard_limit_ = keys_[key].key.heard;
    }
    if (const std::uint32_t highest = heard(); highest > heard_limit_) {
        constexpr std::uint32_t kLast = std::numeric_limits<std::uint32_t>::max();
        heard_limit_ = highest < kLast - kHeardStep ? highest + kHeardStep : kLast;
        heard_limit_changed_ = true;
    }
}

std::optional<std::uint32_t> FrameVerifier::takeHeardLimit() {
    return std::exchange(heard_limit_changed_, false) ? std::optional(heard_limit_) : std::nullopt;
}

void FrameVerifier::count(const Judgement& judgement) {
    if (!judgement.rejected) {
        ++(judgement.is_signed ? counters_.signed_frames : counters_.unsigned_frames);
        return;
    }
    switch (*judgement.rejected) {
        case RejectReason::kNoKey:
            ++counters_.no_key;
            break;
        case RejectReason::kBadTag:
            ++counters_.bad_tag;
            break;
        case RejectReason::kReplayed:
            ++counters_.replayed;
            break;
        case RejectReason::kUnsigned:
            ++counters_.unsigned_refused;
            break;
    }
}

}  // namespace hedr
