#include "ui/site/site_desk.h"

#include "tests/ui/photo.h"
#include "tests/ui/window_user.h"

namespace hedr {
namespace {

// What an operator hears who wishes something that is not possible.
class WorkThatIsRefused : public testing::Test {
  protected:
    void open(const PlanImage& image) { w.window.setPlan(image); }
    // As a site that lacks the file of its image.
    void openWithoutPixels() {
        w.window.desk().site().open(
            {.floors = {{.name = "Ground", .plans = {{.image_file = "/stick/photo.jpg"}}}}});
    }
    void press(Qt::Key key) { QTest::keyClick(&w.window, key); }
    SiteDesk& desk() { return w.window.desk(); }

    WindowUser w;
};

TEST_F(WorkThatIsRefused, SaysThatThePixelsOfAPhotoAreNotThere) {
    openWithoutPixels();
    for (const Qt::Key key : {Qt::Key_S, Qt::Key_A}) {
        press(key);
        EXPECT_FALSE(desk().open());
        EXPECT_TRUE(w.banner().contains("The pixels of photo.jpg are not there"))
            << w.banner().toStdString();
        w.button("Acknowledge")->click();
        EXPECT_EQ(w.banner(), QString());
    }
}

TEST_F(WorkThatIsRefused, SaysThatThePhotoBehindAFlatPlanIsNotThere) {
    openWithoutPixels();
    Site flat = desk().site().site();
    SitePlan& plan = flat.floors.front().plans.front();
    plan.straightened = Straightening{test::sheetInPhoto()};
    desk().site().edit(flat);
    desk().site().giveImage(plan, test::samplePlan());
    desk().straighten(0);
    EXPECT_FALSE(desk().open());
    EXPECT_TRUE(w.banner().contains("photo.jpg are not there")) << w.banner().toStdString();
}

TEST_F(WorkThatIsRefused, SaysThatAPhotoIsStillBeingLoaded) {
    PlanImage preview = test::photographedPlan();
    preview.levels.front().pixels.reset();
    open(preview);
    press(Qt::Key_S);
    EXPECT_FALSE(desk().open());
    EXPECT_TRUE(w.banner().contains("still being loaded")) << w.banner().toStdString();
}

TEST_F(WorkThatIsRefused, SaysThatAPlanIsLocked) {
    open(test::samplePlan());
    Site locked = desk().site().site();
    locked.floors.front().plans.front().locked = true;
    desk().site().edit(locked);
    press(Qt::Key_A);
    EXPECT_TRUE(w.banner().contains("ground-floor.png is locked")) << w.banner().toStdString();
}

TEST_F(WorkThatIsRefused, SaysThatThereIsNoPlanYet) {
    press(Qt::Key_S);
    EXPECT_TRUE(w.banner().contains("no plan yet")) << w.banner().toStdString();
}

}  // namespace
}  // namespace hedr
