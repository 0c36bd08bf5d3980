#include <gtest/gtest.h>

#include <QApplication>
#include <QStandardPaths>
#include <cstdio>

namespace {

// Any warning of Qt's fails the test in which it comes.
void failOnWarning(QtMsgType type, const QMessageLogContext&, const QString& message) {
    if (type == QtDebugMsg || type == QtInfoMsg) {
        std::fprintf(stderr, "%s\n", qPrintable(message));
        return;
    }
    // Of every message box, on a platform without a screen.
    if (message == QLatin1String("This plugin does not support propagateSizeHints()")) return;
    ADD_FAILURE() << "Qt says: " << message.toStdString();
}

}  // namespace

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication app(argc, argv);
    QStandardPaths::setTestModeEnabled(true);
    qInstallMessageHandler(failOnWarning);
    return RUN_ALL_TESTS();
}
