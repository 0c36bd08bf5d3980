#pragma once

#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>

#include "tests/e2e/program.h"

namespace hedr {

// The command line in a folder of its own.
class ToolFixture : public ::testing::Test {
  protected:
    QString path(const QString& name) const { return folder_.filePath(name); }

    void write(const QString& name, const QByteArray& text) const {
        QFile file(path(name));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
    }

    // One line, the program's name, the words; exit code 1.
    void expectFailure(const QStringList& arguments, const QStringList& words) const {
        const Outcome outcome = run(kHedrTool, arguments);
        const std::string said = outcome.err.toStdString();
        EXPECT_EQ(outcome.exit_code, 1) << said;
        EXPECT_EQ(outcome.err.count('\n'), 1) << said;
        EXPECT_TRUE(outcome.err.startsWith("hedr: ")) << said;
        for (const QString& word : words) EXPECT_TRUE(outcome.err.contains(word)) << said;
    }

    void expectWrongUsage(const QStringList& arguments, const QStringList& words) const {
        const Outcome outcome = run(kHedrTool, arguments);
        EXPECT_EQ(outcome.exit_code, 2) << outcome.err.toStdString();
        for (const QString& word : words) {
            EXPECT_TRUE(outcome.err.contains(word)) << outcome.err.toStdString();
        }
    }

    static constexpr const char* kGoodVehicle =
        "name = \"v\"\nleft_wheel_diameter_m = 0.2\nright_wheel_diameter_m = 0.2\n"
        "wheelbase_m = 0.4\nticks_per_revolution = 1000\n";

    QTemporaryDir folder_;
};

}  // namespace hedr
