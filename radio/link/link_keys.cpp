#include "radio/link/link_keys.h"

#include <algorithm>

namespace hedr {

LinkKeys LinkKeys::load(const std::filesystem::path& folder) {
    LinkKeys keys;
    StoredKeys stored = loadKeys(folder);
    keys.refused_ = std::move(stored.refused);
    keys.refused_names_ = std::move(stored.refused_names);
    for (StoredKey& key : stored.keys) {
        const auto counters = loadCounters(key.file);
        if (!counters) {
            keys.refused_.push_back(counters.error());
            keys.refused_names_.push_back(key.key.name);
            continue;
        }
        keys.keys_.push_back({std::move(key), *counters});
    }
    return keys;
}

FrameVerifier LinkKeys::verifier() const {
    std::vector<FrameVerifier::Key> keys;
    for (const Known& known : keys_) {
        keys.push_back({known.stored.key.name, known.stored.key.key, known.counters.heard});
    }
    for (const std::string& name : refused_names_) {
        keys.push_back({name, newKey(name).key});  // that nobody has
    }
    return FrameVerifier(std::move(keys));
}

LinkKeys::Known* LinkKeys::knownOf(const FrameVerifier& verifier) {
    const FrameVerifier::Key* robot = verifier.robot();
    const auto found = std::ranges::find_if(
        keys_, [&](const Known& known) { return robot && known.stored.key.name == robot->name; });
    return found == keys_.end() ? nullptr : &*found;
}

Result<void> LinkKeys::keepHeard(FrameVerifier& verifier) {
    const auto limit = verifier.takeHeardLimit();
    Known* known = knownOf(verifier);
    if (!known) return {};
    if (limit) {
        known->counters.heard = *limit;
        known->unsaved = true;
    }
    return save(*known);
}

// Tried again with everything that comes, until it succeeds.
Result<void> LinkKeys::save(Known& known) {
    if (!known.unsaved) return {};
    auto saved = saveCounters(known.stored.file, known.counters);
    known.unsaved = !saved;
    return saved;
}

Result<void> LinkKeys::close(const FrameVerifier& verifier) {
    Known* known = knownOf(verifier);
    if (!known) return {};
    known->counters.heard = verifier.heard();
    known->unsaved = true;
    return save(*known);
}

Result<std::vector<std::uint8_t>> LinkKeys::outgoing(const FrameVerifier& verifier,
                                                     const std::vector<std::uint8_t>& plain) {
    Known* known = knownOf(verifier);
    FrameBytes bytes;
    if (!verifier.demandsSigning()) return plain;
    if (!known || plain.size() > bytes.bytes.size()) return std::vector<std::uint8_t>();
    if (!signer_) {
        signer_.emplace(known->stored.key.key,
                        saidAtStart(known->counters, std::chrono::system_clock::now()));
    }
    std::ranges::copy(plain, bytes.bytes.begin());
    bytes.size = plain.size();
    const auto signed_bytes = signer_->sign(bytes);
    if (!signed_bytes) return std::vector<std::uint8_t>();
    if (const auto reserved = signer_->takeReserved()) {
        known->counters.said = *reserved;
        known->unsaved = true;
    }
    if (auto saved = save(*known); !saved) return tl::make_unexpected(saved.error());
    return std::vector<std::uint8_t>(signed_bytes->view().begin(), signed_bytes->view().end());
}

}  // namespace hedr
