// Whoever has no key: no bytes on the line are believed, whatever was heard before. And any text as
// a key file. The first byte chooses.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "radio/firmware/hedr_robot.h"
#include "radio/wire/codec.h"
#include "radio/wire/frame_decoder.h"
#include "radio/wire/signing/frame_signer.h"
#include "radio/wire/signing/frame_verifier.h"
#include "radio/wire/signing/key_text.h"

namespace {

using namespace hedr;
using Bytes = std::span<const std::uint8_t>;

constexpr SigningKey kKey{0x5A, 1, 2, 3};

void demand(bool holds) {
    if (!holds) {
        std::abort();
    }
}

// A mission that was judged live gives the same frames again without the key.
class Link {
  public:
    void judge(const Frame& frame) {
        const Judgement judgement = live_.judge(frame);
        if (judgement.rejected) {
            rejected_.push_back({judgement.index, *judgement.rejected});
        }
        demand(live_.counters().signed_frames == 0);
        demand(live_.heard() == 0 && !live_.takeHeardLimit() && live_.robot() == nullptr);
        frames_.push_back({frame.id, frame.sequence, {frame.payload.begin(), frame.payload.end()}});
    }
    void judgeAgain() const {
        FrameVerifier again = FrameVerifier::recomputing(rejected_);
        for (const Kept& kept : frames_) {
            again.judge({.id = kept.id, .sequence = kept.sequence, .payload = kept.payload});
        }
        demand(again.counters() == live_.counters());
    }

  private:
    struct Kept {
        std::uint8_t id;
        std::uint16_t sequence;
        std::vector<std::uint8_t> payload;
    };
    FrameVerifier live_{{{"atlas", kKey, 0}, {"boris", {7}, 9}}};
    std::vector<RejectedFrame> rejected_;
    std::vector<Kept> frames_;
};

void laptopHears(Bytes line) {
    Link link;
    FrameDecoder().feed(line, [&](const Frame& frame) { link.judge(frame); });
    // Without the checksum in the way.
    for (Bytes rest = line; rest.size() > 4;) {
        const std::size_t size = std::min<std::size_t>(rest[3] % 64U, rest.size() - 4);
        link.judge({.id = rest[0], .sequence = rest[1], .payload = rest.subspan(4, size)});
        rest = rest.subspan(4 + size);
    }
    link.judgeAgain();
}

void robotHears(Bytes line) {
    const hedr_counters none{0, 0};
    hedr_signing signing;
    hedr_signing_init(&signing, kKey.data(), &none, [](const hedr_counters*) { std::abort(); });
    hedr_decoder decoder;
    hedr_decoder_init(&decoder);
    hedr_request request{};
    for (const std::uint8_t byte : line) {
        demand(hedr_decoder_push_signed(&decoder, &signing, byte, &request) == 0);
    }
    demand(signing.kept.heard == 0);
}

// What was signed comes out, however long it is.
void signs(Bytes message) {
    EventReport report;
    report.text.assign(message.begin(), message.end());
    FrameSigner signer(kKey, 3);
    const auto plain = encodeReport(report, 7);
    const auto result = signer.sign(plain.value());
    demand(result.has_value());
    FrameVerifier verifier({{"atlas", kKey, 3}});
    FrameDecoder().feed(result->view(), [&](const Frame& frame) {
        const Judgement judgement = verifier.judge(frame);
        demand(!judgement.rejected && decodeReport(judgement.frame).has_value());
    });
    demand(verifier.counters().signed_frames == 1);
}

void readsFiles(std::string_view text) {
    if (const auto key = parseKey(text, "fuzz.key")) {
        demand(parseKey(keyText(*key), "fuzz.key").value() == *key);
        demand(checkRobotName(key->name).has_value());
    }
    if (const auto counters = parseCounters(text, "fuzz.counters")) {
        demand(parseCounters(countersText(*counters), "fuzz.counters").value() == *counters);
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) {
        return 0;
    }
    const Bytes bytes = Bytes(data, size).subspan(1);
    switch (data[0] % 4) {
        case 0:
            laptopHears(bytes);
            break;
        case 1:
            robotHears(bytes);
            break;
        case 2:
            signs(bytes);
            break;
        default:
            readsFiles({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
            break;
    }
    return 0;
}
