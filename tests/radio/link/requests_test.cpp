#include "radio/link/requests.h"

#include <gtest/gtest.h>

#include <deque>
#include <map>

#include "core/simulation/random.h"
#include "radio/wire/codec.h"
#include "radio/wire/frame_decoder.h"
#include "tests/radio/spoken_drive.h"

namespace hedr {
namespace {

constexpr auto kGain = static_cast<std::uint8_t>(RobotParameter::kHedrGainUradS2);
constexpr auto kDirections = static_cast<std::uint8_t>(RobotParameter::kDominantDirections);

// A robot behind a radio that loses and delays in both directions.
class FarRobot {
  public:
    FarRobot(double loss, double longest_delay_s, std::uint64_t seed)
        : loss_(loss), longest_delay_s_(longest_delay_s), random_(seed) {
        robot_.sense({.robot_time_s = 0.0, .odometry = WheelTicks{}}, [](auto) {});
    }

    // Until every request is over, or for so long.
    void run(double seconds) {
        for (const double end_s = now_s_ + seconds; now_s_ < end_s; now_s_ += 0.01) {
            for (const Request& question : requests.due(now_s_)) {
                noteWrite(question);
                const FrameBytes frame = encodeRequest(question, sequence_++);
                send(there_, {frame.view().begin(), frame.view().end()});
            }
            deliver(there_, [this](const auto& bytes) {
                robot_.hear(bytes, [this](std::span<const std::uint8_t> answer) {
                    send(back_, {answer.begin(), answer.end()});
                });
            });
            deliver(back_, [this](const auto& bytes) {
                decoder_.feed(bytes, [this](const Frame& frame) {
                    if (const auto report = decodeReport(frame)) requests.hear(*report);
                });
            });
            for (const RequestProgress& news : requests.takeNews()) results[news.ticket] = news;
        }
    }

    Requests requests;
    std::map<std::uint64_t, RequestProgress> results;
    int two_writes_at_once = 0;

  private:
    struct Travelling {
        double arrives_s;
        std::vector<std::uint8_t> bytes;
    };

    void send(std::deque<Travelling>& way, std::vector<std::uint8_t> bytes) {
        if (random_.uniform() < loss_) return;
        double arrives_s = now_s_ + random_.uniform() * longest_delay_s_;
        if (!way.empty()) arrives_s = std::max(arrives_s, way.back().arrives_s);
        way.push_back({arrives_s, std::move(bytes)});
    }
    template <class Take>
    void deliver(std::deque<Travelling>& way, Take take) {
        for (; !way.empty() && way.front().arrives_s <= now_s_; way.pop_front()) {
            take(way.front().bytes);
        }
    }
    // Another value may only be written once the one before is over.
    void noteWrite(const Request& question) {
        const auto* set = std::get_if<ParameterSet>(&question);
        if (!set) return;
        for (const auto& [ticket, progress] : results) {
            const auto* other = std::get_if<ParameterSet>(&progress.wish);
            const bool open = progress.state == RequestState::kAsked ||
                              progress.state == RequestState::kReadingBack;
            if (open && other && other->id == set->id && other->value != set->value) {
                ++two_writes_at_once;
            }
        }
    }

    double loss_;
    double longest_delay_s_;
    Random random_;
    double now_s_ = 0.0;
    std::uint16_t sequence_ = 0;
    SimulatedRobot robot_{spokenVehicle(), {}};
    FrameDecoder decoder_;
    std::deque<Travelling> there_;
    std::deque<Travelling> back_;
};

TEST(Requests, AParameterIsReadWrittenAndReadBack) {
    FarRobot far(0.0, 0.05, 1);
    far.requests.ask(1, ParameterSet{kGain, 123});
    far.requests.ask(2, ParameterGet{kGain});
    far.run(2.0);
    EXPECT_EQ(far.results[1].state, RequestState::kDone);
    EXPECT_EQ(far.results[1].tries, 2) << "written once, read back once";
    EXPECT_EQ(far.results[2].state, RequestState::kDone);
    EXPECT_EQ(far.results[2].value, 123);
}

TEST(Requests, TheRobotsRefusalIsShownWithItsReason) {
    FarRobot far(0.0, 0.05, 1);
    far.requests.ask(1, ParameterSet{kDirections, 5});
    far.requests.ask(2, ParameterGet{99});
    far.requests.ask(3, ParameterGet{kDirections});
    far.run(2.0);
    EXPECT_EQ(far.results[1].state, RequestState::kRefused);
    EXPECT_EQ(far.results[1].reason, AcknowledgeResult::kOutOfRange);
    EXPECT_EQ(far.results[2].reason, AcknowledgeResult::kUnknownParameter);
    EXPECT_EQ(far.results[3].value, 4);
}

// Every one of many writes to the same parameter and commands comes through, in their order, and
// what is said of it is true.
TEST(Requests, WorkAtTwentyPercentLossAndTwoSecondsOfDelay) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        for (const double delay_s : {0.05, 1.0}) {
            FarRobot far(0.2, delay_s, seed);
            for (std::uint64_t i = 0; i < 5; ++i) {
                far.requests.ask(2 * i, ParameterSet{kGain, static_cast<std::int32_t>(i)});
                far.requests.ask(2 * i + 1, RobotCommand{.kind = CommandKind::kHedrOff});
            }
            far.run(120.0);
            for (std::uint64_t ticket = 0; ticket < 10; ++ticket) {
                EXPECT_EQ(far.results[ticket].state, RequestState::kDone)
                    << "seed " << seed << " delay " << delay_s << " ticket " << ticket;
            }
            EXPECT_EQ(far.two_writes_at_once, 0);
        }
    }
}

TEST(Requests, GiveUpOnARobotThatIsSilentAndGoOnWithTheNext) {
    FarRobot far(1.0, 0.0, 1);
    far.requests.ask(1, ParameterGet{kGain});
    far.requests.ask(2, ParameterGet{kDirections});
    far.run(1.0);
    EXPECT_EQ(far.results[1].state, RequestState::kAsked);
    EXPECT_EQ(far.results[2].state, RequestState::kWaiting);
    far.run(7.5);
    EXPECT_EQ(far.results[1].state, RequestState::kNoAnswer);
    EXPECT_EQ(far.results[1].tries, 20);
    EXPECT_EQ(far.results[2].state, RequestState::kAsked);
}

TEST(Requests, CanBeCanceled) {
    FarRobot far(1.0, 0.0, 1);
    far.requests.ask(1, ParameterSet{kGain, 1});
    far.requests.ask(2, ParameterSet{kGain, 2});
    far.run(1.0);
    far.requests.cancel(1);
    far.run(0.1);
    EXPECT_EQ(far.results[1].state, RequestState::kCanceled);
    EXPECT_EQ(far.results[2].state, RequestState::kWaiting) << "a late answer may still come";
    far.run(Requests::kLinger_s);
    EXPECT_EQ(far.results[2].state, RequestState::kAsked);
}

TEST(Requests, AValueThatIsNotWhatWasWrittenIsSaidAfterSeveralAnswersOnly) {
    Requests requests;
    requests.ask(1, ParameterSet{kGain, 7});
    requests.due(0.0);
    requests.hear(ParameterReport{kGain, 5});
    EXPECT_EQ(requests.takeNews().back().state, RequestState::kAsked) << "perhaps a late answer";
    for (int i = 0; i < 2; ++i) requests.hear(ParameterReport{kGain, 5});
    EXPECT_EQ(requests.takeNews().back().state, RequestState::kReadingBack);
    for (int i = 0; i < Requests::kSureAfter; ++i) requests.hear(ParameterReport{kGain, 5});
    const auto news = requests.takeNews();
    ASSERT_EQ(news.size(), 1U);
    EXPECT_EQ(news[0].state, RequestState::kDiffers);
    EXPECT_EQ(news[0].value, 5);
}

TEST(Requests, ACommandWaitsForTheOneBefore) {
    Requests requests;
    requests.ask(1, RobotCommand{.kind = CommandKind::kHedrOn});
    requests.ask(2, RobotCommand{.kind = CommandKind::kHedrOff});
    const auto on = [](const std::vector<Request>& due) {
        return due.size() == 1 && std::get<RobotCommand>(due[0]).kind == CommandKind::kHedrOn;
    };
    EXPECT_TRUE(on(requests.due(0.0)));
    EXPECT_TRUE(on(requests.due(0.5))) << "its answer was lost; off must not be overtaken by it";
    const auto on_id = static_cast<std::uint8_t>(CommandKind::kHedrOn);
    requests.hear(AcknowledgeReport{on_id, static_cast<std::uint8_t>(AcknowledgeResult::kDone)});
    const auto off = requests.due(0.6);
    ASSERT_EQ(off.size(), 1U);
    EXPECT_EQ(std::get<RobotCommand>(off[0]).kind, CommandKind::kHedrOff);
}

TEST(Requests, ALateRefusalOfWhatWasCanceledIsNotTakenForAnothers) {
    Requests requests;
    requests.ask(1, ParameterSet{kDirections, 5});
    requests.due(0.0);
    requests.cancel(1);
    requests.ask(2, ParameterGet{kGain});
    EXPECT_TRUE(requests.due(0.1).empty());
    requests.hear(
        AcknowledgeReport{0x82, static_cast<std::uint8_t>(AcknowledgeResult::kOutOfRange)});
    EXPECT_EQ(requests.due(Requests::kLinger_s + 0.1).size(), 1U);
    EXPECT_EQ(requests.takeNews().back().state, RequestState::kAsked);
}

}  // namespace
}  // namespace hedr
