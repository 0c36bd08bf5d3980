#include <gtest/gtest.h>

#include <QApplication>
#include <QTemporaryDir>

#include "radio/live_link.h"

// Settings and data are the tests' own, also of the programs that they start.
int main(int argc, char** argv) {
    const QTemporaryDir home;
    qputenv("XDG_CONFIG_HOME", home.filePath("config").toLocal8Bit());
    qputenv("XDG_DATA_HOME", home.filePath("data").toLocal8Bit());
    const QApplication application(argc, argv);
    qRegisterMetaType<hedr::LiveBatch>();
    qRegisterMetaType<hedr::Error>();
    ::testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
