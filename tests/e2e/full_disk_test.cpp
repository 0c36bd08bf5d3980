// A full disk costs nothing once there is room again.
#include <gtest/gtest.h>
#include <sys/mount.h>

#include <QTemporaryDir>

#include "core/mission/mission_reader.h"
#include "radio/recorder.h"

namespace hedr {
namespace {

class SmallDisk : public ::testing::Test {
  protected:
    void SetUp() override {
        if (::mount("tmpfs", mountPoint().c_str(), "tmpfs", 0, "size=256k") != 0) {
            GTEST_SKIP() << "mounting a small disk needs more rights than this test has";
        }
        mounted_ = true;
    }
    void TearDown() override {
        if (mounted_) ::umount(mountPoint().c_str());
    }
    void enlarge() {
        ASSERT_EQ(::mount("tmpfs", mountPoint().c_str(), "tmpfs", MS_REMOUNT, "size=16m"), 0);
    }
    std::string mountPoint() const { return folder_.path().toStdString(); }

    QTemporaryDir folder_;
    bool mounted_ = false;
};

TEST_F(SmallDisk, LosesNothing) {
    const std::filesystem::path file = mountPoint() + "/m.hedr";
    Recorder recorder(file, {.start = std::chrono::system_clock::now(), .program_version = "test"});
    const std::vector<std::uint8_t> second(3400, 0x55);
    double time_s = 0.0;
    for (; time_s < 200.0; time_s += 1.0) {
        recorder.addBytes(time_s, second);
        recorder.writeIfDue(time_s);
    }
    ASSERT_TRUE(recorder.state().error);
    EXPECT_EQ(recorder.state().error->code, ErrorCode::kDiskFull);

    enlarge();
    recorder.addBytes(time_s, second);
    recorder.write();
    EXPECT_FALSE(recorder.state().error);
    std::size_t bytes = 0;
    const auto reader = MissionReader::open(file);
    ASSERT_TRUE(reader);
    ASSERT_TRUE(reader->forEachStreamRow([&](const StreamRow& row) {
        bytes += row.data.size();
        return true;
    }));
    EXPECT_EQ(bytes, 201u * second.size());
}

}  // namespace
}  // namespace hedr
