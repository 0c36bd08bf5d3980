#include <gtest/gtest.h>

#include <QApplication>
#include <QTemporaryDir>

// Settings and data are each process's own: tests run side by side.
int main(int argc, char** argv) {
    const QTemporaryDir home;
    qputenv("XDG_CONFIG_HOME", home.filePath("config").toLocal8Bit());
    qputenv("XDG_DATA_HOME", home.filePath("data").toLocal8Bit());
    const QApplication application(argc, argv);
    QApplication::setOrganizationName("hedr");
    QApplication::setApplicationName("hedr-tests");
    ::testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
