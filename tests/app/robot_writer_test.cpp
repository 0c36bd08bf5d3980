#include "app/robot_writer.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>
#include <map>

namespace hedr {
namespace {

// A robot's link in which the answers come when the test says so.
class WritingToARobot : public testing::Test {
  protected:
    // What is asked now is answered so, and the robot does what it was told if it was heard.
    void answer(RequestState state = RequestState::kDone, bool heard = true) {
        ASSERT_TRUE(asked_) << "nothing was asked";
        RequestProgress progress{.ticket = ticket_, .wish = *asked_, .state = state};
        asked_.reset();
        if (heard) {
            if (const auto* set = std::get_if<ParameterSet>(&progress.wish))
                robot[set->id] = set->value;
            const auto* get = std::get_if<ParameterGet>(&progress.wish);
            const std::uint8_t id = get ? get->id : std::get<ParameterSet>(progress.wish).id;
            progress.value = robot[id];
        }
        LiveBatch batch;
        batch.port = port;
        batch.frames_per_s = frames_per_s;
        batch.requests = {progress};
        writer.hear(batch);
    }
    void answerAll() {
        while (asked_) answer();
    }
    void hearAgain() {
        LiveBatch batch;
        batch.port = PortState::kOpen;
        batch.frames_per_s = 20.0;
        writer.hear(batch);
    }

    std::map<std::uint8_t, std::int32_t> robot{{2, 183'000}, {3, 650'000}};
    PortState port = PortState::kOpen;
    double frames_per_s = 20.0;
    std::optional<Request> asked_{};
    std::uint64_t ticket_ = 0;
    RobotWriter writer{{{2, 184'000}, {3, 660'000}},
                       [this](std::uint64_t ticket, const Request& request) {
                           EXPECT_FALSE(asked_) << "one at a time";
                           ticket_ = ticket;
                           asked_ = request;
                       }};
    QSignalSpy ended{&writer, &RobotWriter::ended};
    QSignalSpy delayed{&writer, &RobotWriter::delayed};
};

TEST_F(WritingToARobot, GivesItAllAndSaysSo) {
    writer.start();
    answerAll();
    ASSERT_EQ(ended.count(), 1);
    EXPECT_EQ(ended[0][0].toString(), "");
    EXPECT_EQ(robot[2], 184'000);
    EXPECT_EQ(robot[3], 660'000);
    EXPECT_EQ(delayed.count(), 0);
}

// It is silent from the second value on, and heard again a while later.
TEST_F(WritingToARobot, ThatFallsSilentInMidWriteGetsBackWhatItHad) {
    writer.start();
    for (int reads = 0; reads < 2; ++reads) answer();
    answer();
    EXPECT_EQ(robot[2], 184'000);
    frames_per_s = 0.0;
    answer(RequestState::kNoAnswer, true);  // it may have heard
    answer(RequestState::kNoAnswer, false);
    EXPECT_EQ(delayed.count(), 1);
    EXPECT_EQ(ended.count(), 0);
    hearAgain();
    answerAll();
    ASSERT_EQ(ended.count(), 1);
    EXPECT_EQ(ended[0][0].toString(), "The robot did not answer.");
    EXPECT_EQ(robot[2], 183'000);
    EXPECT_EQ(robot[3], 650'000);
}

TEST_F(WritingToARobot, ThatIsNotHeardAtAllIsLeftAlone) {
    writer.start();
    answer(RequestState::kNoAnswer, false);
    ASSERT_EQ(ended.count(), 1);
    EXPECT_EQ(ended[0][0].toString(), "The robot did not answer. Nothing was written.");
}

TEST_F(WritingToARobot, WaitsWhileThePortIsGone) {
    writer.start();
    for (int reads = 0; reads < 2; ++reads) answer();
    port = PortState::kGone;
    answer(RequestState::kCanceled, true);
    answer(RequestState::kCanceled, false);
    EXPECT_EQ(delayed.count(), 1);
    EXPECT_FALSE(asked_);
    hearAgain();
    answerAll();
    EXPECT_EQ(robot[2], 183'000);
}

// It moves: it is not asked without a pause, and not told that it is not heard.
TEST_F(WritingToARobot, WaitsWhileTheRobotRefusesWhatItHad) {
    writer.start();
    for (int reads = 0; reads < 2; ++reads) answer();
    answer();
    answer(RequestState::kRefused, false);
    answer(RequestState::kRefused, false);
    ASSERT_EQ(delayed.count(), 1);
    EXPECT_EQ(delayed[0][0].toString(), "The robot refused a value.");
    hearAgain();
    EXPECT_FALSE(asked_) << "not at once";
    ASSERT_TRUE(QTest::qWaitFor([&] { return asked_.has_value(); }, 20000));
    answerAll();
    ASSERT_EQ(ended.count(), 1);
    EXPECT_EQ(robot[2], 183'000);
}

}  // namespace
}  // namespace hedr
