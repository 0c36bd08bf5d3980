#include "radio/source/port_holder.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QProcess>
#include <QTemporaryDir>
#include <fstream>

#include "radio/robot_line.h"
#include "tests/radio/source/source_listener.h"

namespace hedr {
namespace {

namespace fs = std::filesystem;

// A system of our own making. The device's name is all that counts.
class PortHolderInATree : public ::testing::Test {
  protected:
    void SetUp() override {
        fs::create_directories(places_.locks);
        fs::create_directories(places_.proc / "sys");
        std::ofstream(places_.proc / "uptime") << "1 1\n";
    }
    void add(int pid, const std::string& name, const std::vector<std::string>& files) {
        const fs::path fds = places_.proc / std::to_string(pid) / "fd";
        fs::create_directories(fds);
        std::ofstream(fds.parent_path() / "comm") << name << '\n';
        int number = 0;
        for (const std::string& file : files)
            fs::create_symlink(file, fds / std::to_string(number++));
    }
    // As the files of another user's program are. False for root, who may look into everything.
    bool hide(int pid) {
        const fs::path& fds = hidden_.emplace_back(places_.proc / std::to_string(pid) / "fd");
        ::chmod(fds.c_str(), 0);
        return ::access(fds.c_str(), R_OK) != 0;
    }
    void TearDown() override {
        for (const fs::path& fds : hidden_) ::chmod(fds.c_str(), S_IRWXU);
    }
    std::string said() const { return describe(findPortHolders(device_, places_), device_); }

    QTemporaryDir folder_;
    SystemPlaces places_{.proc = folder_.filePath("proc").toStdString(),
                         .locks = folder_.filePath("lock").toStdString()};
    fs::path device_ = "/dev/ttyUSB77";
    std::vector<fs::path> hidden_{};
};

TEST_F(PortHolderInATree, IsNobodyWhereNobodyHasItOpen) {
    add(1, "systemd", {"/dev/null", "socket:[4711]"});
    add(7, "minicom", {"/dev/ttyUSB7", "/dev/ttyUSB771"});
    EXPECT_EQ(said(), "");
}

TEST_F(PortHolderInATree, IsNamedWithTheLineThatEndsIt) {
    add(4711, "minicom", {"/dev/null", "/dev/ttyUSB77"});
    EXPECT_EQ(said(), "minicom (pid 4711) has it open; to end it: kill 4711");
}

TEST_F(PortHolderInATree, IsAServiceThatTheSystemStops) {
    add(812, "ModemManager", {"/dev/ttyUSB77"});
    EXPECT_EQ(said(),
              "ModemManager (pid 812) has it open; to stop it: sudo systemctl stop ModemManager");
}

TEST_F(PortHolderInATree, IsThisProgramItself) {
    add(::getpid(), "hedr-ocu", {"/dev/ttyUSB77"});
    EXPECT_EQ(said(), "this program has it open already");
}

TEST_F(PortHolderInATree, IsWhoHasLockedIt) {
    add(4711, "kermit", {"/dev/null"});
    std::ofstream(places_.locks / "LCK..ttyUSB77") << "      4711\n";
    EXPECT_EQ(said(), "kermit (pid 4711) has it open; to end it: kill 4711");
    std::ofstream(places_.locks / "LCK..ttyUSB77") << "      4712\n";
    EXPECT_EQ(said(), "") << "that one is gone";
    std::ofstream(places_.locks / "LCK..ttyUSB77") << "\xff garbage";
    EXPECT_EQ(said(), "");
}

TEST_F(PortHolderInATree, MayBeHiddenFromOurUser) {
    add(812, "ModemManager", {"/dev/ttyUSB77"});
    add(900, "dbus-daemon", {"/dev/null"});
    if (!hide(900) || !hide(812)) GTEST_SKIP() << "nothing is hidden from root";
    EXPECT_EQ(said(),
              "ModemManager (pid 812) is running and may have it open; to stop it: sudo systemctl "
              "stop ModemManager");
    std::ofstream(places_.proc / "812" / "comm") << "sshd\n";
    EXPECT_EQ(said(), "your user may not see which one; to see it: sudo fuser -v /dev/ttyUSB77");
}

TEST(PortHolder, SaysWhatMayBeKnownOfHiddenOnes) {
    const PortHolder service{.pid = 812, .name = "ModemManager"};
    EXPECT_EQ(describe({.service = service, .hidden = true}, "/dev/ttyUSB0"),
              "ModemManager (pid 812) is running and may have it open; to stop it: sudo systemctl "
              "stop ModemManager");
    EXPECT_EQ(describe({.hidden = true}, "/dev/ttyUSB0"),
              "your user may not see which one; to see it: sudo fuser -v /dev/ttyUSB0");
    EXPECT_EQ(describe({.holders = {{.pid = 7, .name = "cu"}}}, "/dev/ttyUSB0"),
              "cu (pid 7) has it open; to end it: sudo kill 7");
}

TEST(PortHolder, IsFoundInEarnestOnAPseudoTerminal) {
    const QTemporaryDir folder;
    const QString port = folder.filePath("robot");
    const auto line = RobotLine::openPseudoTerminal(port.toStdString());
    ASSERT_TRUE(line);
    EXPECT_TRUE(findPortHolders(port.toStdString()).holders.empty());
    QProcess program;
    program.setStandardInputFile(port);
    program.start("sleep", {"30"});
    ASSERT_TRUE(program.waitForStarted());
    const auto pid = static_cast<int>(program.processId());
    ASSERT_TRUE(soon([&] { return !findPortHolders(port.toStdString()).holders.empty(); }));
    EXPECT_EQ(findPortHolders(port.toStdString()).holders,
              (std::vector<PortHolder>{{.pid = pid, .name = "sleep", .ours = true}}));
    program.kill();
    program.waitForFinished();
    EXPECT_TRUE(findPortHolders(port.toStdString()).holders.empty());
}

}  // namespace
}  // namespace hedr
