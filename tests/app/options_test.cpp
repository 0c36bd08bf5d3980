#include "app/options.h"

#include <gtest/gtest.h>

namespace hedr {
namespace {

int exitCodeOf(const QStringList& arguments) {
    const auto options = parseOptions(QStringList{"hedr-ocu"} + arguments);
    return options ? -1 : options.error().exit_code;
}

TEST(Options, TakePortPlanAndMission) {
    const auto options = parseOptions({"hedr-ocu", "--port", "/dev/ttyUSB0:115200", "--plan",
                                       "plan.toml", "--out", "m.hedr", "--exit-after", "2.5"});
    ASSERT_TRUE(options);
    EXPECT_EQ(options->ports, QStringList{"/dev/ttyUSB0:115200"});
    EXPECT_EQ(options->plan, "plan.toml");
    EXPECT_EQ(options->mission, "m.hedr");
    EXPECT_EQ(options->exit_after_s, 2.5);
}

TEST(Options, TakeAnyNumberOfTargetsToPublishTo) {
    const auto options = parseOptions({"hedr-ocu", "--publish", "cot=udp://239.2.3.1:6969",
                                       "--publish", "json", "--publish", "nmea=tcp://:2000"});
    ASSERT_TRUE(options);
    const std::vector<PublishTarget> wanted{
        {PublishKind::kCot, QStringLiteral("239.2.3.1"), 6969},
        defaultTarget(PublishKind::kJson),
        {PublishKind::kNmea, QStringLiteral("127.0.0.1"), 2000}};
    EXPECT_EQ(options->publish, wanted);
    EXPECT_TRUE(parseOptions({"hedr-ocu"})->publish.empty()) << "it is off unless asked for";
}

TEST(Options, SayWhatIsWrongWithATarget) {
    const auto options = parseOptions({"hedr-ocu", "--publish", "nmea=tcp://192.168.1.5:2000"});
    ASSERT_FALSE(options);
    EXPECT_TRUE(options.error().text.startsWith(
        "--publish nmea=tcp://192.168.1.5:2000 waits for clients by TCP: tcp://:PORT for those on "
        "this computer, tcp://@ADDRESS:PORT for those who reach that address of it.\n"))
        << options.error().text.toStdString();
}

TEST(Options, WrongUsageEndsWithTwo) {
    EXPECT_EQ(exitCodeOf({"--no-such-option"}), 2);
    EXPECT_EQ(exitCodeOf({"--exit-after", "soon"}), 2);
    EXPECT_EQ(exitCodeOf({"--demo", "--port", "/dev/ttyS0"}), 2);
    EXPECT_EQ(exitCodeOf({"--port", "tcp://localhost"}), 2);
    EXPECT_EQ(exitCodeOf({"--port", "udp://:1", "--port", "tcp://localhost"}), 2);
    EXPECT_EQ(exitCodeOf({"--port", "udp://:1", "--port", "udp://:1"}), 2);
    EXPECT_EQ(exitCodeOf({"--publish", ""}), 2);
    EXPECT_EQ(exitCodeOf({"--publish", "kml=tcp://:2000"}), 2);
    EXPECT_EQ(exitCodeOf({"surplus"}), 2);
}

TEST(Options, HelpAndVersionEndWithZero) {
    EXPECT_EQ(exitCodeOf({"--help"}), 0);
    EXPECT_EQ(exitCodeOf({"--help-all"}), 0);
    EXPECT_EQ(exitCodeOf({"--version"}), 0);
}

}  // namespace
}  // namespace hedr
