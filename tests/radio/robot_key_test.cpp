#include "radio/robot_key.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>

#include "core/text/text_file.h"

namespace hedr {
namespace {

namespace fs = std::filesystem;

class RobotKeyFile : public ::testing::Test {
  protected:
    RobotKeyFile() {
        std::string name = (fs::temp_directory_path() / "hedr_keys_XXXXXX").string();
        folder_ = mkdtemp(name.data());
    }
    ~RobotKeyFile() override { fs::remove_all(folder_); }

    fs::path madeKey(const std::string& name) const {
        const fs::path file = keyFileOf(folder_, name);
        EXPECT_TRUE(writeSecretFile(file, keyText(newKey(name))));
        return file;
    }
    static void allow(const fs::path& file, mode_t mode) {
        ASSERT_EQ(chmod(file.c_str(), mode), 0);
    }
    static mode_t modeOf(const fs::path& file) {
        struct stat status {};
        EXPECT_EQ(stat(file.c_str(), &status), 0);
        return status.st_mode & 0777U;
    }
    static std::optional<ErrorCode> refusal(const fs::path& file) {
        const auto key = loadKey(file);
        return key ? std::nullopt : std::optional(key.error().code);
    }

    fs::path folder_;
};

TEST_F(RobotKeyFile, IsForItsOwnerOnlyWhateverTheMaskSays) {
    const mode_t before = umask(0);
    const fs::path file = keyFileOf(folder_ / "new" / "keys", "atlas");
    const RobotKey key = newKey("atlas");
    EXPECT_TRUE(writeSecretFile(file, keyText(key)));
    umask(before);
    EXPECT_EQ(modeOf(file), 0600U);
    EXPECT_EQ(modeOf(file.parent_path()), 0700U);
    EXPECT_EQ(loadKey(file).value(), key);
    EXPECT_NE(newKey("atlas"), key);
}

TEST_F(RobotKeyFile, IsNeverReplaced) {
    const fs::path file = madeKey("atlas");
    const RobotKey key = loadKey(file).value();
    const auto again = writeSecretFile(file, keyText(newKey("atlas")));
    ASSERT_FALSE(again);
    EXPECT_EQ(again.error().code, ErrorCode::kFileExists);
    EXPECT_EQ(loadKey(file).value(), key);
}

TEST_F(RobotKeyFile, IsRefusedWhereOthersMayReadIt) {
    const fs::path file = madeKey("atlas");
    for (const mode_t mode : {0640U, 0604U, 0620U, 0602U, 0610U, 0666U}) {
        allow(file, mode);
        EXPECT_EQ(refusal(file), ErrorCode::kKeyExposed) << std::oct << mode;
    }
    allow(file, 0400);
    EXPECT_EQ(refusal(file), std::nullopt);
}

TEST_F(RobotKeyFile, IsRefusedWhereOthersMayReplaceIt) {
    const fs::path file = madeKey("atlas");
    allow(folder_, 0777);
    EXPECT_EQ(refusal(file), ErrorCode::kKeyExposed);
    allow(folder_, 01777);
    EXPECT_EQ(refusal(file), std::nullopt) << "as in /tmp";
    allow(folder_, 0755);
    EXPECT_EQ(refusal(file), std::nullopt);
}

TEST_F(RobotKeyFile, IsRefusedWhereItIsNoSuchFile) {
    EXPECT_EQ(refusal(folder_ / "none.key"), ErrorCode::kFileMissing);
    EXPECT_EQ(refusal(folder_), ErrorCode::kFileUnreadable);
    const fs::path pipe = folder_ / "pipe.key";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_EQ(refusal(pipe), ErrorCode::kFileUnreadable);
    ASSERT_TRUE(writeSecretFile(folder_ / "large.key", std::string(4097, '#')));
    EXPECT_EQ(refusal(folder_ / "large.key"), ErrorCode::kFileTooLarge);
    ASSERT_TRUE(writeSecretFile(folder_ / "bad.key", std::string("name = \"a\"\0\n", 12)));
    EXPECT_EQ(refusal(folder_ / "bad.key"), ErrorCode::kBadFormat);
}

TEST_F(RobotKeyFile, IsFoundWithTheOthersByNameAndABadOneIsTold) {
    madeKey("boris");
    madeKey("atlas");
    allow(madeKey("open"), 0644);
    std::ofstream(folder_ / "notes.txt") << "no key";
    const StoredKeys stored = loadKeys(folder_);
    ASSERT_EQ(stored.keys.size(), 2U);
    EXPECT_EQ(stored.keys[0].key.name, "atlas");
    EXPECT_EQ(stored.keys[1].key.name, "boris");
    ASSERT_EQ(stored.refused.size(), 1U);
    EXPECT_EQ(stored.refused[0].code, ErrorCode::kKeyExposed);
    EXPECT_EQ(stored.refused_names, std::vector<std::string>({"open"}));
    EXPECT_TRUE(loadKeys(folder_ / "none").keys.empty());
}

TEST_F(RobotKeyFile, KeepsItsCountersBesideIt) {
    const fs::path file = madeKey("atlas");
    EXPECT_EQ(loadCounters(file).value(), KeyCounters{});
    for (std::uint32_t i = 1; i < 4; ++i) {
        ASSERT_TRUE(saveCounters(file, {i, 10 * i}));
        EXPECT_EQ(loadCounters(file).value(), (KeyCounters{i, 10 * i}));
    }
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 2) << "no draft is left";
    std::ofstream(folder_ / "atlas.counters") << "said = 3\n";
    EXPECT_FALSE(loadCounters(file)) << "damaged counters are not zeros";
}

TEST_F(RobotKeyFile, SaysWhenItsCountersCannotBeKept) {
    const auto saved = saveCounters(folder_ / "none" / "atlas.key", {1, 1});
    ASSERT_FALSE(saved);
    EXPECT_EQ(saved.error().code, ErrorCode::kFileUnwritable);
}

TEST(RobotKeyCounter, BeginsBehindTheClockAndAllThatWasSaid) {
    using std::chrono::sys_days;
    const sys_days day{std::chrono::year{2020} / 1 / 2};
    EXPECT_EQ(saidAtStart({}, day), 4U * 86400U);
    EXPECT_EQ(saidAtStart({.said = 400000}, day), 400000U);
    EXPECT_EQ(saidAtStart({.said = 7}, sys_days{std::chrono::year{1999} / 1 / 1}), 7U);
    EXPECT_EQ(saidAtStart({}, sys_days{std::chrono::year{2200} / 1 / 1}), UINT32_MAX - 3);
}

}  // namespace
}  // namespace hedr
