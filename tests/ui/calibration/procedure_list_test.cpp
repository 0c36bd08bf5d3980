#include "ui/calibration/procedure_list.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QSignalSpy>
#include <QTest>

#include "tests/ui/calibration/samples.h"

namespace hedr {
namespace {

class ListOfProcedures : public testing::Test {
  protected:
    ListOfProcedures() {
        list.setTheme(dayTheme());
        list.resize(720, 320);
        list.show(test::procedureEntries());
        list.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&list));
        list.focusFirst();
    }
    void press(Qt::Key key) { QTest::keyClick(QApplication::focusWidget(), key); }
    QString chosen() const { return spy.isEmpty() ? QString() : spy.last().at(0).toString(); }

    ProcedureList list{nullptr};
    QSignalSpy spy{&list, &ProcedureList::chosen};
};

TEST_F(ListOfProcedures, IsGoneThroughByArrowsAndEnter) {
    press(Qt::Key_Up);
    press(Qt::Key_Return);
    EXPECT_EQ(chosen(), "gyro_bias");
    for (int i = 0; i < 20; ++i) press(Qt::Key_Down);
    press(Qt::Key_Return);
    EXPECT_EQ(chosen(), "compass");
    EXPECT_FALSE(QApplication::focusWidget()->visibleRegion().isEmpty()) << "brought into sight";
    press(Qt::Key_Up);
    press(Qt::Key_Space);
    EXPECT_EQ(chosen(), "encoders");
}

TEST_F(ListOfProcedures, IsLeftByEscape) {
    const QSignalSpy closed(&list, &ProcedureList::closeWished);
    press(Qt::Key_Escape);
    EXPECT_EQ(closed.count(), 1);
}

TEST_F(ListOfProcedures, SaysHowEachWentTheLastTime) {
    QStringList said;
    for (const auto* row : list.findChildren<QAbstractButton*>()) {
        said << row->accessibleDescription();
    }
    EXPECT_TRUE(said.at(0).endsWith("Last: 12 Nov, accepted")) << said.at(0).toStdString();
    EXPECT_TRUE(said.at(2).endsWith("Last: never")) << said.at(2).toStdString();
}

TEST_F(ListOfProcedures, KeepsTheFocusWhenItIsShownAgain) {
    press(Qt::Key_Down);
    const QWidget* before = QApplication::focusWidget();
    auto entries = test::procedureEntries();
    entries[1].last = "today, accepted";
    list.show(entries);
    EXPECT_EQ(QApplication::focusWidget(), before);
    press(Qt::Key_Return);
    EXPECT_EQ(chosen(), "gyro_warm_up");
}

}  // namespace
}  // namespace hedr
