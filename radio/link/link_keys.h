#pragma once

#include <optional>
#include <string>
#include <vector>

#include "radio/robot_key.h"
#include "radio/wire/signing/frame_signer.h"
#include "radio/wire/signing/frame_verifier.h"

namespace hedr {

// The keys of the robots that this computer knows, and their counters on disk, for one link.
class LinkKeys {
  public:
    // Those of a folder. What cannot be used is in refused(), and its robot is not believed at all:
    // a key that is there is never silently left out.
    static LinkKeys load(const std::filesystem::path& folder);

    const std::vector<Error>& refused() const { return refused_; }
    FrameVerifier verifier() const;

    // To be called after frames were judged and before they are used: keeps how far the robot's
    // counter went. Errors: those of saveCounters.
    Result<void> keepHeard(FrameVerifier& verifier);
    // When the link is closed: the exact counter.
    Result<void> close(const FrameVerifier& verifier);

    // The request in the form that the robot of the verifier wants: signed with its key, or as it
    // is where it has none; empty where it must be signed and cannot be, as before the first frame
    // of a mission that goes on. Errors: those of saveCounters; then nothing may be sent.
    Result<std::vector<std::uint8_t>> outgoing(const FrameVerifier& verifier,
                                               const std::vector<std::uint8_t>& plain);

  private:
    struct Known {
        StoredKey stored;
        KeyCounters counters{};
        bool unsaved = false;  // the counters, on disk
    };
    Result<void> save(Known& known);
    Known* knownOf(const FrameVerifier& verifier);

    std::vector<Known> keys_;
    std::vector<Error> refused_;
    std::vector<std::string> refused_names_;  // of their robots
    std::optional<FrameSigner> signer_{};
};

}  // namespace hedr
