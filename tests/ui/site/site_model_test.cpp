#include "ui/site/site_model.h"

#include <gtest/gtest.h>

#include "tests/ui/scene.h"

namespace hedr {
namespace {

TEST(SiteModel, TakesTwoPagesOfAFileForTwoPlans) {
    SiteModel site;
    const PlanImage image = test::samplePlan();
    EXPECT_TRUE(site.addImage(image, 1));
    EXPECT_TRUE(site.addImage(image, 2));
    EXPECT_FALSE(site.addImage(image, 2));
    ASSERT_EQ(site.floor().plans.size(), 2U);
    EXPECT_EQ(site.floor().plans.back().page, 2);
}

TEST(SiteModel, WithdrawsAnImageThatNeverCameWhole) {
    SiteModel site;
    const PlanImage image = test::samplePlan();
    site.addImage(image, 1);
    site.addImage(image, 2);
    site.withdrawImage(image.image_file, 2, 0);
    ASSERT_EQ(site.floor().plans.size(), 1U);
    EXPECT_EQ(site.floor().plans.front().page, 1);
    EXPECT_EQ(site.image({.image_file = image.image_file, .page = 2}), nullptr);
}

TEST(SiteModel, RemembersNoStepOfAnImageThatNeverCameWhole) {
    SiteModel site;
    const PlanImage image = test::samplePlan();
    site.addImage(image, 1);
    const Site before = site.site();
    site.addImage(image, 2);
    Site renamed = site.site();
    renamed.floors.front().name = "Cellar";
    site.edit(renamed);
    site.withdrawImage(image.image_file, 2, 0);
    EXPECT_EQ(site.floor().name, "Cellar");
    site.undo();
    EXPECT_EQ(site.site(), before);
    site.undo();
    EXPECT_TRUE(site.floor().plans.empty());
}

TEST(SiteModel, WithdrawsAnImageFromItsFloorOnly) {
    SiteModel site;
    const PlanImage image = test::samplePlan();
    site.addImage(image);
    Site next = site.site();
    next.floors.push_back({.name = "Floor 2"});
    site.edit(next);
    site.showFloor(1);
    site.addImage(image);
    site.withdrawImage(image.image_file, 1, 1);
    EXPECT_TRUE(site.floor().plans.empty());
    EXPECT_EQ(site.site().floors.front().plans.size(), 1U);
}

}  // namespace
}  // namespace hedr
