#include "ui/site/layers_card.h"

#include <QLineEdit>
#include <QTest>

#include "tests/ui/window_user.h"
#include "ui/site/site_desk.h"

namespace hedr {
namespace {

class LayersCard : public testing::Test {
  protected:
    LayersCard() {
        w.window.setPlan(test::samplePlan());
        w.button("Layers")->click();
        QTest::qWait(0);
    }
    SiteModel& site() { return w.window.desk().site(); }
    void goTo(const QString& floor) { w.button(floor)->click(); }
    WindowUser w;
};

TEST_F(LayersCard, HidesAnImageAndShowsItAgain) {
    ASSERT_TRUE(w.map().hasPlan());
    w.button("Hide ground-floor.png")->click();
    EXPECT_FALSE(w.map().hasPlan());
    w.button("Show ground-floor.png")->click();
    EXPECT_TRUE(w.map().hasPlan());
}

TEST_F(LayersCard, TakesEveryStepBack) {
    const Site before = site().site();
    w.button("Hide ground-floor.png")->click();
    w.button("Add a floor")->click();
    w.window.desk().undo();
    w.window.desk().undo();
    EXPECT_EQ(site().site(), before);
}

TEST_F(LayersCard, LeavesTheTrailOnTheFloorWhereItWasDriven) {
    w.live(1.0);
    w.live(60.0);
    w.button("Add a floor")->click();
    const QColor accent = dayTheme().accent;
    ASSERT_TRUE(soon([&] { return w.map().isSharp() && w.pixels(accent) > 300; }));
    goTo("Floor 2");
    w.button("Robot is here")->click();
    ASSERT_TRUE(soon([&] { return w.map().isSharp(); }));
    w.live(60.5);
    ASSERT_TRUE(soon([&] { return w.map().isSharp(); }));
    EXPECT_FALSE(w.map().hasPlan());
    goTo("Floor 1");
    ASSERT_TRUE(soon([&] { return w.map().isSharp() && w.pixels(accent) > 300; }));
}

TEST_F(LayersCard, LooksAtAnotherFloorWhileTheRobotDrivesOnItsOwn) {
    w.live(1.0);
    w.live(60.0);
    w.button("Add a floor")->click();
    const QColor accent = dayTheme().accent;
    w.window.fitMap();
    const double scale = w.map().view().pixels_per_metre;
    goTo("Floor 2");
    EXPECT_EQ(site().robotFloorIndex(), 0u);
    for (int i = 0; i < 5; ++i) w.live(61.0 + i);
    ASSERT_TRUE(soon([&] { return w.map().isSharp(); }));
    EXPECT_LT(w.pixels(accent), 50) << "neither trail nor robot is on this floor";
    QTest::keyClick(&w.map(), Qt::Key_R);
    EXPECT_EQ(site().floorIndex(), 0u);
    EXPECT_EQ(w.map().view().pixels_per_metre, scale) << "the whole plan is seen again";
    EXPECT_FALSE(w.button("Robot is here"));
    ASSERT_TRUE(soon([&] { return w.map().isSharp() && w.pixels(accent) > 300; }));
}

TEST_F(LayersCard, TakesTheRobotToTheFloorOnTheMapWithOneKey) {
    w.live(1.0);
    w.live(60.0);
    QTest::mouseClick(w.button("Add a floor"), Qt::LeftButton);
    EXPECT_TRUE(w.map().hasFocus()) << "a click leaves the keys with the map";
    QTest::keyClick(&w.map(), Qt::Key_PageUp);
    ASSERT_TRUE(w.button("Robot is here"));
    EXPECT_EQ(site().robotFloorIndex(), 0u);
    QTest::keyClick(&w.map(), Qt::Key_Return);
    EXPECT_EQ(site().robotFloorIndex(), 1u);
    EXPECT_FALSE(w.button("Robot is here"));
}

TEST_F(LayersCard, KeepsTheFloorThatIsShownInSight) {
    w.window.resize(1024, 640);
    for (int i = 0; i < 6; ++i) w.button("Add a floor")->click();
    const auto in_sight = [this](const QString& floor) {
        const auto* row = w.button(floor);
        return row && row->visibleRegion().boundingRect().height() == row->height();
    };
    EXPECT_TRUE(soon([&] { return in_sight("Floor 1") && !in_sight("Floor 7"); }));
    for (int i = 0; i < 6; ++i) QTest::keyClick(&w.map(), Qt::Key_PageUp);
    EXPECT_TRUE(soon([&] { return in_sight("Floor 7") && !in_sight("Floor 1"); }));
}

TEST_F(LayersCard, LetsTheRobotStartOnTheFloorThatIsShown) {
    w.button("Add a floor")->click();
    goTo("Floor 2");
    EXPECT_EQ(site().robotFloorIndex(), 1u);
    EXPECT_FALSE(w.button("Robot is here")) << "there is no robot yet";
}

TEST_F(LayersCard, TakesTheRobotBackFromAFloorThatIsUndone) {
    w.live(1.0);
    w.button("Add a floor")->click();
    goTo("Floor 2");
    w.button("Robot is here")->click();
    w.window.desk().undo();
    EXPECT_EQ(site().robotFloorIndex(), 0u);
    EXPECT_EQ(site().floorIndex(), 0u);
}

TEST_F(LayersCard, RemovesAFloorAndBringsItBack) {
    w.button("Add a floor")->click();
    const Site before = site().site();
    w.button("Remove this floor")->click();
    ASSERT_EQ(site().site().floors.size(), 1u);
    EXPECT_EQ(site().floor().name, "Floor 2");
    EXPECT_FALSE(w.map().hasPlan());
    EXPECT_FALSE(w.button("Remove this floor")) << "the last one stays";
    w.window.desk().undo();
    EXPECT_EQ(site().site(), before);
}

TEST_F(LayersCard, RemovesNoFloorBelowTheRobot) {
    w.button("Add a floor")->click();
    w.button("Add a floor")->click();
    w.live(1.0);
    goTo("Floor 2");
    w.button("Robot is here")->click();
    goTo("Floor 1");
    w.button("Remove this floor")->click();
    EXPECT_TRUE(w.banner().startsWith("Floor 1 stays")) << w.banner().toStdString();
    goTo("Floor 3");
    w.button("Remove this floor")->click();
    EXPECT_EQ(site().site().floors.size(), 2u);
    EXPECT_EQ(site().robotFloorIndex(), 1u);
}

TEST_F(LayersCard, RenamesTheFloorWhoseNameWasTypedOver) {
    w.button("Add a floor")->click();
    QLineEdit* name = nullptr;
    for (auto* field : w.window.findChildren<QLineEdit*>()) {
        if (field->accessibleName() == "Name of the floor") name = field;
    }
    ASSERT_TRUE(name);
    name->setFocus();
    name->selectAll();
    QTest::keyClicks(name, "Cellar");
    goTo("Floor 2");
    if (name->hasFocus()) QTest::keyClick(name, Qt::Key_Return);
    EXPECT_EQ(site().site().floors[1].name, "Floor 2");
}

TEST_F(LayersCard, RenamesAFloor) {
    auto* name = w.window.findChild<QLineEdit*>(QString(), Qt::FindChildrenRecursively);
    for (auto* field : w.window.findChildren<QLineEdit*>()) {
        if (field->accessibleName() == "Name of the floor") name = field;
    }
    name->setFocus();
    name->selectAll();
    QTest::keyClicks(name, "Cellar");
    QTest::keyClick(name, Qt::Key_Return);
    EXPECT_EQ(site().floor().name, "Cellar");
}

TEST_F(LayersCard, DoesNotAlignWhatIsLocked) {
    Site locked = site().site();
    locked.floors.front().plans.front().locked = true;
    site().edit(locked);
    w.window.desk().alignTopmost();
    EXPECT_FALSE(w.window.desk().open());
}

}  // namespace
}  // namespace hedr
