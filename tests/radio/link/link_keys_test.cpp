#include "radio/link/link_keys.h"

#include <gtest/gtest.h>

#include "radio/wire/codec.h"
#include "radio/wire/frame_decoder.h"
#include "radio/wire/request.h"
#include "tests/core/text/scratch_folder.h"
#include "tests/radio/spoken_drive.h"

namespace hedr {
namespace {

// A folder in the place of a file stands for a disk that cannot be written.
TEST(LinkKeys, CountersThatCannotBeWrittenAreTriedAgainAndNothingIsSentUntilThen) {
    const ScratchFolder folder;
    const RobotKey key = newKey("test");
    const auto file = keyFileOf(folder.path(), "test");
    ASSERT_TRUE(writeSecretFile(file, keyText(key)));
    LinkKeys keys = LinkKeys::load(folder.path());
    FrameVerifier verifier = keys.verifier();
    FrameSigner robot(key.key, 0);
    FrameDecoder().feed(robot.sign(encodeReport(ParameterReport{1, 2}, 0).value()).value().view(),
                        [&](const Frame& frame) { verifier.judge(frame); });
    ASSERT_TRUE(verifier.demandsSigning());

    auto counters = file;
    counters.replace_extension(".counters");
    std::filesystem::create_directories(counters / "full");
    const FrameBytes question = encodeRequest(ParameterGet{1}, 0);
    const std::vector<std::uint8_t> plain(question.view().begin(), question.view().end());
    EXPECT_FALSE(keys.keepHeard(verifier));
    EXPECT_FALSE(keys.keepHeard(verifier)) << "it is not forgotten";
    for (int i = 0; i < 2; ++i) EXPECT_FALSE(keys.outgoing(verifier, plain));

    std::filesystem::remove_all(counters);
    EXPECT_TRUE(keys.keepHeard(verifier));
    EXPECT_TRUE(std::filesystem::is_regular_file(counters));
    const auto sent = keys.outgoing(verifier, plain);
    ASSERT_TRUE(sent);
    EXPECT_FALSE(sent->empty());
}

}  // namespace
}  // namespace hedr
