#include <QTest>

#include "tests/ui/window_user.h"
#include "ui/site/distance_panel.h"
#include "ui/site/site_desk.h"

namespace hedr {
namespace {

class AlignPage : public testing::Test {
  protected:
    AlignPage() {
        w.window.setPlan(test::samplePlan());
        w.window.desk().alignTopmost();
        QTest::qWait(0);
    }
    void click(Point<World> at) {
        const Point<View> p = w.map().view().viewFromWorld() * at;
        QTest::mouseClick(&w.map(), Qt::LeftButton, {}, {qRound(p.x), qRound(p.y)});
    }
    const PlanPlacement& placement() {
        return w.window.desk().site().floor().plans.front().placement;
    }
    WindowUser w;
};

TEST_F(AlignPage, MovesThePlanToItsFirstPointAndBackOnUndo) {
    const PlanPlacement before = placement();
    click({40.0, 20.0});
    click({45.0, 20.0});
    EXPECT_NEAR(placement().origin.position.x, before.origin.position.x + 5.0, 0.2);
    w.button("Undo")->click();
    EXPECT_EQ(placement(), before);
}

TEST_F(AlignPage, ScalesThePlanByAKnownDistance) {
    w.button("Distance")->click();
    click({30.0, 20.0});
    click({50.0, 20.0});
    auto* field = w.window.findChild<DistancePanel*>()->findChild<QLineEdit*>();
    QTest::keyClicks(field, "40 m");
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_NEAR(placement().resolution_m, 0.1, 0.001);
}

TEST_F(AlignPage, LeavesThePlanAsItWasWhenCanceled) {
    const PlanPlacement before = placement();
    click({40.0, 20.0});
    click({45.0, 22.0});
    w.button("Cancel")->click();
    EXPECT_EQ(placement(), before);
    EXPECT_FALSE(w.window.desk().open());
}

TEST_F(AlignPage, IsOneStepOfTheSiteOnceItIsDone) {
    const PlanPlacement before = placement();
    click({40.0, 20.0});
    click({45.0, 22.0});
    w.button("Done")->click();
    EXPECT_NE(placement(), before);
    w.window.desk().undo();
    EXPECT_EQ(placement(), before);
}

TEST_F(AlignPage, KeepsTheAlignmentWhenAnotherPlanComesMeanwhile) {
    click({40.0, 20.0});
    click({45.0, 22.0});
    const PlanPlacement aligned = placement();
    w.window.setPlan(test::colouredPlan());
    w.button("Done")->click();
    EXPECT_EQ(placement(), aligned);
}

TEST(LengthFromText, TakesTheUnitsOfDrawings) {
    EXPECT_DOUBLE_EQ(*lengthFromText("12,5"), 12.5);
    EXPECT_DOUBLE_EQ(*lengthFromText("250 cm"), 2.5);
    EXPECT_DOUBLE_EQ(*lengthFromText("10 ft"), 3.048);
    for (const char* text : {"", "-3", "0", "nan", "inf", "m", "1e9"}) {
        EXPECT_FALSE(lengthFromText(text)) << text;
    }
}

}  // namespace
}  // namespace hedr
