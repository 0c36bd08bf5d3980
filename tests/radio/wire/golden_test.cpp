// The golden pairs in tests/golden/wire: what each message says, and its bytes. Both encoders must
// write them and both decoders must read them. HEDR_UPDATE_GOLDEN=1 writes the bytes anew: to be
// committed only with a new version of the protocol.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "radio/wire/frame_decoder.h"
#include "radio/wire/signing/frame_signer.h"
#include "tests/radio/wire/arbitrary_messages.h"
#include "tests/radio/wire/firmware_frames.h"
#include "tests/radio/wire/golden_message.h"

namespace hedr {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;

const fs::path kGoldenFolder = HEDR_SOURCE_DIR "/tests/golden/wire";

Bytes readBytes(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

struct Golden {
    std::string name;
    test::GoldenMessage message;
    Bytes bytes;
};

Bytes encoded(const test::GoldenMessage& golden) {
    const auto* report = std::get_if<Report>(&golden.message);
    FrameBytes frame = report != nullptr
                           ? encodeReport(*report, golden.sequence).value()
                           : encodeRequest(std::get<Request>(golden.message), golden.sequence);
    if (golden.signature) {
        FrameSigner signer(golden.signature->key, golden.signature->counter - 1);
        frame = signer.sign(frame).value();
    }
    return {frame.view().begin(), frame.view().end()};
}

std::vector<Golden> goldenPairs() {
    std::vector<Golden> pairs;
    for (const auto& entry : fs::directory_iterator(kGoldenFolder)) {
        if (entry.path().extension() != ".json") {
            continue;
        }
        std::ifstream in(entry.path());
        const auto message = test::goldenFromJson(nlohmann::json::parse(in));
        const fs::path bin = fs::path(entry.path()).replace_extension(".bin");
        if (std::getenv("HEDR_UPDATE_GOLDEN") != nullptr) {
            const Bytes bytes = encoded(message);
            std::ofstream(bin, std::ios::binary)
                .write(reinterpret_cast<const char*>(bytes.data()),
                       static_cast<std::streamsize>(bytes.size()));
        }
        pairs.push_back({entry.path().stem(), message, readBytes(bin)});
    }
    return pairs;
}

TEST(GoldenWire, HasAPairForEveryMessage) {
    std::set<std::size_t> reports;
    std::set<std::size_t> requests;
    for (const Golden& golden : goldenPairs()) {
        if (const auto* report = std::get_if<Report>(&golden.message.message)) {
            reports.insert(report->index());
        } else {
            requests.insert(std::get<Request>(golden.message.message).index());
        }
    }
    EXPECT_EQ(reports.size(), std::variant_size_v<Report>);
    EXPECT_EQ(requests.size(), std::variant_size_v<Request>);
}

TEST(GoldenWire, IsWhatTheCodecWrites) {
    for (const Golden& golden : goldenPairs()) {
        EXPECT_EQ(encoded(golden.message), golden.bytes) << golden.name;
    }
}

TEST(GoldenWire, IsWhatTheRobotWrites) {
    for (const Golden& golden : goldenPairs()) {
        if (const auto* report = std::get_if<Report>(&golden.message.message)) {
            Bytes bytes = test::FirmwareEncoder(golden.message.sequence).encode(*report);
            if (const auto& signature = golden.message.signature) {
                bytes = test::FirmwareSigner(signature->key, signature->counter - 1).sign(bytes);
            }
            EXPECT_EQ(bytes, golden.bytes) << golden.name;
        }
    }
}

TEST(GoldenWire, IsReadBackByTheCodec) {
    for (const Golden& golden : goldenPairs()) {
        int frames = 0;
        FrameDecoder().feed(golden.bytes, [&](const Frame& on_line) {
            ++frames;
            const auto& signature = golden.message.signature;
            EXPECT_EQ(isSigned(on_line), signature.has_value());
            const Frame frame = signature ? withoutSignature(on_line) : on_line;
            // Told by the bytes that come of it: 0.1 + 0.2 need not be 0.3 on the way.
            test::GoldenMessage again{frame.sequence, {}, signature};
            if (const auto report = decodeReport(frame)) {
                again.message = *report;
            } else {
                again.message = decodeRequest(frame).value();
            }
            EXPECT_EQ(again.message.index(), golden.message.message.index()) << golden.name;
            EXPECT_EQ(encoded(again), golden.bytes) << golden.name;
        });
        EXPECT_EQ(frames, 1) << golden.name;
    }
}

TEST(GoldenWire, IsUnderstoodByTheRobot) {
    for (const Golden& golden : goldenPairs()) {
        if (const auto* request = std::get_if<Request>(&golden.message.message)) {
            const auto& signature = golden.message.signature;
            const auto heard = signature
                                   ? test::FirmwareSigner(signature->key, 0).hear(golden.bytes)
                                   : test::firmwareRequests(golden.bytes);
            ASSERT_EQ(heard.size(), 1U) << golden.name;
            EXPECT_EQ(heard[0].sequence, golden.message.sequence);
            EXPECT_EQ(test::asRequest(heard[0]), *request) << golden.name;
        }
    }
}

}  // namespace
}  // namespace hedr
