#include "core/calibration/proof.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/calibration/calibration.h"
#include "core/simulation/random.h"

namespace hedr {
namespace {

// Held-out parts whose true errors are in the ratio `times_better`.
std::vector<HeldOutError> parts(Random& random, std::size_t n, double times_better) {
    std::vector<HeldOutError> errors;
    for (std::size_t i = 0; i < n; ++i)
        errors.push_back({times_better * random.normal(), random.normal()});
    return errors;
}

TEST(Proof, SaysHowManyTimesBetter) {
    Random random(1);
    const Proof proof = proofOf(parts(random, 400, 5.0), "error", "m");
    EXPECT_NEAR(proof.times_better, 5.0, 0.7);
    EXPECT_TRUE(proof.times_better_95.contains(5.0));
    EXPECT_TRUE(proof.better());
    EXPECT_FALSE(proof.worse());
}

TEST(Proof, NeedsFourParts) {
    const std::vector<HeldOutError> three(3, {1.0, 0.1});
    EXPECT_FALSE(proofOf(three, "error", "m").better());
    const std::vector<HeldOutError> four{{1.0, 0.1}, {1.1, 0.1}, {0.9, 0.1}, {1.0, 0.12}};
    EXPECT_TRUE(proofOf(four, "error", "m").better());
    EXPECT_FALSE(proofOf({}, "error", "m").better());
}

TEST(Proof, IsRarelyFoundWhereNothingIsBetter) {
    Random random(2);
    for (const std::size_t n : {4U, 6U, 10U, 30U}) {
        int found = 0;
        for (int trial = 0; trial < 4000; ++trial)
            found += proofOf(parts(random, n, 1.0), "error", "m").better() ? 1 : 0;
        EXPECT_LE(found, 4000 / 70) << n << " parts";
    }
}

TEST(Proof, TheIntervalHoldsTheTrueRatio) {
    Random random(3);
    for (const std::size_t n : {10U, 30U}) {
        int held = 0;
        for (int trial = 0; trial < 4000; ++trial) {
            held += proofOf(parts(random, n, 3.0), "e", "m").times_better_95.contains(3.0) ? 1 : 0;
        }
        EXPECT_GT(held, 4000 * 93 / 100) << n << " parts";
    }
}

TEST(Proof, BearsErrorsThatAreZero) {
    const std::vector<HeldOutError> perfect(5, {1.0, 0.0});
    EXPECT_GT(proofOf(perfect, "error", "m").times_better, 1e100);
    const std::vector<HeldOutError> nothing(5);
    EXPECT_FALSE(proofOf(nothing, "error", "m").better());
}

Calibration found(double was, double now, double standard_error, const Proof& proof) {
    return judged({.procedure = "test",
                   .found = {{"gyro_bias_rad_s", was, {now, standard_error, 20.0}}},
                   .proof = proof});
}

TEST(Calibration, IsAcceptedOnlyWhereItDiffersAndIsProven) {
    const Proof better =
        proofOf(std::vector<HeldOutError>{{1, .1}, {1.1, .1}, {.9, .1}, {1, .12}}, "error", "rad");
    EXPECT_EQ(found(0.0, 1.0, 0.1, better).verdict, Verdict::kAccepted);
    EXPECT_EQ(found(0.9, 1.0, 0.1, better).verdict, Verdict::kUnchanged);
    EXPECT_EQ(found(0.0, 1.0, 0.1, {}).verdict, Verdict::kNotProven);
    const Proof worse =
        proofOf(std::vector<HeldOutError>{{.1, 1}, {.1, 1.1}, {.1, .9}, {.12, 1}}, "error", "rad");
    EXPECT_EQ(found(0.0, 1.0, 0.1, worse).verdict, Verdict::kRefused);
    EXPECT_EQ(found(0.9, 1.0, 0.1, worse).verdict, Verdict::kUnchanged);
    EXPECT_EQ(found(0.0, NAN, 0.1, better).verdict, Verdict::kRefused);
    EXPECT_TRUE(found(0.0, 1.0, NAN, better).found.empty());
}

TEST(Calibration, GivesTheVehicleItsNewNumbers) {
    const Calibration calibration{.procedure = "test", .found = {{"wheelbase_m", 0.4, {0.5}}}};
    EXPECT_EQ(calibrated({}, calibration)->geometry.wheelbase_m, 0.5);
    const Calibration senseless{.procedure = "test", .found = {{"wheelbase_m", 0.4, {-0.5}}}};
    EXPECT_EQ(calibrated({}, senseless).error().code, ErrorCode::kBadValue);
}

TEST(Estimate, HasStudentsMargins) {
    EXPECT_NEAR((Estimate{0.0, 1.0}.margin()), 1.95996, 1e-5);
    EXPECT_NEAR((Estimate{0.0, 1.0, 4.0}.margin()), 2.77645, 1e-5);
    EXPECT_NEAR((Estimate{0.0, 2.0, 9.0}.margin(0.99)), 2.0 * 3.24984, 1e-4);
    EXPECT_TRUE((Estimate{3.0, 1.0, 4.0}.interval().contains(0.3)));
}

TEST(Estimate, IsNotKnownWhereItsErrorIsNot) {
    EXPECT_TRUE(std::isinf(Estimate{1.0, 1.0, 0.0}.margin()));
    EXPECT_TRUE(std::isinf(Estimate{1.0, 1.0, std::nan("")}.margin()));
    EXPECT_GT((Estimate{1.0, 1.0, 1e-3}.margin()), 1e100);
}

TEST(Estimate, MayReachFurtherUpThanDown) {
    const Estimate estimate = estimateWithin(5.0, {4.0, 8.0}, 9.0);
    EXPECT_NEAR(estimate.interval().low, 4.0, 1e-12);
    EXPECT_NEAR(estimate.interval().high, 8.0, 1e-12);
    EXPECT_NEAR(estimate.margin(), 2.0, 1e-12);
    EXPECT_GT(estimate.interval(0.99).high - 5.0, 3.0);
    EXPECT_TRUE(estimate.isNearerThan(2.0, 0.95));
    EXPECT_FALSE(estimate.isNearerThan(9.0, 0.95));
    EXPECT_EQ(estimateWithin(5.0, {5.0, 5.0}, 9.0).interval(), (Interval{5.0, 5.0}));
}

}  // namespace
}  // namespace hedr
