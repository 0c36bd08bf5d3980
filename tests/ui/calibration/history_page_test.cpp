#include "ui/calibration/history_page.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QScrollArea>
#include <QSignalSpy>
#include <QTest>
#include <algorithm>

#include "tests/ui/calibration/history_samples.h"
#include "ui/calibration/history_card.h"
#include "ui/calibration/history_row.h"
#include "ui/calibration/verdict_box.h"

namespace hedr {
namespace {

using test::afterWheels;
using test::asBuilt;
using test::entryOf;
using test::longView;
using test::recordOf;
using test::someView;
using test::wheelsRecord;

void handleLayouts() {
    for (int nested = 0; nested < 3; ++nested) QCoreApplication::processEvents();
}

// Finds things on the page as a person would: by their words.
class PageOfTheHistory : public testing::Test {
  protected:
    PageOfTheHistory() {
        page.setTheme(dayTheme());
        page.resize(1280, 800);
        page.show(someView());
        page.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&page));
        page.focusFirst();
    }
    static void press(Qt::Key key, int times = 1) {
        for (int i = 0; i < times; ++i) QTest::keyClick(QApplication::focusWidget(), key);
    }
    QPushButton* button(const QString& text) const {
        for (auto* candidate : page.findChildren<QPushButton*>()) {
            if (candidate->text() == text && candidate->isVisible()) return candidate;
        }
        return nullptr;
    }
    bool isOffered(const QString& text) const { return button(text) && button(text)->isEnabled(); }
    // With plain blanks, and without the places where a word may be broken.
    static QString plain(QString text) { return text.replace(QChar(0xA0), ' ').remove(u'\u200B'); }
    bool tells(const QString& words) const {
        const auto labels = page.findChildren<QLabel*>();
        return std::ranges::any_of(labels, [&](const QLabel* label) {
            return label->isVisible() && plain(label->text()).contains(words);
        });
    }
    QString line(const QString& name) const {
        for (const auto* label : page.findChildren<QLabel*>()) {
            if (label->isVisible() && label->text() == name) return label->accessibleDescription();
        }
        return "not there";
    }
    QString verdict() const { return page.findChild<VerdictBox*>()->accessibleName(); }
    QStringList rows() const {
        QStringList said;
        for (const auto* row : page.findChildren<HistoryRow*>()) {
            if (row->isVisible())
                said << row->accessibleName() + ": " +
                            row->accessibleDescription().section(" · ", -1);
        }
        return said;
    }
    QString focused() const { return QApplication::focusWidget()->accessibleName(); }

    HistoryPage page;
};

TEST_F(PageOfTheHistory, ShowsTheNewestFirst) {
    EXPECT_EQ(rows().join(" | ").toStdString(),
              "Gyro warm-up: cannot be read | Gyro bias: accepted, not taken over | "
              "Wheels by driving: accepted");
    EXPECT_EQ(focused(), "Gyro warm-up");
    EXPECT_EQ(verdict(), "Cannot be read");
}

TEST_F(PageOfTheHistory, ShowsWhatWasFound) {
    press(Qt::Key_Down, 2);
    EXPECT_EQ(focused(), "Wheels by driving");
    EXPECT_EQ(line("Wheelbase, m"), "before 0.4100, found 0.5531 ± 0.0021, file now 0.5531");
    EXPECT_EQ(line("Left wheel, mm"),
              "before 200.000, found 200.010 ± 0.098, the file kept what it had, "
              "file now 200.000");
    EXPECT_EQ(verdict(), "Accepted");
    EXPECT_TRUE(tells("Distance at the end, held out: was 0.205 m, then 0.016 m"));
    EXPECT_TRUE(tells("The robot slipped on 5 % of the way"));
    EXPECT_TRUE(tells("PackBot 3 · concrete · 21.4 °C · hedr-ocu 0.1.0 · raw data: 2 files"));
    HistoryView view = someView();
    view.now.reset();
    page.show(view);
    press(Qt::Key_Up);
    EXPECT_EQ(line("Gyro bias, °/s"), "before –, found 0.8995 ± 0.0023, file now –");
    EXPECT_TRUE(tells("no raw data"));
}

TEST_F(PageOfTheHistory, ShowsWhatWasRestored) {
    HistoryView view = someView();
    view.entries.push_back(
        entryOf("r", recordOf("restore", "2026-11-27T09:00:00Z", afterWheels(), asBuilt())));
    page.show(view);
    press(Qt::Key_Up, 5);
    EXPECT_EQ(focused(), "Restored");
    EXPECT_EQ(line("Wheelbase, m"), "before 0.5531, after 0.4100, file now 0.5531");
    EXPECT_EQ(line("Left wheel, mm"), "not there") << "it is as it was";
}

TEST_F(PageOfTheHistory, IsLeftByEscape) {
    const QSignalSpy closed(&page, &HistoryPage::closed);
    press(Qt::Key_Escape);
    EXPECT_EQ(closed.count(), 1);
    button("Back")->setFocus();
    press(Qt::Key_Escape);
    EXPECT_EQ(closed.count(), 2);
    press(Qt::Key_Return);
    EXPECT_EQ(closed.count(), 3);
}

TEST_F(PageOfTheHistory, RestoresTheChosenEntry) {
    HistoryView view = someView();
    view.now->geometry.wheelbase_m = 0.6;
    page.show(view);
    press(Qt::Key_Down, 2);
    QSignalSpy restored(&page, &HistoryPage::restoreWished);
    button("Restore values before")->setFocus();
    press(Qt::Key_Return);
    button("Restore values after")->setFocus();
    press(Qt::Key_Space);
    ASSERT_EQ(restored.count(), 2);
    for (const auto& wish : restored) EXPECT_EQ(wish[0], "2026-11-12T123005Z-wheels");
    EXPECT_EQ(restored[0][1].value<RestoreTo>(), RestoreTo::kBefore);
    EXPECT_EQ(restored[1][1].value<RestoreTo>(), RestoreTo::kAfter);
}

TEST_F(PageOfTheHistory, ExportsTheChosenEntry) {
    QTest::mouseClick(page.findChildren<HistoryRow*>().at(1), Qt::LeftButton);
    EXPECT_EQ(focused(), "Gyro bias");
    const QSignalSpy exported(&page, &HistoryPage::exportWished);
    button("Export…")->click();
    ASSERT_EQ(exported.count(), 1);
    EXPECT_EQ(exported[0][0], "2026-11-20T080000Z-gyro-bias");
}

TEST_F(PageOfTheHistory, OffersNoNumbersThatTheFileHas) {
    press(Qt::Key_Down);
    EXPECT_FALSE(isOffered("Restore values before")) << "nothing was changed then nor since";
    EXPECT_EQ(button("Restore values after"), nullptr) << "it was not taken over";
    press(Qt::Key_Down);
    EXPECT_TRUE(isOffered("Restore values before"));
    EXPECT_FALSE(isOffered("Restore values after"));
    EXPECT_EQ(button("Restore values after")->toolTip(),
              "The vehicle file has these numbers already.");
}

TEST_F(PageOfTheHistory, OffersNothingOfWhatCannotBeRead) {
    EXPECT_TRUE(tells("record.toml:14 is not understood: a value is missing."));
    for (const char* text : {"Export…", "Restore values before", "Restore values after"})
        EXPECT_FALSE(isOffered(text)) << text;
    EXPECT_EQ(line("Wheelbase, m"), "not there");
    HistoryView view = someView();
    view.entries.back().record = wheelsRecord();
    view.entries.back().record->vehicle_before = "wheelbase_m = \"wide\"\n";
    page.show(view);
    EXPECT_FALSE(isOffered("Restore values before"));
    EXPECT_TRUE(isOffered("Export…"));
}

// A restored file has the numbers: Enter once more must not take them back.
TEST_F(PageOfTheHistory, KeepsTheChosenEntryAfterARestore) {
    press(Qt::Key_Down, 2);
    button("Restore values before")->setFocus();
    HistoryView view = longView();
    view.now = asBuilt();
    page.show(view);
    EXPECT_FALSE(isOffered("Restore values before"));
    EXPECT_EQ(focused(), "Wheels by driving");
    QSignalSpy exported(&page, &HistoryPage::exportWished);
    button("Export…")->click();
    EXPECT_EQ(exported.last()[0], "2026-11-12T123005Z-wheels");
    view.entries.erase(view.entries.begin());
    page.show(view);
    button("Export…")->click();
    EXPECT_EQ(exported.last()[0], "g") << "the newest, where it is gone";
}

TEST_F(PageOfTheHistory, BringsRowsIntoSight) {
    page.resize(1024, 640);
    page.show(longView());
    for (const Qt::Key key : {Qt::Key_Down, Qt::Key_Up}) {
        press(key, 20);
        handleLayouts();
        const QWidget* row = QApplication::focusWidget();
        EXPECT_EQ(row->visibleRegion().boundingRect().size(), row->size());
    }
}

TEST_F(PageOfTheHistory, IsGoneThroughByTab) {
    page.resize(1024, 640);
    HistoryView view = longView();
    view.now->geometry.wheelbase_m = 0.6;
    page.show(view);
    page.focusFirst();
    press(Qt::Key_Down, 6);
    handleLayouts();
    QStringList reached;
    for (int i = 0; i < 6; ++i) {
        const auto* pressed = qobject_cast<const QPushButton*>(QApplication::focusWidget());
        reached << (pressed ? pressed->text() : focused());
        press(Qt::Key_Tab);
    }
    EXPECT_EQ(reached.join(" | ").toStdString(),
              "Wheels by driving | Values | Back | Export… | Restore values before | Restore "
              "values after");
    EXPECT_EQ(focused(), "Wheels by driving") << "the chosen row, and no other";
}

TEST_F(PageOfTheHistory, SaysThatNothingHasBeenCalibrated) {
    const QSignalSpy closed(&page, &HistoryPage::closed);
    page.show({.robot = "PackBot 3", .now = asBuilt()});
    EXPECT_TRUE(tells("Nothing has been calibrated yet."));
    EXPECT_TRUE(rows().empty());
    EXPECT_FALSE(page.findChild<HistoryCard*>()->isVisible());
    EXPECT_EQ(button("Export…"), nullptr);
    page.focusFirst();
    press(Qt::Key_Escape);
    EXPECT_EQ(closed.count(), 1);
    page.show(someView());
    EXPECT_EQ(rows().size(), 3);
}

// Text of a file is a stranger's.
TEST_F(PageOfTheHistory, ShowsTextOfFilesAsPlainText) {
    HistoryView view = someView();
    CalibrationRecord record = wheelsRecord();
    record.who = "<b>Ada</b>\n\x1b[1m";
    record.reason = "<img src=x> held";
    view.entries.push_back(entryOf("x", record));
    view.robot = "Pack\nBot";
    page.show(view);
    press(Qt::Key_Up, 5);
    EXPECT_TRUE(tells("<b>Ada</b>  [1m"));
    EXPECT_TRUE(tells("<img src=x> held"));
    for (const auto* label : page.findChildren<QLabel*>())
        EXPECT_FALSE(label->text().contains("\x1b")) << label->text().toStdString();
}

TEST_F(PageOfTheHistory, HasRoomForItsWordsInEverySize) {
    for (const QSize size : {QSize(1600, 1000), QSize(1280, 800), QSize(1024, 640)}) {
        page.resize(size);
        page.show(longView());
        page.focusFirst();
        press(Qt::Key_Up, 12);
        for (int i = 0; i < 12; ++i) {
            handleLayouts();
            EXPECT_LE(page.minimumSizeHint().width(), size.width()) << i;
            EXPECT_LE(page.minimumSizeHint().height(), size.height()) << i;
            for (const auto* area : page.findChildren<QScrollArea*>())
                EXPECT_LE(area->widget()->width(), area->viewport()->width()) << i;
            for (const auto* label : page.findChildren<QLabel*>()) {
                if (!label->isVisible()) continue;
                const int needed_px = label->hasHeightForWidth()
                                          ? label->heightForWidth(label->width())
                                          : label->sizeHint().height();
                EXPECT_GE(label->height(), needed_px) << label->text().toStdString();
            }
            press(Qt::Key_Down);
        }
    }
}

// Pictures for people to look at, as those of calibration_screenshots_test.cpp.
void writeHistoryPictures(const QString& name, const HistoryView& view, int steps_down) {
    const QString folder = QStringLiteral(HEDR_BINARY_DIR "/screenshots");
    QDir().mkpath(folder);
    for (const ThemeName theme : {ThemeName::kDay, ThemeName::kNight}) {
        HistoryPage page;
        page.setTheme(themeOf(theme));
        page.show(view);
        page.activateWindow();
        ASSERT_TRUE(QTest::qWaitForWindowActive(&page));
        page.focusFirst();
        for (int i = 0; i < steps_down; ++i)
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Down);
        for (const QSize size : {QSize(1280, 800), QSize(1024, 640)}) {
            page.resize(size);
            handleLayouts();
            const QString file = QStringLiteral("%1/history-%2-%3-%4.png")
                                     .arg(folder, name)
                                     .arg(theme == ThemeName::kDay ? "day" : "night")
                                     .arg(size.width());
            EXPECT_TRUE(page.grab().save(file)) << file.toStdString();
        }
    }
}

TEST(HistoryScreenshots, ShowThePageInEverySize) {
    HistoryView few = someView();
    few.now->geometry.wheelbase_m = 0.5602;
    writeHistoryPictures("wheels", few, 2);
    writeHistoryPictures("damaged", few, 0);
    writeHistoryPictures("long", longView(), 0);
    writeHistoryPictures("restored", longView(), 7);
    writeHistoryPictures("wordy", longView(), 8);
    writeHistoryPictures("empty", {.robot = "PackBot 3"}, 0);
}

}  // namespace
}  // namespace hedr
