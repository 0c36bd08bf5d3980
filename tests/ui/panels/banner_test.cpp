#include "ui/panels/banner.h"

#include <gtest/gtest.h>

#include <QClipboard>
#include <QGuiApplication>
#include <QTest>

namespace hedr {
namespace {

// One that must be acknowledged, in a window.
class BannerToRead : public testing::Test {
  protected:
    BannerToRead() {
        banner_.setAcknowledgeable(true);
        window_.resize(800, 200);
        window_.show();
    }
    void read() {
        ASSERT_TRUE(QTest::qWaitFor([this] { return button().isEnabled(); }, 20000));
        button().click();
    }
    QPushButton& button() const { return *banner_.findChild<QPushButton*>(); }

    QWidget window_;
    Banner banner_{&window_};
};

TEST_F(BannerToRead, ShowsOneAfterTheOther) {
    banner_.add("first", BannerTone::kAlarm);
    EXPECT_EQ(button().text(), "OK");
    banner_.add("second", BannerTone::kAlarm);
    banner_.add("third", BannerTone::kAlarm);
    EXPECT_EQ(banner_.text(), "first");
    EXPECT_EQ(button().text(), "Next (2)");
    read();
    EXPECT_EQ(banner_.text(), "second");
    read();
    EXPECT_EQ(banner_.text(), "third");
    EXPECT_EQ(button().text(), "OK");
    EXPECT_TRUE(banner_.isVisible());
    read();
    EXPECT_FALSE(banner_.isVisible());
}

TEST_F(BannerToRead, IsNotAcknowledgedByTheSecondHalfOfADoubleClick) {
    banner_.add("first", BannerTone::kAlarm);
    banner_.add("second", BannerTone::kAlarm);
    button().click();
    button().click();
    EXPECT_EQ(banner_.text(), "second");
}

TEST_F(BannerToRead, SaysNothingTwiceThatHasNotBeenRead) {
    for (int i = 0; i < 3; ++i) {
        banner_.add("first", BannerTone::kAlarm);
        banner_.add("second", BannerTone::kWarning);
    }
    EXPECT_EQ(button().text(), "Next (1)");
    read();
    read();
    EXPECT_FALSE(banner_.isVisible());
    banner_.add("first", BannerTone::kAlarm);
    EXPECT_TRUE(banner_.isVisible());
}

TEST_F(BannerToRead, LetsAlarmsGoFirst) {
    banner_.add("warning", BannerTone::kWarning);
    banner_.add("another warning", BannerTone::kWarning);
    banner_.add("alarm", BannerTone::kAlarm);
    banner_.add("another alarm", BannerTone::kAlarm);
    for (const char* text : {"alarm", "another alarm", "warning", "another warning"}) {
        EXPECT_EQ(banner_.text(), text);
        read();
    }
    EXPECT_FALSE(banner_.isVisible());
}

TEST(Banner, CopiesTheLineToType) {
    Banner banner;
    banner.setTheme(nightTheme());
    banner.resize(760, 90);
    const auto buttons = banner.findChildren<QPushButton*>();
    ASSERT_EQ(buttons.size(), 2);
    QPushButton* const copy = buttons[1];
    banner.setText("There is no port /dev/ttyUSB0. Plug it in.", BannerTone::kAlarm);
    EXPECT_TRUE(copy->isHidden());
    banner.setText("It is in use: to end it: kill 812. Close it.", BannerTone::kAlarm);
    EXPECT_FALSE(copy->isHidden());
    EXPECT_EQ(copy->toolTip(), "kill 812");
    copy->click();
    EXPECT_EQ(QGuiApplication::clipboard()->text(), "kill 812");
    EXPECT_EQ(copy->text(), "Copied");
}

}  // namespace
}  // namespace hedr
