#include "ui/site/page_card.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>

namespace hedr {
namespace {

TEST(PaperScale, IsReadAsPeopleWriteIt) {
    EXPECT_EQ(paperScaleOf("1 : 100"), 100.0);
    EXPECT_EQ(paperScaleOf("1:50"), 50.0);
    EXPECT_EQ(paperScaleOf(" 1/200 "), 200.0);
    EXPECT_EQ(paperScaleOf("62,5"), 62.5);
    for (const char* text : {"", "1 :", "a", "0", "1:-5", "1:100:2", "nan", "1e400", "9999999"}) {
        EXPECT_FALSE(paperScaleOf(text)) << text;
    }
}

class PagesOfAFile : public testing::Test {
  protected:
    PagesOfAFile() {
        card.setFile("/plans/floors.pdf", {"A3", "A3", "A4"});
        card.show();
        window.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&window));
        card.focusFirst();
    }
    QListWidget* pages() const { return card.findChild<QListWidget*>(); }
    QLineEdit* scale() const { return card.findChild<QLineEdit*>("paper_scale"); }
    PlanFileWish chosen() const { return spy.at(0).at(0).value<PlanFileWish>(); }

    QWidget window;
    PageCard card{&window};
    QSignalSpy spy{&card, &PageCard::chosen};
};

TEST_F(PagesOfAFile, IsChosenByArrowsAndEnter) {
    QTest::keyClick(pages(), Qt::Key_Right);
    QTest::keyClick(pages(), Qt::Key_Return);
    ASSERT_EQ(spy.count(), 1);
    EXPECT_EQ(chosen(), (PlanFileWish{.file = "/plans/floors.pdf", .choice = {.page = 2}}));
}

TEST_F(PagesOfAFile, GoesWithTheScaleOfItsPaper) {
    pages()->setCurrentRow(2);
    QTest::keyClicks(scale(), "1 : 250");
    QTest::keyClick(scale(), Qt::Key_Return);
    ASSERT_EQ(spy.count(), 1);
    EXPECT_EQ(chosen().choice.page, 3);
    EXPECT_EQ(chosen().choice.paper_scale, 250.0);
}

TEST_F(PagesOfAFile, DoesNotOpenWithAScaleThatIsNone) {
    QTest::keyClicks(scale(), "1 : x");
    QTest::keyClick(scale(), Qt::Key_Return);
    EXPECT_EQ(spy.count(), 0);
}

TEST_F(PagesOfAFile, ShowsThePictureOfEachPage) {
    QImage red(60, 40, QImage::Format_RGB32);
    red.fill(Qt::red);
    card.setGlance({.file = "/plans/other.pdf", .choice = {.page = 2}}, {.picture = red});
    card.setGlance({.file = "/plans/floors.pdf", .choice = {.page = 9}}, {.picture = red});
    const auto middle = [&](int row) {
        const QImage icon = pages()->item(row)->icon().pixmap({160, 120}).toImage();
        return icon.pixelColor(icon.rect().center());
    };
    EXPECT_NE(middle(1), QColor(Qt::red));
    card.setGlance({.file = "/plans/floors.pdf", .choice = {.page = 2}}, {.picture = red});
    EXPECT_EQ(middle(1), QColor(Qt::red));
    EXPECT_NE(middle(0), QColor(Qt::red));
}

}  // namespace
}  // namespace hedr
