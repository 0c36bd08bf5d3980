// Keys on the command line: files for their owner only, and one line to mend what is exposed.
#include <gtest/gtest.h>

#include <QFileInfo>
#include <nlohmann/json.hpp>

#include "core/mission/mission_writer.h"
#include "radio/robot_key.h"
#include "tests/e2e/tool_fixture.h"
#include "tests/radio/spoken_drive.h"

namespace hedr {
namespace {

class HedrKey : public ToolFixture {
  protected:
    HedrKey() { qputenv("XDG_DATA_HOME", folder_.path().toUtf8()); }
    ~HedrKey() override { qunsetenv("XDG_DATA_HOME"); }

    QString keyFile(const QString& name) const { return path("hedr/keys/" + name + ".key"); }
};

TEST_F(HedrKey, MakesListsAndShows) {
    const Outcome made = run(kHedrTool, {"key", "make", "atlas"});
    EXPECT_EQ(made.exit_code, 0) << made.err.toStdString();
    EXPECT_EQ(made.out, keyFile("atlas") + '\n');
    EXPECT_EQ(QFileInfo(keyFile("atlas")).permissions() & 0x0FF, 0) << "of group and others";
    run(kHedrTool, {"key", "make", "Packbot 7"});
    EXPECT_EQ(run(kHedrTool, {"key", "list"}).out, "Packbot 7\natlas\n");
    const auto list =
        nlohmann::json::parse(run(kHedrTool, {"key", "list", "--json"}).out.toStdString());
    EXPECT_EQ(list.at("keys").at(1).at("name"), "atlas");
    const std::string hex = hexOf(loadKey(keyFile("atlas").toStdString()).value().key);
    EXPECT_EQ(run(kHedrTool, {"key", "show", "atlas"}).out.toStdString(), hex + '\n');
    EXPECT_EQ(run(kHedrTool, {"key", "show", keyFile("atlas")}).out.toStdString(), hex + '\n');
    const auto shown =
        nlohmann::json::parse(run(kHedrTool, {"key", "show", "atlas", "--json"}).out.toStdString());
    EXPECT_EQ(shown.at("key"), hex);
    EXPECT_TRUE(
        run(kHedrTool, {"key", "show", "atlas", "--format", "c"}).out.contains("HEDR_KEY {0x"));
}

TEST_F(HedrKey, ReplacesNoKey) {
    run(kHedrTool, {"key", "make", "atlas"});
    const QString before = run(kHedrTool, {"key", "show", "atlas"}).out;
    expectFailure({"key", "make", "atlas"}, {keyFile("atlas"), "already"});
    EXPECT_EQ(run(kHedrTool, {"key", "show", "atlas"}).out, before);
}

TEST_F(HedrKey, InstallsAHeaderForTheFirmware) {
    const QString elsewhere = path("stick.key");
    EXPECT_EQ(run(kHedrTool, {"key", "make", "atlas", "--out", elsewhere}).exit_code, 0);
    EXPECT_EQ(run(kHedrTool, {"key", "install", elsewhere, "--out", path("hedr_key.h")}).exit_code,
              0);
    QFile header(path("hedr_key.h"));
    ASSERT_TRUE(header.open(QIODevice::ReadOnly));
    EXPECT_TRUE(header.readAll().contains("#define HEDR_KEY {0x"));
    EXPECT_EQ(QFileInfo(header).permissions() & 0x0FF, 0);
    expectFailure({"key", "install", elsewhere, "--out", path("hedr_key.h")}, {"already"});
    expectFailure({"key", "install", elsewhere, "--out", path("nowhere/k.h")}, {"no folder"});
    expectFailure({"key", "make", "atlas", "--out", path("nowhere/atlas.key")}, {"no folder"});
    EXPECT_FALSE(QFile::exists(path("nowhere")));
}

TEST_F(HedrKey, RefusesAKeyThatOthersMayReadAndSaysTheLineThatMendsIt) {
    run(kHedrTool, {"key", "make", "atlas"});
    QFile::setPermissions(keyFile("atlas"), QFile::ReadOwner | QFile::ReadGroup);
    const QString remedy = "chmod go-rwx '" + keyFile("atlas") + "'";
    expectFailure({"key", "show", "atlas"}, {remedy});
    expectFailure({"key", "install", "atlas", "--out", path("hedr_key.h")}, {remedy});
    expectFailure({"key", "list"}, {remedy});
    EXPECT_FALSE(QFile::exists(path("hedr_key.h")));
}

TEST_F(HedrKey, IsForTheMissionsOfFuse) {
    const QStringList fuse{"fuse",        "m.hedr",    "--estimator", "hedr",  "--out",
                           path("o.csv"), "--vehicle", "labmate",     "--key", "atlas"};
    expectWrongUsage(fuse, {"--key", "is for a mission"});
    auto mission = MissionWriter::create(path("m.hedr").toStdString(), {});
    ASSERT_TRUE(mission && mission->writeBytes(0.0, spoken(straightDrive(5.0))) &&
                mission->commit());
    QStringList with_file = fuse;
    with_file[1] = path("m.hedr");
    expectFailure(with_file, {"atlas.key"});
    run(kHedrTool, {"key", "make", "atlas"});
    expectFailure(with_file, {"m.hedr"});
    EXPECT_FALSE(QFile::exists(path("o.csv")));
}

TEST_F(HedrKey, SaysWhatCannotBeDone) {
    expectFailure({"key", "show", "nobody"}, {"nobody.key"});
    write("bad.key", "name = \"a\"\nkey = \"12\"\n");
    QFile::setPermissions(path("bad.key"), QFile::ReadOwner);
    expectFailure({"key", "show", path("bad.key")}, {"32 hexadecimal digits"});
    expectWrongUsage({"key"}, {});
    expectWrongUsage({"key", "make"}, {"NAME"});
    expectWrongUsage({"key", "make", "a/b"}, {"must not hold"});
    expectWrongUsage({"key", "show", "atlas", "--format", "pem"}, {"hex, c"});
}

}  // namespace
}  // namespace hedr
