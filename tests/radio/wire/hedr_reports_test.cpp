#include "radio/wire/hedr_reports.h"

#include <gtest/gtest.h>

#include "radio/wire/codec.h"

namespace hedr {
namespace {

struct Ear {
    void hear(const Report& report, std::uint16_t sequence) {
        reports.feed(encodeReport(report, sequence).value().view(),
                     [this](const Report& heard) { said.push_back(heard); });
    }
    HedrReports reports;
    std::vector<Report> said;
};

HelloReport hello(int protocol = 1, std::uint32_t boot_id = 1) {
    HelloReport report;
    report.protocol = protocol;
    report.boot_id = boot_id;
    return report;
}

PoseReport poseAt(double time_s) {
    PoseReport pose;
    pose.robot_time_s = time_s;
    return pose;
}

TEST(HedrReports, ReadNothingButTheHelloOfAnotherProtocol) {
    Ear ear;
    ear.hear(hello(2), 0);
    ear.hear(poseAt(1.0), 1);
    ASSERT_EQ(ear.said.size(), 1U);
    EXPECT_EQ(std::get<HelloReport>(ear.said[0]).protocol, 2);
    EXPECT_EQ(ear.reports.counters().unknown_frames, 1U);
    ear.hear(hello(1, 2), 2);
    ear.hear(poseAt(2.0), 3);
    EXPECT_EQ(ear.said.size(), 3U) << "it was updated";
}

TEST(HedrReports, LeaveOutWhatWasOvertakenButNotAnAnswer) {
    Ear ear;
    ear.hear(poseAt(1.0), 1);
    ear.hear(poseAt(3.0), 3);
    ear.hear(poseAt(2.0), 2);
    ear.hear(poseAt(3.0), 3);
    ear.hear(poseAt(6.0), 6);
    ear.hear(ParameterReport{1, 7}, 5);
    EXPECT_EQ(ear.said.size(), 4U);
    EXPECT_EQ(ear.reports.counters().late_frames, 3U);
    EXPECT_EQ(ear.reports.counters().lost_frames, 1U);
}

TEST(HedrReports, TellARestartFromALoss) {
    Ear ear;
    ear.hear(hello(), 39'999);
    ear.hear(poseAt(1.0), 40'000);
    ear.hear(poseAt(0.0), 0);  // its first hello was lost
    ear.hear(hello(1, 2), 1);
    ear.hear(poseAt(0.1), 2);
    EXPECT_EQ(ear.reports.counters().lost_frames, 0U);
}

}  // namespace
}  // namespace hedr
