#include "ui/error_text.h"

#include <gtest/gtest.h>

namespace hedr {
namespace {

constexpr int kLastCode = static_cast<int>(ErrorCode::kCanceled);

TEST(ErrorText, HasWordsAndAdviceForEveryCode) {
    for (int code = 0; code <= kLastCode; ++code) {
        const QString text = errorText({static_cast<ErrorCode>(code), "the/subject", "why"});
        EXPECT_TRUE(text.contains("the/subject")) << code;
        EXPECT_TRUE(text.contains(": why. ")) << code << text.toStdString();
        EXPECT_GT(text.section(": why. ", 1).size(), 15) << "no advice for code " << code;
        EXPECT_TRUE(text.endsWith('.')) << text.toStdString();
    }
}

TEST(ErrorText, TellsHowToGetAtAPortWithoutPermission) {
    EXPECT_EQ(errorText({ErrorCode::kPortPermission, "/dev/ttyUSB0", ""}),
              "Your user may not open /dev/ttyUSB0. Add it to the dialout group: sudo usermod -aG "
              "dialout $USER, then log in again.");
}

TEST(ErrorText, TellsHowToFreeAPortThatAModemServiceHolds) {
    EXPECT_EQ(errorText({ErrorCode::kPortBusy, "/dev/ttyUSB0",
                         "ModemManager (pid 812) has it open; to stop it: sudo systemctl stop "
                         "ModemManager"}),
              "Another program is using /dev/ttyUSB0: ModemManager (pid 812) has it open; to stop "
              "it: sudo systemctl stop ModemManager. Close it, then connect again. The udev rule "
              "70-hedr.rules keeps modem services away for good.");
}

TEST(ErrorText, NamesTheFileInALineToCopy) {
    const QString text = errorText({ErrorCode::kKeyExposed, "/home/me/my keys/atlas.key", ""});
    EXPECT_TRUE(text.endsWith(": chmod go-rwx '/home/me/my keys/atlas.key'."))
        << text.toStdString();
}

TEST(ErrorText, HasALineToCopy) {
    const auto copied = [](ErrorCode code, const char* subject, const char* detail) {
        return lineToCopy(errorText({code, subject, detail}));
    };
    EXPECT_EQ(copied(ErrorCode::kPortPermission, "/dev/ttyUSB0", ""),
              "sudo usermod -aG dialout $USER");
    EXPECT_EQ(
        copied(ErrorCode::kPortBusy, "/dev/ttyUSB0", "hedr (pid 7) has it open; to end it: kill 7"),
        "kill 7");
    EXPECT_EQ(copied(ErrorCode::kKeyExposed, "/home/me/my keys/atlas.key", ""),
              "chmod go-rwx '/home/me/my keys/atlas.key'");
    EXPECT_EQ(copied(ErrorCode::kPortMissing, "/dev/ttyUSB0", ""), "");
}

TEST(ErrorText, NeverEndsTheDetailWithTwoFullStops) {
    const QString text = errorText({ErrorCode::kBadValue, "vehicle.toml:3", "it is negative. "});
    EXPECT_FALSE(text.contains("..")) << text.toStdString();
    EXPECT_TRUE(text.contains("it is negative. Correct")) << text.toStdString();
}

TEST(ErrorText, LeavesPercentSignsInTheSubjectAlone) {
    const QString text = errorText({ErrorCode::kFileMissing, "/tmp/100%1%2.png", ""});
    EXPECT_TRUE(text.contains("/tmp/100%1%2.png")) << text.toStdString();
}

TEST(ErrorText, ReadsWellWithoutASubject) {
    EXPECT_TRUE(errorText({ErrorCode::kCanceled, "", ""}).startsWith("It was canceled. "));
}

}  // namespace
}  // namespace hedr
