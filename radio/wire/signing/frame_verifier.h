#pragma once

#include <optional>
#include <string>
#include <vector>

#include "radio/wire/signing/replay_window.h"
#include "radio/wire/signing/signed_frame.h"

namespace hedr {

// Why a good frame is not believed. Missions keep the numbers.
enum class RejectReason : std::uint8_t {
    kNoKey = 1,     // it is signed, and there is no key at all to check it with
    kBadTag = 2,    // of no key that is known, or changed on the way
    kReplayed = 3,  // its counter was used before or is too old; or one of ours came back
    kUnsigned = 4,  // where signing is demanded
};

// With `index` counting the good frames of a link from 0, what a mission needs to be computed again
// without the key.
struct RejectedFrame {
    std::uint64_t index = 0;
    RejectReason reason{};
    friend bool operator==(const RejectedFrame&, const RejectedFrame&) = default;
};

struct Judgement {
    std::uint64_t index = 0;
    bool is_signed = false;
    std::optional<RejectReason> rejected{};  // none: accepted
    Frame frame{};  // where accepted: the plain frame, in the memory of the one that was judged
};

struct SigningCounters {
    std::uint64_t signed_frames = 0;    // accepted
    std::uint64_t unsigned_frames = 0;  // accepted
    std::uint64_t no_key = 0;           // from here on: rejected
    std::uint64_t bad_tag = 0;
    std::uint64_t replayed = 0;
    std::uint64_t unsigned_refused = 0;

    std::uint64_t rejected() const { return no_key + bad_tag + replayed + unsigned_refused; }
    friend bool operator==(const SigningCounters&, const SigningCounters&) = default;
};

// Says of each good frame of one link whether to believe it. Unsigned ones are accepted until
// signing is demanded: by the policy, by the first frame that verifies (its key is the robot's from
// then on), or by an unsigned hello in the name of a robot that has a key. There is no way back, so
// a link that comes back keeps its verifier; an operator who connects anew gets a new one.
class FrameVerifier {
  public:
    struct Key {
        std::string name;  // the robot's, as its hello says it
        SigningKey key{};
        std::uint32_t heard = 0;  // nothing up to this counter is accepted
    };
    enum class Policy : std::uint8_t { kSignedIfRobotSigns, kSignedOnly };

    // Without a key every unsigned frame is accepted and every signed one rejected.
    explicit FrameVerifier(std::vector<Key> keys = {}, Policy policy = Policy::kSignedIfRobotSigns);
    // Judges as it was judged when a mission was recorded; `rejected` in the order of the index.
    static FrameVerifier recomputing(std::vector<RejectedFrame> rejected);
    // The same for this one, until useKeys(): for a mission that goes on, or is played. Counts from
    // the next frame.
    void useRecord(std::vector<RejectedFrame> rejected);
    void useKeys() { recomputing_ = false; }

    Judgement judge(const Frame& frame);

    const SigningCounters& counters() const { return counters_; }
    bool demandsSigning() const { return demands_signing_; }
    // Whose frames verify; nothing before the first of them.
    const Key* robot() const { return robot_ ? &keys_[*robot_].key : nullptr; }

    // The highest counter of the robot so far: to be kept when the link is closed.
    std::uint32_t heard() const { return robot_ ? keys_[*robot_].window.highest() : 0; }
    // Once after each change, every kHeardStep frames: to be kept (radio/robot_key.h) before the
    // accepted frames are used. After a crash nothing up to it is accepted, so nothing twice.
    std::optional<std::uint32_t> takeHeardLimit();
    static constexpr std::uint32_t kHeardStep = 256;

  private:
    struct KnownKey {
        Key key;
        ReplayWindow window;
    };

    std::optional<RejectReason> recordedReason(const Judgement& judgement);
    std::optional<RejectReason> reasonAgainst(const Frame& frame);
    std::optional<RejectReason> reasonAgainstUnsigned(const Frame& frame);
    std::optional<std::size_t> keyOf(const Frame& frame) const;
    bool saysNameOfAKey(const Frame& frame) const;
    void follow(std::size_t key);
    void count(const Judgement& judgement);

    std::vector<KnownKey> keys_;
    bool demands_signing_ = false;
    std::optional<std::size_t> robot_{};
    std::uint32_t heard_limit_ = 0;
    bool heard_limit_changed_ = false;
    std::uint64_t next_index_ = 0;
    SigningCounters counters_{};

    bool recomputing_ = false;
    std::vector<RejectedFrame> recorded_{};
    std::size_t next_recorded_ = 0;
};

}  // namespace hedr
