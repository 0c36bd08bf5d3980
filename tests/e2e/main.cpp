#include <gtest/gtest.h>

#include <QCoreApplication>

#include "radio/live_link.h"

int main(int argc, char** argv) {
    const QCoreApplication application(argc, argv);
    qRegisterMetaType<hedr::LiveBatch>();
    qRegisterMetaType<hedr::Error>();
    ::testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
