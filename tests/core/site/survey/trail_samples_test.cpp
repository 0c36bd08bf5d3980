#include "core/site/survey/trail_samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace hedr {
namespace {

std::vector<Point<World>> corner() { return {{3.0, 0.0}, {23.0, 0.0}, {23.0, 20.0}}; }

TEST(TrailSamples, LieEvenlyAlongTheWayHoweverFewThePoints) {
    const TrailSamples sampled = sampleTrail(corner()).value();
    EXPECT_NEAR(static_cast<double>(sampled.samples.size()), 40.0 / 0.25, 5.0);
    for (std::size_t i = 1; i < sampled.samples.size(); ++i) {
        const TrailSample& one = sampled.samples[i - 1];
        const TrailSample& next = sampled.samples[i];
        EXPECT_NEAR((next.from_middle - one.from_middle).length(), 0.25, 0.1) << i;
        EXPECT_NEAR(next.direction.length(), 1.0, 1e-12) << i;
    }
}

TEST(TrailSamples, AreAboutTheirMiddle) {
    const TrailSamples sampled = sampleTrail(corner()).value();
    EXPECT_NEAR(sampled.middle.x, 18.0, 0.2);
    EXPECT_NEAR(sampled.middle.y, 5.0, 0.2);
    const Point<World> newest = sampled.middle + sampled.samples.front().from_middle;
    EXPECT_NEAR(newest.x, 23.0, 1e-9);
    EXPECT_NEAR(newest.y, 20.0, 1e-9);
    EXPECT_NEAR(std::abs(sampled.samples.front().direction.y), 1.0, 1e-9);
}

TEST(TrailSamples, OfALongTrailAreTheNewest) {
    std::vector<Point<World>> trail{{-90000.0, 5.0}};
    const auto end = corner();
    trail.insert(trail.end(), end.begin(), end.end());
    const TrailSamples sampled = sampleTrail(trail).value();
    EXPECT_LE(sampled.samples.size(), 1601U);
    for (const TrailSample& sample : sampled.samples) {
        EXPECT_GT((sampled.middle + sample.from_middle).x, -361.0);
    }
}

TEST(TrailSamples, CountAWayOnceThoughDrivenTwice) {
    auto twice = corner();
    twice.push_back({23.0, 0.0});
    twice.push_back({3.0, 0.0});
    EXPECT_NEAR(static_cast<double>(sampleTrail(twice).value().samples.size()),
                static_cast<double>(sampleTrail(corner()).value().samples.size()), 12.0);
}

TEST(TrailSamples, AreThinnedEvenly) {
    const std::vector<TrailSample> samples(1000);
    EXPECT_EQ(thinned(samples, 1000).size(), 1000U);
    EXPECT_EQ(thinned(samples, 200).size(), 200U);
    EXPECT_EQ(thinned(samples, 999).size(), 500U);
    EXPECT_TRUE(thinned({}, 10).empty());
}

}  // namespace
}  // namespace hedr
