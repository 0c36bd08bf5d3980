// A robot that signs, over a pseudo-terminal: what is believed, what is kept, what is computed
// again.
#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <QtTest/QTest>
#include <thread>

#include "core/mission/mission_reader.h"
#include "core/mission/mission_writer.h"
#include "radio/live_link.h"
#include "radio/recomputation.h"
#include "radio/robot_key.h"
#include "radio/robot_line.h"
#include "radio/wire/cobs.h"
#include "radio/wire/frame_decoder.h"
#include "radio/wire/frame_encoder.h"
#include "radio/wire/signing/frame_signer.h"
#include "tests/radio/spoken_drive.h"

namespace hedr {
namespace {

using Bytes = std::vector<std::uint8_t>;

void append(Bytes& bytes, std::span<const std::uint8_t> more) {
    bytes.insert(bytes.end(), more.begin(), more.end());
}

// Each frame of a drive, signed; behind every tenth comes one that somebody else has made: changed,
// repeated, or without a signature.
Bytes signedDrive(const SigningKey& key, std::uint32_t said, bool with_forgers) {
    FrameSigner signer(key, said);
    FrameDecoder decoder;
    Bytes bytes;
    Bytes earlier;
    int count = 0;
    decoder.feed(spoken(straightDrive(20.0)), [&](const Frame& frame) {
        const FrameBytes plain = encodeFrame(frame);
        const FrameBytes good = signer.sign(plain).value();
        append(bytes, good.view());
        if (!with_forgers || ++count % 10 != 0) return;
        SigningKey wrong = key;
        wrong[0] = static_cast<std::uint8_t>(wrong[0] ^ 1U);
        FrameSigner forger(wrong, said + 1000);
        if (count % 30 == 0) append(bytes, forger.sign(plain).value().view());
        if (count % 30 == 10) append(bytes, plain.view());
        if (count % 30 == 20) append(bytes, earlier);
        earlier.assign(good.view().begin(), good.view().end());
    });
    return bytes;
}

class SignedLink : public ::testing::Test {
  protected:
    void SetUp() override {
        key_ = newKey("test");
        ASSERT_TRUE(writeSecretFile(keyFileOf(keys(), "test"), keyText(key_)));
    }
    std::filesystem::path keys() const { return folder_.filePath("keys").toStdString(); }
    std::filesystem::path mission() const { return folder_.filePath("m.hedr").toStdString(); }

    // The last batch of a link that has heard all of it.
    LiveBatch hear(const Bytes& bytes, const std::filesystem::path& keys) {
        const QString port = folder_.filePath("robot");
        RobotLine line = RobotLine::openPseudoTerminal(port.toStdString()).value();
        LiveLink link(
            {.vehicle = {},
             .mission = mission(),
             .header = {.start = std::chrono::system_clock::now(), .program_version = "test"},
             .keys = keys});
        LiveBatch last;
        QObject::connect(&link, &LiveLink::batchReady,
                         [&](const LiveBatch& batch) { last = batch; });
        link.open(SerialAddress{port});
        bytes_sent_ += bytes.size();
        std::thread robot([&] { line.send(bytes); });
        EXPECT_TRUE(QTest::qWaitFor([&] { return last.link.bytes >= bytes_sent_; }, 20000));
        robot.join();
        link.close();
        return last;
    }

    QTemporaryDir folder_;
    RobotKey key_;
    std::uint64_t bytes_sent_ = 0;  // all of them are in the one mission
};

TEST_F(SignedLink, BelievesTheRobotAndNobodyElse) {
    const LiveBatch last = hear(signedDrive(key_.key, 0, true), keys());
    EXPECT_FALSE(last.key_error);
    EXPECT_GT(last.signing.signed_frames, 1000U);
    EXPECT_EQ(last.signing.no_key, 0U);
    EXPECT_EQ(last.signing.unsigned_frames, 0U);
    EXPECT_GT(last.signing.bad_tag, 20U);
    EXPECT_GT(last.signing.replayed, 20U);
    EXPECT_GT(last.signing.unsigned_refused, 20U);
    EXPECT_EQ(last.link.lost_frames, 0U) << "a stranger's numbers do not count";
    EXPECT_NEAR(last.driven_m, 9.0, 0.1);
    for (const char* track : {"odometry", "hedr", "robot"}) {
        const auto again = recomputeTrack(mission(), track, {});
        ASSERT_TRUE(again) << track;
        EXPECT_TRUE(again->as_live) << track << ", without the key";
    }
}

TEST_F(SignedLink, YesterdaysRecordingIsNotBelievedToday) {
    const Bytes yesterday = signedDrive(key_.key, 0, false);
    EXPECT_GT(hear(yesterday, keys()).signing.signed_frames, 1000U);
    const LiveBatch today = hear(yesterday, keys());
    EXPECT_EQ(today.signing.replayed, today.signing.rejected());
    EXPECT_GT(today.signing.replayed, 1000U);
    EXPECT_FALSE(today.last_frame) << "what is not believed does not look alive";
    // Of the mission before what was believed then, and the new ones.
    const LiveBatch live = hear(signedDrive(key_.key, 100'000, false), keys());
    EXPECT_EQ(live.signing.signed_frames, 2 * today.signing.replayed);
    EXPECT_TRUE(recomputeTrack(mission(), "hedr", {}).value().as_live);
}

TEST_F(SignedLink, ARecordingIsBelievedAsItWasThen) {
    const LiveBatch live = hear(signedDrive(key_.key, 0, true), keys());
    LiveLink link({.vehicle = {},
                   .mission = folder_.filePath("played.hedr").toStdString(),
                   .header = {.start = std::chrono::system_clock::now(), .program_version = "test"},
                   .keys = keys()});
    LiveBatch last;
    QObject::connect(&link, &LiveLink::batchReady, [&](const LiveBatch& batch) { last = batch; });
    link.open(RecordingAddress{QString::fromStdString(mission().string()), 10000.0});
    ASSERT_TRUE(QTest::qWaitFor([&] { return last.link.bytes >= bytes_sent_; }, 20000));
    link.close();
    EXPECT_EQ(last.signing, live.signing);
    EXPECT_EQ(last.driven_m, live.driven_m);
}

TEST_F(SignedLink, WithoutTheKeyItSaysSoAndBelievesNothing) {
    const LiveBatch last = hear(signedDrive(key_.key, 0, false), {});
    EXPECT_EQ(last.signing.signed_frames, 0U);
    EXPECT_GT(last.signing.no_key, 1000U);
    EXPECT_EQ(last.driven_m, 0.0);
}

TEST_F(SignedLink, ARecordingWithoutTheKeyIsComputedWithItLater) {
    const Bytes drive = signedDrive(key_.key, 0, true);
    hear(drive, {});
    const auto unheard = recomputeTrack(mission(), "hedr", {});
    ASSERT_FALSE(unheard);
    EXPECT_EQ(unheard.error().code, ErrorCode::kMissionSigned);
    const auto with_another = recomputeTrack(mission(), "hedr", {.key = newKey("test")});
    ASSERT_FALSE(with_another);
    EXPECT_NE(with_another.error().detail.find("not with this key"), std::string::npos)
        << with_another.error().detail;

    const auto later = recomputeTrack(mission(), "hedr", {.key = key_});
    ASSERT_TRUE(later);
    const auto with_key = folder_.filePath("with_key.hedr").toStdString();
    auto live = MissionWriter::create(with_key, {});
    ASSERT_TRUE(live && live->writeBytes(0.0, signedDrive(key_.key, 0, false)) && live->commit());
    const auto unforged = recomputeTrack(with_key, "hedr", {.key = key_});
    ASSERT_TRUE(unforged);
    EXPECT_EQ(later->points, unforged->points) << "nothing of the forgers'";
    EXPECT_NEAR(later->points.back().pose.position.x, 9.0, 0.1);
}

TEST_F(SignedLink, ARobotWhoseKeyCannotBeUsedIsNotBelievedUnsigned) {
    std::filesystem::permissions(keyFileOf(keys(), "test"), std::filesystem::perms::all);
    const LiveBatch last = hear(spoken(straightDrive(10.0)), keys());
    ASSERT_TRUE(last.key_error);
    EXPECT_EQ(last.key_error->code, ErrorCode::kKeyExposed);
    EXPECT_EQ(last.driven_m, 0.0);
    EXPECT_GT(last.signing.unsigned_refused, 100U);
}

TEST_F(SignedLink, ARobotWhoseKeysAnybodyMayReplaceIsNotBelievedUnsigned) {
    std::filesystem::permissions(keys(), std::filesystem::perms::all);
    const LiveBatch last = hear(spoken(straightDrive(10.0)), keys());
    ASSERT_TRUE(last.key_error);
    EXPECT_EQ(last.driven_m, 0.0);
    EXPECT_GT(last.signing.unsigned_refused, 100U);
}

// Lines of text cannot be signed.
TEST_F(SignedLink, AMissionThatGoesOnDemandsSignaturesInEveryLanguage) {
    const LiveBatch before = hear(signedDrive(key_.key, 0, false), keys());
    std::string text = "\r\nt_ms,left_ticks,right_ticks\r\n";
    for (int i = 0; i < 500; ++i) {
        const std::string ticks = std::to_string(20 * i);
        text.append(std::to_string(10 * i)).append(",").append(ticks).append(",");
        text.append(ticks).append("\r\n");
    }
    const LiveBatch last = hear({text.begin(), text.end()}, keys());
    EXPECT_TRUE(last.demands_signing);
    EXPECT_EQ(last.language, RobotLanguage::kUnknown);
    EXPECT_EQ(last.link.good_frames, before.link.good_frames);
    EXPECT_EQ(last.driven_m, before.driven_m);
    EXPECT_TRUE(recomputeTrack(mission(), "hedr", {}).value().as_live);
}

}  // namespace
}  // namespace hedr
