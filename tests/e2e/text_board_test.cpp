// An Arduino on a pseudo-terminal: it starts anew when its port is opened, and prints once what its
// columns mean.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <termios.h>
#include <unistd.h>

#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QtTest/QTest>
#include <atomic>
#include <string>
#include <thread>

#include "core/mission/mission_reader.h"
#include "radio/live_link.h"

namespace hedr {
namespace {

class TextBoard {
  public:
    explicit TextBoard(speed_t speed) : speed_(speed) {
        char name[128] = {};
        int terminal = -1;
        if (::openpty(&master_, &terminal, name, nullptr, nullptr) != 0) return;
        ::close(terminal);  // from now on the master says whether somebody has it open
        ::fcntl(master_, F_SETFL, O_NONBLOCK);
        port_ = name;
        thread_ = std::thread([this] { run(); });
    }
    ~TextBoard() {
        ended_ = true;
        if (thread_.joinable()) thread_.join();
        ::close(master_);
    }
    TextBoard(const TextBoard&) = delete;
    TextBoard& operator=(const TextBoard&) = delete;

    const std::string& port() const { return port_; }
    int starts() const { return starts_; }

  private:
    static constexpr int kPeriod_ms = 20;
    static constexpr int kBoot_ms = 300;

    void run() {
        int since_start_ms = -1;  // it is not powered
        for (; !ended_; std::this_thread::sleep_for(std::chrono::milliseconds(kPeriod_ms))) {
            pollfd port{master_, POLLIN, 0};
            ::poll(&port, 1, 0);
            if ((port.revents & POLLHUP) != 0) {
                since_start_ms = -1;
                continue;
            }
            if (since_start_ms < 0) ++starts_;
            since_start_ms += kPeriod_ms;
            if (since_start_ms < kBoot_ms) continue;
            if (since_start_ms < kBoot_ms + kPeriod_ms) print("t_ms,left_ticks,right_ticks\r\n");
            const std::string t = std::to_string(since_start_ms);
            print(t + ',' + t + ',' + t + "\r\n");
        }
    }

    // At another rate than its own it is not readable.
    void print(std::string text) {
        termios settings{};
        ::tcgetattr(master_, &settings);
        if (::cfgetospeed(&settings) != speed_) {
            for (char& c : text) c = static_cast<char>(0x80 | c);
        }
        (void)!::write(master_, text.data(), text.size());
    }

    speed_t speed_;
    int master_ = -1;
    std::string port_;
    std::atomic<bool> ended_ = false;
    std::atomic<int> starts_ = 0;
    std::thread thread_;
};

TEST(TextBoard, IsRecognisedAtAnyRateThoughItNamesItsColumnsOnce) {
    const QTemporaryDir folder;
    const TextBoard board(B115200);
    ASSERT_FALSE(board.port().empty());
    LiveLink link({.mission = folder.filePath("m.hedr").toStdString(),
                   .header = {.start = std::chrono::system_clock::now()}});
    LiveBatch last;
    QObject::connect(&link, &LiveLink::batchReady, [&](const LiveBatch& batch) { last = batch; });
    QElapsedTimer timer;
    timer.start();
    link.open(SerialAddress{QString::fromStdString(board.port())});
    EXPECT_TRUE(QTest::qWaitFor([&] { return last.robot.has_value(); }, 10000)) << last.refusal;
    EXPECT_LT(timer.elapsed(), 5000);
    EXPECT_EQ(last.language, RobotLanguage::kText);
    EXPECT_EQ(std::get<SerialAddress>(last.address).baud, 115200);
    EXPECT_EQ(board.starts(), 2) << "once to find the rate, once to hear the names";
    EXPECT_EQ(last.link.reconnects, 1U);
}

TEST(TextBoard, IsNotStartedAgainWhereItWasHeard) {
    const QTemporaryDir folder;
    const TextBoard board(B57600);
    LiveLink link({.vehicle = Vehicle{},
                   .mission = folder.filePath("m.hedr").toStdString(),
                   .header = {.start = std::chrono::system_clock::now()}});
    LiveBatch last;
    QObject::connect(&link, &LiveLink::batchReady, [&](const LiveBatch& batch) { last = batch; });
    link.open(SerialAddress{QString::fromStdString(board.port())});
    ASSERT_TRUE(QTest::qWaitFor([&] { return last.robot.has_value(); }, 10000));
    QTest::qWait(1500);
    EXPECT_EQ(board.starts(), 1) << "its names were heard";
}

}  // namespace
}  // namespace hedr
