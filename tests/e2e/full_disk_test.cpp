// A full disk costs nothing once there is room again.
#include <gtest/gtest.h>
#include <sys/mount.h>

#include <QTemporaryDir>
#include <fstream>

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
        ASSERT_EQ(::mount("tmpfs", mountPoint().c_str(), "tmpfs", MS_REMOUNT, "size=64m"), 0);
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

// Before the last bytes are gone, which others need too.
TEST_F(SmallDisk, StopsInGoodOrderBeforeItIsFullAndGoesOnWhenThereIsRoom) {
    enlarge();
    const std::filesystem::path file = mountPoint() + "/m.hedr";
    Recorder recorder(file, {.start = std::chrono::system_clock::now(), .program_version = "test"});
    const std::vector<std::uint8_t> some(1000, 0x55);
    recorder.addBytes(0.0, some);
    recorder.writeIfDue(0.0);
    ASSERT_FALSE(recorder.state().error);
    EXPECT_LT(*recorder.state().free_bytes, kLittleRoomBytes) << "which is a warning";

    const std::filesystem::path other = mountPoint() + "/film";
    std::ofstream(other) << std::string(60'000'000, 'x');
    recorder.addBytes(10.0, some);
    recorder.writeIfDue(10.0);
    ASSERT_TRUE(recorder.state().error);
    EXPECT_EQ(recorder.state().error->code, ErrorCode::kDiskFull);
    EXPECT_TRUE(MissionReader::open(file)->info()) << "what is there can be read";

    std::filesystem::remove(other);
    recorder.addBytes(20.0, some);
    recorder.writeIfDue(20.0);
    EXPECT_FALSE(recorder.state().error);
    std::size_t bytes = 0;
    ASSERT_TRUE(MissionReader::open(file)->forEachStreamRow([&](const StreamRow& row) {
        bytes += row.data.size();
        return true;
    }));
    EXPECT_EQ(bytes, 3 * some.size());
}

}  // namespace
}  // namespace hedr
