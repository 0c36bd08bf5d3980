#include <QTest>

#include "core/site/survey/rectification.h"
#include "tests/ui/photo.h"
#include "tests/ui/window_user.h"
#include "ui/site/site_desk.h"
#include "ui/site/straighten_card.h"

namespace hedr {
namespace {

class StraightenPage : public testing::Test {
  protected:
    StraightenPage() {
        w.window.setPlan(photo);
        w.window.desk().straightenTopmost();
        EXPECT_TRUE(soon([&] { return !says("Looking for"); }));
    }
    Site site() { return w.window.desk().site().site(); }
    const SitePlan& plan() { return w.window.desk().site().floor().plans.front(); }
    const PlanImage* image() { return w.window.desk().site().image(plan()); }
    bool says(const QString& words) {
        for (const auto* label : w.window.findChildren<QLabel*>()) {
            if (label->isVisible() && label->text().contains(words)) return true;
        }
        return false;
    }
    QPoint onMap(Point<Plan> p) {
        const Point<View> at = w.map().view().viewFromWorld() * (photo.worldFromPlan() * p);
        return {qRound(at.x), qRound(at.y)};
    }
    void drag(Point<Plan> from, Point<Plan> to) {
        QTest::mousePress(&w.map(), Qt::LeftButton, {}, onMap(from));
        QTest::mouseMove(&w.map(), onMap(to));
        QTest::mouseRelease(&w.map(), Qt::LeftButton, {}, onMap(to));
    }
    // A click moves the nearest corner.
    void clickCorners() {
        for (const Point<Plan>& corner : test::sheetInPhoto().corners) {
            QTest::mouseClick(&w.map(), Qt::LeftButton, {}, onMap(corner));
        }
    }
    void makeFlat() {
        clickCorners();
        w.button("Done")->click();
        ASSERT_TRUE(soon([&] { return !w.window.desk().open(); }));
    }

    const PlanImage photo = test::photographedPlan();
    WindowUser w;
};

TEST_F(StraightenPage, MakesThePhotoOfASheetFlat) {
    makeFlat();
    ASSERT_TRUE(plan().straightened);
    const PlanLevel& size = image()->levels.front();
    const auto flat = rectificationOf(1200, 900, plan().straightened->quad);
    ASSERT_TRUE(flat);
    EXPECT_EQ(size.width_px, flat->width_px);
    EXPECT_NEAR(flat->aspect.value, test::kSheetAspect, 0.04);
}

TEST_F(StraightenPage, IsOneStepThatGivesThePhotoBackOnUndo) {
    const Site before = w.window.desk().site().site();
    makeFlat();
    w.window.desk().undo();
    EXPECT_FALSE(plan().straightened);
    EXPECT_EQ(plan().placement, photo.placement);
    EXPECT_EQ(image()->levels.front().width_px, 1200);
}

TEST_F(StraightenPage, GivesThePhotoBackLaterToo) {
    makeFlat();
    w.window.desk().straightenTopmost();
    w.button("Use the photo as it was")->click();
    EXPECT_FALSE(w.window.desk().open());
    EXPECT_FALSE(plan().straightened);
    EXPECT_NEAR(plan().placement.resolution_m, photo.placement.resolution_m, 1e-9);
    EXPECT_NEAR(plan().placement.origin.position.x, 0.0, 1e-6);
}

TEST_F(StraightenPage, ProposesTheCornersOfTheSheet) {
    EXPECT_FALSE(w.button("Undo")->isEnabled());
    w.button("Done")->click();
    ASSERT_TRUE(soon([&] { return !w.window.desk().open(); }));
    for (std::size_t i = 0; i < 4; ++i) {
        const Point<Plan> truth = test::sheetInPhoto().corners[i];
        EXPECT_NEAR((plan().straightened->quad.corners[i] - truth).length(), 0.0, 3.0) << i;
    }
}

TEST_F(StraightenPage, BeginsAgainWithTheCornersThatItHad) {
    makeFlat();
    const SitePlan flat = plan();
    w.window.desk().straightenTopmost();
    w.button("Done")->click();
    ASSERT_TRUE(soon([&] { return !w.window.desk().open(); }));
    EXPECT_EQ(plan().straightened, flat.straightened);
    EXPECT_NEAR(plan().placement.origin.position.x, flat.placement.origin.position.x, 1e-6);
}

TEST_F(StraightenPage, RefusesCornersThatNoRectangleHas) {
    clickCorners();
    ASSERT_TRUE(w.button("Done")->isEnabled());
    const Quad sheet = test::sheetInPhoto();
    drag(sheet.corners[0], sheet.corners[2] + Vector<Plan>{-40.0, 60.0});
    EXPECT_TRUE(says("These corners will not do"));
    EXPECT_FALSE(w.button("Done")->isEnabled());
    w.button("Undo")->click();
    EXPECT_FALSE(says("These corners will not do"));
    EXPECT_TRUE(w.button("Done")->isEnabled());
}

TEST_F(StraightenPage, TakesTheSidesOfASheet) {
    clickCorners();
    auto* sides = w.window.findChild<StraightenCard*>()->findChild<QComboBox*>();
    sides->setFocus();
    QTest::keyClick(sides, Qt::Key_Down);
    w.button("Done")->click();
    ASSERT_TRUE(soon([&] { return !w.window.desk().open(); }));
    EXPECT_NEAR(plan().straightened->aspect.value(), std::numbers::sqrt2, 1e-9);
}

TEST_F(StraightenPage, LeavesThePhotoAsItWasWhenCanceled) {
    clickCorners();
    w.button("Cancel")->click();
    EXPECT_FALSE(w.window.desk().open());
    EXPECT_FALSE(plan().straightened);
    EXPECT_EQ(plan().placement, photo.placement);
}

TEST_F(StraightenPage, OpensFromTheAlignCardBeforeTheFirstStep) {
    w.button("Cancel")->click();
    w.window.desk().alignTopmost();
    QTest::qWait(0);
    w.button("Move")->click();
    w.button("Turn left")->click();
    EXPECT_FALSE(w.button("Straighten a photo…"));
    w.button("Undo")->click();
    w.button("Straighten a photo…")->click();
    EXPECT_TRUE(says("Straighten evacuation-plan.jpg"));
}

}  // namespace
}  // namespace hedr
