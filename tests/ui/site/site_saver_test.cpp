#include "ui/site/site_saver.h"

#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>

#include "tests/ui/photo.h"
#include "tests/ui/site/menu_user.h"
#include "tests/ui/window_user.h"
#include "ui/site/open_plan_dialog.h"
#include "ui/site/site_desk.h"

namespace hedr {
namespace {

constexpr const char* kTif = "GeoTIFF…";
constexpr const char* kPng = "Image with world file…";
constexpr const char* kRos = "ROS map…";

// An operator who has a plan and saves it from the layers.
class SavingFromTheLayers : public testing::Test {
  protected:
    SavingFromTheLayers() {
        w.window.setPlan(test::samplePlan());
        w.button("Layers")->click();
        QTest::qWait(0);
    }
    bool choose(const QString& text, const QString& image = "ground-floor.png") const {
        return test::RowMenu(w.window, image).choose(text);
    }
    bool chooseOfSite(const QString& text) const {
        const auto* button = qobject_cast<QPushButton*>(w.button("Site"));
        QAction* entry = button && button->menu() ? test::entryOf(*button->menu(), text) : nullptr;
        if (entry) entry->trigger();
        return entry != nullptr;
    }
    SaveDialog* dialog() const { return w.window.findChild<SaveDialog*>(); }
    void typeName(const QString& name) const {
        auto* field = dialog()->findChild<QLineEdit*>("fileNameEdit");
        field->setText(folder.filePath(name));
        QTest::keyClick(field, Qt::Key_Return);
    }
    // Answers the question whether a file may be replaced.
    static void answer(QMessageBox::StandardButton reply) {
        QTimer::singleShot(0, [reply] {
            auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            ASSERT_NE(question, nullptr);
            question->button(reply)->click();
        });
    }
    void change(const std::function<void(Site&)>& how) {
        Site next = site().site();
        how(next);
        site().edit(next);
    }
    SiteModel& site() { return w.window.desk().site(); }

    QTemporaryDir folder;
    WindowUser w;
    QSignalSpy copies{&w.window, &MainWindow::copyChosen};
    QSignalSpy sites{&w.window, &MainWindow::siteFileChosen};
};

TEST_F(SavingFromTheLayers, AsksForTheFileOfACopyAndGivesItItsEnding) {
    change([](Site& s) {
        SitePlan& plan = s.floors.front().plans.front();
        plan.placement.origin.position = {12.0, -3.0};
        plan.crop = PlanCrop{{100.0, 50.0}, {700.0, 400.0}};
    });
    ASSERT_TRUE(choose(kPng));
    ASSERT_NE(dialog(), nullptr);
    EXPECT_EQ(dialog()->findChild<QLineEdit*>("fileNameEdit")->text(), "ground-floor-copy.png");
    typeName("hall 2.0");
    ASSERT_EQ(copies.count(), 1);
    const auto copy = copies[0][0].value<PlanCopy>();
    EXPECT_EQ(copy.file, folder.filePath("hall 2.0.png").toStdString());
    EXPECT_EQ(copy.kind, PlanCopyKind::kPng);
    EXPECT_EQ(copy.plan.placement, site().floor().plans.front().placement);
    EXPECT_EQ(copy.crop, site().floor().plans.front().crop);
    EXPECT_TRUE(soon([&] { return dialog() == nullptr; }));
}

TEST_F(SavingFromTheLayers, CopiesTheFlatImageOfAPhoto) {
    change([](Site& s) {
        s.floors.front().plans.front().straightened = Straightening{test::sheetInPhoto()};
    });
    PlanImage flat = test::samplePlan();
    flat.levels.erase(flat.levels.begin());
    site().giveImage(site().floor().plans.front(), flat);
    ASSERT_TRUE(choose(kRos));
    typeName("flat");
    ASSERT_EQ(copies.count(), 1);
    EXPECT_EQ(copies[0][0].value<PlanCopy>().plan.levels.front().width_px,
              flat.levels.front().width_px);
}

TEST_F(SavingFromTheLayers, SaysWhatAGeoTiffNeedsFirst) {
    ASSERT_TRUE(choose(kTif));
    EXPECT_EQ(dialog(), nullptr);
    EXPECT_TRUE(w.banner().contains("Tie the site to the globe first (G)"))
        << w.banner().toStdString();
}

TEST_F(SavingFromTheLayers, GivesAGeoTiffTheTieOfTheSite) {
    const GeoTie tie{{1.0, 2.0}, {48.0, 11.0}, 0.1};
    change([&](Site& s) { s.geo_tie = tie; });
    ASSERT_TRUE(choose(kTif));
    ASSERT_NE(dialog(), nullptr);
    typeName("hall");
    ASSERT_EQ(copies.count(), 1);
    EXPECT_EQ(copies[0][0].value<PlanCopy>().geo_tie, tie);
    EXPECT_EQ(copies[0][0].value<PlanCopy>().file, folder.filePath("hall.tif").toStdString());
}

TEST_F(SavingFromTheLayers, TakesTheTieOfTheFileWhileThePlanLiesWhereItSays) {
    PlanImage tied = test::colouredPlan();
    tied.geo_tie = GeoTie{{}, {48.0, 11.0}, 0.0};
    site().addImage(tied);
    ASSERT_TRUE(choose(kTif, "coloured-floor.png"));
    ASSERT_NE(dialog(), nullptr);
    dialog()->reject();
    EXPECT_TRUE(soon([&] { return dialog() == nullptr; }));
    change([](Site& s) { s.floors.front().plans.back().placement.origin.position.x += 1.0; });
    ASSERT_TRUE(choose(kTif, "coloured-floor.png"));
    EXPECT_EQ(dialog(), nullptr);
}

TEST_F(SavingFromTheLayers, AsksBeforeItReplacesTheFileThatTheEndingMakesOfAName) {
    QFile there(folder.filePath("map.yaml"));
    ASSERT_TRUE(there.open(QIODevice::WriteOnly));
    there.close();
    ASSERT_TRUE(choose(kRos));
    answer(QMessageBox::No);
    typeName("map");
    EXPECT_EQ(copies.count(), 0);
    answer(QMessageBox::Yes);
    typeName("map");
    EXPECT_EQ(copies.count(), 1);
}

TEST_F(SavingFromTheLayers, OffersNoCopyOfAnImageThatIsNotThere) {
    change([](Site& s) { s.floors.front().plans.front().image_file = "gone.png"; });
    const test::RowMenu menu(w.window, "gone.png");
    for (const char* name : {"Align…", "Straighten…", "Crop…", "Save a copy as"}) {
        const QAction* entry = menu.entry(name);
        ASSERT_NE(entry, nullptr) << name;
        EXPECT_FALSE(entry->isEnabled()) << name;
        EXPECT_TRUE(entry->toolTip().contains("not there")) << name;
    }
}

TEST_F(SavingFromTheLayers, AsksForTheFileOfTheSite) {
    ASSERT_TRUE(chooseOfSite("Save site as…"));
    ASSERT_NE(dialog(), nullptr);
    typeName("campus");
    ASSERT_EQ(sites.count(), 1);
    EXPECT_EQ(sites[0][0].toString(), folder.filePath("campus.site.toml"));
}

TEST_F(SavingFromTheLayers, AsksForTheFileOfTheSiteByItsKey) {
    QTest::keyClick(&w.window, Qt::Key_S, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_NE(dialog(), nullptr);
}

TEST_F(SavingFromTheLayers, OpensAnotherSite) {
    QFile saved(folder.filePath("campus.site.toml"));
    ASSERT_TRUE(saved.open(QIODevice::WriteOnly));
    saved.write("site = 1\n");
    saved.close();
    QSignalSpy chosen(&w.window, &MainWindow::planFileChosen);
    ASSERT_TRUE(chooseOfSite("Open site…"));
    auto* open = w.window.findChild<OpenPlanDialog*>();
    ASSERT_NE(open, nullptr);
    EXPECT_TRUE(open->selectedNameFilter().contains("Sites"));
    auto* field = open->findChild<QLineEdit*>("fileNameEdit");
    field->setText(saved.fileName());
    QTest::keyClick(field, Qt::Key_Return);
    ASSERT_TRUE(soon([&] { return chosen.count() == 1; }));
    EXPECT_EQ(chosen[0][0].value<PlanFileWish>().file, saved.fileName());
}

}  // namespace
}  // namespace hedr
