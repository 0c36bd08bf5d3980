#include "ui/site/plan_opener.h"

#include <QDropEvent>
#include <QLineEdit>
#include <QMimeData>
#include <QSignalSpy>

#include "tests/ui/site/plan_files.h"
#include "tests/ui/window_user.h"
#include "ui/site/open_plan_dialog.h"
#include "ui/site/page_card.h"
#include "ui/site/plan_row.h"
#include "ui/site/recent_plans_card.h"

namespace hedr {
namespace {

class PlanOpening : public testing::Test {
  protected:
    RecentPlansCard* card() const { return w.window.findChild<RecentPlansCard*>(); }
    OpenPlanDialog* dialog() const { return w.window.findChild<OpenPlanDialog*>(); }
    void press(Qt::Key key) { QTest::keyClick(QApplication::focusWidget(), key); }
    void askForRecent(const QStringList& recent) {
        w.window.setRecentPlans(recent);
        press(Qt::Key_P);
        ASSERT_TRUE(soon([&] { return card()->isVisible(); }));
    }
    PlanFileWish wish(int index) const { return spy[index][0].value<PlanFileWish>(); }
    QString file(int index) const { return wish(index).file; }
    // With something on the web, which is passed over.
    void drop(const QStringList& names) {
        QList<QUrl> urls{QUrl("https://example.org/floor.png")};
        for (const QString& name : names) urls << QUrl::fromLocalFile(name);
        QMimeData data;
        data.setUrls(urls);
        QDragEnterEvent enter({600, 400}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&w.window, &enter);
        EXPECT_TRUE(enter.isAccepted());
        QDropEvent event({600, 400}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&w.window, &event);
    }

    test::PlanFiles files;
    WindowUser w;
    QSignalSpy spy{&w.window, &MainWindow::planFileChosen};
};

TEST_F(PlanOpening, OpensTheNewestOfTheRecentPlansWithPAndEnter) {
    const QString newest = files.addImage("new.png");
    askForRecent({newest, files.addImage("old.png")});
    press(Qt::Key_Return);
    ASSERT_TRUE(soon([&] { return spy.count() == 1; }));
    EXPECT_EQ(file(0), newest);
    EXPECT_FALSE(card()->isVisible());
    EXPECT_TRUE(w.map().hasFocus());
}

TEST_F(PlanOpening, GoesThroughTheRecentPlansWithTheArrowKeys) {
    const QString old = files.addImage("old.png");
    askForRecent({files.addImage("new.png"), old});
    press(Qt::Key_Up);
    press(Qt::Key_Down);
    press(Qt::Key_Return);
    ASSERT_TRUE(soon([&] { return spy.count() == 1; }));
    EXPECT_EQ(file(0), old);
}

TEST_F(PlanOpening, DoesNotShowRecentPlansThatAreGone) {
    const QString there = files.addImage("there.png");
    askForRecent({files.path("gone.png"), there});
    QStringList shown;
    for (const auto* row : card()->findChildren<PlanRow*>()) shown << row->text();
    EXPECT_EQ(shown, QStringList({"there.png", "Open another…"}));
}

TEST_F(PlanOpening, ClosesTheRecentPlansWithEscapeOrP) {
    askForRecent({files.addImage("floor.png")});
    press(Qt::Key_Escape);
    EXPECT_FALSE(card()->isVisible());
    press(Qt::Key_P);
    ASSERT_TRUE(soon([&] { return card()->isVisible(); }));
    press(Qt::Key_P);
    EXPECT_FALSE(card()->isVisible());
    EXPECT_EQ(spy.count(), 0);
}

TEST_F(PlanOpening, OpensTheDialogWhereThereIsNoRecentPlan) {
    w.window.setRecentPlans({files.path("gone.png")});
    press(Qt::Key_P);
    ASSERT_TRUE(soon([&] { return dialog() != nullptr; }));
    EXPECT_FALSE(card()->isVisible());
}

TEST_F(PlanOpening, OpensAnotherPlanThroughTheDialog) {
    askForRecent({files.addImage("floor.png")});
    const QString other = files.addImage("other.png");
    w.button("Open another…")->click();
    ASSERT_NE(dialog(), nullptr);
    dialog()->selectFile(other);
    dialog()->findChild<QLineEdit*>()->setText("other.png");
    QTest::keyClick(dialog()->findChild<QLineEdit*>(), Qt::Key_Return);
    ASSERT_TRUE(soon([&] { return spy.count() == 1; }));
    EXPECT_EQ(file(0), other);
    EXPECT_TRUE(soon([&] { return dialog() == nullptr; }));
}

TEST_F(PlanOpening, ShowsInTheDialogWhatIsInAFile) {
    w.window.setRecentPlans({});
    press(Qt::Key_P);
    ASSERT_NE(dialog(), nullptr);
    const auto* words = dialog()->findChild<QLabel*>("words");
    emit dialog()->currentChanged(files.addImage("floor.png", {640, 480}));
    EXPECT_TRUE(soon([&] { return words->text().startsWith("640 × 480 px, PNG"); }));
    EXPECT_FALSE(dialog()->findChild<QLabel*>("picture")->pixmap().isNull());
    emit dialog()->currentChanged(files.addText("notes.png", "no picture"));
    EXPECT_TRUE(soon([&] { return words->text().contains("not an image"); }));
    EXPECT_TRUE(dialog()->findChild<QLabel*>("picture")->pixmap().isNull());
}

TEST_F(PlanOpening, PassesSeveralDroppedPlansOnOneAfterTheOther) {
    drop({"/plans/1.png", "/plans/0.png"});
    ASSERT_TRUE(soon([&] { return spy.count() == 2; }));
    EXPECT_EQ(file(0), "/plans/1.png");
    EXPECT_EQ(file(1), "/plans/0.png");
}

TEST_F(PlanOpening, AsksWhichPageAndScaleBeforeAPdfIsOpened) {
    const QString pdf = files.addPdf("floors.pdf", {QPageSize::A3, QPageSize::A3, QPageSize::A4});
    const QString after = files.addImage("after.png");
    drop({pdf, after});
    auto* pages = w.window.findChild<PageCard*>();
    ASSERT_TRUE(soon([&] { return pages->isVisible(); }));
    EXPECT_EQ(spy.count(), 0);
    press(Qt::Key_Right);
    pages->findChild<QLineEdit*>("paper_scale")->setText("1 : 200");
    press(Qt::Key_Return);
    ASSERT_TRUE(soon([&] { return spy.count() == 2; }));
    EXPECT_EQ(wish(0), (PlanFileWish{.file = pdf, .choice = {.page = 2, .paper_scale = 200.0}}));
    EXPECT_EQ(wish(1).file, after);
    EXPECT_FALSE(pages->isVisible());
}

TEST_F(PlanOpening, GoesOnWithTheNextFileWhereNoPageIsWanted) {
    const QString after = files.addImage("after.png");
    drop({files.addPdf("floors.pdf", {QPageSize::A3, QPageSize::A3}), after});
    auto* pages = w.window.findChild<PageCard*>();
    ASSERT_TRUE(soon([&] { return pages->isVisible(); }));
    press(Qt::Key_Escape);
    ASSERT_TRUE(soon([&] { return spy.count() == 1; }));
    EXPECT_EQ(wish(0).file, after);
}

TEST(OpenPlanDialog, OffersEveryFormatOfAPlanAtFirst) {
    const QString all = planNameFilters().front();
    for (const char* pattern :
         {"*.png", "*.jpg", "*.jpeg", "*.bmp", "*.tif", "*.webp", "*.pgm", "*.mbtiles", "*.pdf",
          "*.svg", "*.dxf", "*.kml", "*.yaml", "*.toml"}) {
        EXPECT_TRUE(all.contains(pattern)) << pattern;
    }
    EXPECT_TRUE(planNameFilters().back().contains("(*)"));
}

}  // namespace
}  // namespace hedr
