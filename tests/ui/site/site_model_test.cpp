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
    site.withdrawImage(image.image_file, 2);
    ASSERT_EQ(site.floor().plans.size(), 1U);
    EXPECT_EQ(site.floor().plans.front().page, 1);
}

}  // namespace
}  // namespace hedr
