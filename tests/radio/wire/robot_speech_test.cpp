#include "radio/wire/robot_speech.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/simulation/random.h"
#include "radio/receiver.h"
#include "radio/wire/frame_decoder.h"
#include "radio/wire/frame_encoder.h"
#include "radio/wire/mavlink/mavlink_codec.h"
#include "radio/wire/signing/frame_signer.h"
#include "tests/radio/spoken_drive.h"

namespace hedr {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes noise(std::size_t size, std::uint64_t seed = 1) {
    Random random(seed);
    Bytes bytes(size);
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.uniform() * 256.0);
    return bytes;
}

void append(Bytes& bytes, std::span<const std::uint8_t> more) {
    bytes.insert(bytes.end(), more.begin(), more.end());
}

// Ten metres straight on in five seconds, north.
Bytes mavlinkDrive() {
    Bytes bytes;
    MavlinkFrame header{.system = 1, .component = 1};
    const auto say = [&](const auto& message) {
        append(bytes, encodeMavlink(message, header).view());
        ++header.sequence;
    };
    for (int i = 0; i < 500; ++i) {
        const auto time_ms = static_cast<std::uint32_t>(10 * i);
        if (i % 50 == 0) say(MavlinkHeartbeat{.type = 10, .autopilot = 3});
        say(MavlinkAttitude{.time_boot_ms = time_ms});
        if (i % 5 == 0)
            say(MavlinkLocalPositionNed{.time_boot_ms = time_ms,
                                        .x = 0.02F * static_cast<float>(i)});
    }
    return bytes;
}

Bytes textDrive() {
    // A line of its own: a header that noise has run into names nothing.
    std::string text = "\r\nt_ms,left_ticks,right_ticks,gyro_dps\r\n";
    for (int i = 0; i < 500; ++i) {
        const std::string ticks = std::to_string(20 * i);
        text += std::to_string(10 * i) + ',' + ticks + ',' + ticks + ",0.0\r\n";
    }
    return {text.begin(), text.end()};
}

struct Spoken {
    const char* name;
    Bytes bytes;
    RobotLanguage language;
};

std::vector<Spoken> drives() {
    return {{"hedr", spoken(straightDrive(10.0)), RobotLanguage::kHedr},
            {"mavlink", mavlinkDrive(), RobotLanguage::kMavlink},
            {"text", textDrive(), RobotLanguage::kText}};
}

TEST(RobotSpeech, FindsTheLanguageAlsoBehindNoise) {
    for (const Spoken& drive : drives()) {
        for (const std::size_t before : {0U, 1U, 5000U}) {
            RobotSpeech speech;
            Bytes bytes = noise(before);
            append(bytes, drive.bytes);
            int reports = 0;
            speech.feed(bytes, [&](const Report&) { ++reports; });
            EXPECT_EQ(speech.language(), drive.language) << drive.name << " behind " << before;
            EXPECT_GT(reports, 100) << drive.name;
            EXPECT_EQ(speech.counters().bytes, bytes.size());
        }
    }
}

TEST(RobotSpeech, NoiseIsNoLanguage) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        RobotSpeech speech;
        speech.feed(noise(200'000, seed), [](const Report&) { ADD_FAILURE(); });
        EXPECT_EQ(speech.language(), RobotLanguage::kUnknown);
        EXPECT_EQ(speech.counters().good_frames, 0U);
    }
}

TEST(RobotSpeech, GivesTheSameReportsHoweverTheBytesAreCut) {
    for (const Spoken& drive : drives()) {
        Bytes bytes = noise(300);
        append(bytes, drive.bytes);
        std::vector<Report> whole;
        RobotSpeech speech;
        speech.feed(bytes, [&](const Report& report) { whole.push_back(report); });
        ASSERT_GT(whole.size(), 100U) << drive.name;
        for (const std::size_t piece : {1U, 7U, 1000U}) {
            std::vector<Report> cut;
            RobotSpeech again;
            for (std::size_t at = 0; at < bytes.size(); at += piece) {
                again.feed(std::span(bytes).subspan(at, std::min(piece, bytes.size() - at)),
                           [&](const Report& report) { cut.push_back(report); });
            }
            EXPECT_EQ(cut, whole) << drive.name << " in pieces of " << piece;
            EXPECT_EQ(again.counters(), speech.counters());
        }
    }
}

TEST(RobotSpeech, AnotherRobotMayBeAtTheOtherEndOfAPortThatWasOpenedAgain) {
    RobotSpeech speech;
    for (const Spoken& first : drives()) {
        for (const Spoken& second : drives()) {
            for (const Spoken& drive : {first, second}) {
                speech.portOpened();
                EXPECT_EQ(speech.language(), RobotLanguage::kUnknown);
                speech.feed(drive.bytes, [](const Report&) {});
                EXPECT_EQ(speech.language(), drive.language) << first.name << ", " << second.name;
            }
        }
    }
}

TEST(RobotSpeech, AsksInTheRobotsLanguage) {
    for (const Spoken& drive : drives()) {
        RobotSpeech speech;
        speech.feed(drive.bytes, [](const Report&) {});
        const Bytes question = speech.spoken(ParameterGet{3});
        const int first = question.empty() ? -1 : question.front();
        const int expected = drive.language == RobotLanguage::kHedr      ? 0x00
                             : drive.language == RobotLanguage::kMavlink ? 0xFD
                                                                         : -1;
        EXPECT_EQ(first, expected) << drive.name;
    }
}

TEST(Receiver, TracksRobotsOfEveryLanguage) {
    for (const Spoken& drive : drives()) {
        Vehicle vehicle = spokenVehicle();
        if (drive.language == RobotLanguage::kHedr) vehicle.name = "hello says it";
        Receiver receiver({.vehicle = vehicle});
        receiver.feed(drive.bytes);
        double furthest_m = 0.0;
        std::vector<std::string> names;
        for (const NamedPoints& track : receiver.takePoints()) {
            names.push_back(track.name);
            if (track.name == "odometry") furthest_m = track.points.back().pose.position.x;
        }
        // All but the first moments, in which the language was found.
        EXPECT_GT(furthest_m, drive.language == RobotLanguage::kMavlink ? 5.0 : 3.5) << drive.name;
        EXPECT_LT(furthest_m, 10.1) << drive.name;
        for (const char* name : {"odometry", "gyro", "hedr", "hedr_bayes"})
            EXPECT_TRUE(std::ranges::find(names, name) != names.end())
                << drive.name << ": " << name;
    }
}

std::string assumedWheels(const Bytes& bytes, const std::optional<Vehicle>& vehicle = {}) {
    Receiver receiver({.vehicle = vehicle});
    receiver.feed(bytes);
    EXPECT_TRUE(receiver.vehicle());
    return receiver.assumedWheels();
}

// Only where the way depends on them: a MAVLink robot without wheel sensors says its pose itself.
TEST(RobotSpeech, LeavesTheWheelsOpenInSomeLanguages) {
    EXPECT_EQ(assumedWheels(spoken(straightDrive(10.0))), "");
    EXPECT_EQ(assumedWheels(mavlinkDrive()), "");
    EXPECT_EQ(assumedWheels(textDrive()),
              "they are taken to measure 0.2 m, 0.4 m apart, with 1000 counts a turn");
    EXPECT_EQ(assumedWheels(textDrive(), spokenVehicle()), "");
    std::string travel = "\r\nt_ms,left_m,right_m\r\n";
    for (int i = 0; i < 200; ++i) travel += std::to_string(10 * i) + ",0.5,0.5\r\n";
    EXPECT_EQ(assumedWheels({travel.begin(), travel.end()}), "they are taken to be 0.4 m apart");
}

TEST(RobotSpeech, KnowsThatMavlinkMakesSenseBeforeItKnowsWhoseItIs) {
    RobotSpeech speech;
    const auto say = [&](std::uint8_t system, int times) {
        MavlinkFrame header{.system = system, .component = 1};
        for (; times > 0; --times, ++header.sequence)
            speech.feed(encodeMavlink(MavlinkAttitude{}, header).view(), [](const Report&) {});
    };
    say(1, 2);
    EXPECT_FALSE(speech.makesSense());
    say(1, 1);
    EXPECT_TRUE(speech.makesSense());
    EXPECT_EQ(speech.believedFrames(), 0U) << "nobody has said that it is a robot";
    const MavlinkFrame header{.system = 1, .component = 1};
    speech.feed(encodeMavlink(MavlinkHeartbeat{.type = 10, .autopilot = 3}, header).view(),
                [](const Report&) {});
    say(1, 5);
    const std::uint64_t believed = speech.believedFrames();
    EXPECT_EQ(believed, 6U);
    say(2, 5);
    EXPECT_EQ(speech.believedFrames(), believed) << "another system is not the robot";
    speech.portOpened();
    EXPECT_FALSE(speech.makesSense());
}

Bytes signedDrive(const SigningKey& key) {
    FrameSigner signer(key, 0);
    Bytes bytes;
    FrameDecoder decoder;
    decoder.feed(spoken(straightDrive(10.0)), [&](const Frame& frame) {
        append(bytes, signer.sign(encodeFrame(frame)).value().view());
    });
    return bytes;
}

TEST(RobotSpeech, ARobotThatSignsIsHeardWhateverWasSaidBeforeIt) {
    const SigningKey key{1, 2, 3};
    for (const Bytes& before : {mavlinkDrive(), textDrive()}) {
        Bytes bytes = before;
        append(bytes, signedDrive(key));
        append(bytes, before);
        std::vector<Report> whole;
        for (const std::size_t piece : {bytes.size(), std::size_t{1}, std::size_t{7}}) {
            RobotSpeech speech(std::nullopt, FrameVerifier({{"test", key}}));
            std::vector<Report> cut;
            for (std::size_t at = 0; at < bytes.size(); at += piece) {
                speech.feed(std::span(bytes).subspan(at, std::min(piece, bytes.size() - at)),
                            [&](const Report& report) { cut.push_back(report); });
            }
            EXPECT_EQ(speech.language(), RobotLanguage::kHedr);
            EXPECT_TRUE(speech.verifier().demandsSigning());
            if (whole.empty()) whole = cut;
            EXPECT_EQ(cut, whole) << piece;
        }
        RobotSpeech first;
        std::size_t said_before = 0;
        first.feed(before, [&](const Report&) { ++said_before; });
        RobotSpeech alone(std::nullopt, FrameVerifier({{"test", key}}));
        std::size_t said_signed = 0;
        alone.feed(signedDrive(key), [&](const Report&) { ++said_signed; });
        EXPECT_EQ(whole.size(), said_before + said_signed) << "nothing of what came behind it";
    }
}

TEST(RobotSpeech, UnsignedFramesBesideAnotherLanguageAreNotTheRobots) {
    RobotSpeech speech;
    speech.feed(mavlinkDrive(), [](const Report&) {});
    const WireCounters before = speech.counters();
    const std::uint64_t believed = speech.believedFrames();
    speech.feed(spoken(straightDrive(5.0)), [](const Report&) { ADD_FAILURE(); });
    EXPECT_EQ(speech.language(), RobotLanguage::kMavlink);
    EXPECT_EQ(speech.believedFrames(), believed);
    EXPECT_EQ(speech.counters().good_frames, before.good_frames);
}

}  // namespace
}  // namespace hedr
