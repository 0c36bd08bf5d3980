#pragma once

#include <QProcess>
#include <QString>
#include <QStringList>

namespace hedr {

inline const QString kHedrTool = QStringLiteral(HEDR_BINARY_DIR "/app/hedr");
inline const QString kHedrOcu = QStringLiteral(HEDR_BINARY_DIR "/app/hedr-ocu");

struct Outcome {
    int exit_code = -1;
    QString out;
    QString err;
};

// Runs a program to its end.
inline Outcome run(const QString& program, const QStringList& arguments) {
    QProcess process;
    process.start(program, arguments);
    if (!process.waitForFinished(120000)) process.kill();
    return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1,
            process.readAllStandardOutput(), process.readAllStandardError()};
}

}  // namespace hedr
