// hedr reproduce as scripts see it. The figures are tested in tests/core/reproduction.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>

#include <QByteArray>
#include <QProcess>
#include <QTemporaryDir>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/e2e/program.h"

namespace hedr {
namespace {

TEST(HedrReproduce, PrintsATableOfThePapersFiguresAndOurs) {
    const Outcome outcome = run(kHedrTool, {"reproduce", "gyrodometry"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err.toStdString();
    for (const char* word : {"figure", "paper", "ours", "agrees", "Fig. 4", "set to match", "NO"}) {
        EXPECT_TRUE(outcome.out.contains(word)) << word;
    }
    EXPECT_TRUE(outcome.err.isEmpty()) << outcome.err.toStdString();
}

TEST(HedrReproduce, GivesAReasonOnlyWhereOneIsDue) {
    const Outcome outcome = run(kHedrTool, {"reproduce", "gyrodometry"});
    EXPECT_TRUE(outcome.out.contains("9 mm bump: intervals by the gyro: "));
    EXPECT_FALSE(outcome.out.contains("held_share=0.3: largest outside transients: "));
}

TEST(HedrReproduce, HasUnitsAlsoWhereOursIsMissing) {
    const Outcome outcome = run(kHedrTool, {"reproduce", "gyro-error-model"});
    for (const char* figure : {"0.153 deg/s", "-0.264 deg/s", "5.64 min"}) {
        EXPECT_TRUE(outcome.out.contains(figure)) << figure;
    }
}

TEST(HedrReproduce, GivesOneJsonObject) {
    const Outcome outcome = run(kHedrTool, {"reproduce", "umbmark", "--json"});
    EXPECT_EQ(outcome.exit_code, 0);
    const auto object = nlohmann::json::parse(outcome.out.toStdString());
    EXPECT_EQ(object.at("paper"), "umbmark");
    EXPECT_EQ(object.at("seeds"), 20);
    ASSERT_FALSE(object.at("figures").empty());
    for (const auto& figure : object.at("figures")) {
        for (const char* key : {"name", "place", "paper", "ours", "unit", "agrees_within", "agrees",
                                "set_to_match", "note"}) {
            EXPECT_TRUE(figure.contains(key)) << key;
        }
    }
    EXPECT_FALSE(object.at("remarks").empty());
}

// Several seconds of work: who watches sees how far it has come, and no trace of it afterwards.
TEST(HedrReproduce, TellsATerminalHowFarItHasCome) {
    const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
    ASSERT_GE(terminal, 0);
    ASSERT_EQ(grantpt(terminal), 0);
    ASSERT_EQ(unlockpt(terminal), 0);
    QProcess process;
    process.setStandardErrorFile(QString::fromLocal8Bit(ptsname(terminal)));
    process.start(kHedrTool, {"reproduce", "hedr"});
    EXPECT_TRUE(process.waitForFinished(120000));
    QByteArray said(65536, '\0');
    said.resize(std::max<qsizetype>(0, read(terminal, said.data(), 65536)));
    close(terminal);
    EXPECT_TRUE(said.contains("\rrun ")) << said.toStdString();
    EXPECT_TRUE(said.endsWith("\r\x1b[K")) << said.toStdString();
}

TEST(HedrReproduce, OfAnUnknownPaperIsWrongUsage) {
    const Outcome outcome = run(kHedrTool, {"reproduce", "moon"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_TRUE(outcome.err.contains("gh-fusion")) << outcome.err.toStdString();
    EXPECT_EQ(run(kHedrTool, {"reproduce"}).exit_code, 2);
}

TEST(HedrSimulate, TakesTheKeysOfItsScenarioOnly) {
    const QTemporaryDir folder;
    const QString out = folder.filePath("romi");
    EXPECT_EQ(run(kHedrTool, {"simulate", "romi-rectangle", "--seed", "1", "--out", out, "--set",
                              "wheelbase_error_mm=4"})
                  .exit_code,
              0);
    // Wherever it stands on the line.
    const Outcome wrong = run(kHedrTool, {"simulate", "--set", "zigzag_deg=3", "--seed", "1",
                                          "--out", out, "romi-rectangle"});
    EXPECT_EQ(wrong.exit_code, 2);
    EXPECT_TRUE(wrong.err.contains("zigzag_deg") && wrong.err.contains("wheelbase_error_mm"))
        << wrong.err.toStdString();
}

}  // namespace
}  // namespace hedr
