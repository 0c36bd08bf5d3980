#include "core/calibration/squares/umbmark_calibration.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/core/calibration/squares/square_drives.h"

namespace hedr {
namespace {

UmbmarkCalibration calibrationOf(const DrivenSquares& driven) {
    return calibrateUmbmark(driven.sets, driven.ends, labmate());
}

UmbmarkCalibration calibrationOf(const SquareDrives& drives, std::uint64_t seed = 1) {
    Random random(seed);
    return calibrationOf(drive(drives, random));
}

bool mentions(const UmbmarkCalibration& umbmark, std::string_view words) {
    return std::ranges::any_of(umbmark.calibration.remarks, [words](const std::string& remark) {
        return remark.find(words) != std::string::npos;
    });
}

double figure(const UmbmarkCalibration& umbmark, std::string_view name) {
    const auto& figures = umbmark.calibration.figures;
    const auto found = std::ranges::find(figures, name, &EvidenceFigure::name);
    return found == figures.end() ? std::numeric_limits<double>::quiet_NaN() : found->value;
}

void expectRefused(const UmbmarkCalibration& umbmark, std::string_view words) {
    EXPECT_EQ(umbmark.calibration.verdict, Verdict::kRefused);
    EXPECT_NE(umbmark.calibration.reason.find(words), std::string::npos)
        << umbmark.calibration.reason;
}

TEST(UmbmarkCalibration, FindsTheWheelsAndProvesIt) {
    const UmbmarkCalibration umbmark = calibrationOf(SquareDrives{});
    const Calibration& calibration = umbmark.calibration;
    EXPECT_EQ(calibration.procedure, "umbmark");
    EXPECT_EQ(calibration.verdict, Verdict::kAccepted) << calibration.reason;
    EXPECT_NEAR(umbmark.ratios.diameter_ratio.value, 1.002, 0.0001);
    EXPECT_NEAR(umbmark.ratios.wheelbase_ratio.value, 1.005, 0.0005);
    const VehicleGeometry real = realWheels({});
    const VehicleGeometry found = calibrated(labmate(), calibration).value().geometry;
    EXPECT_NEAR(found.wheelbase_m, real.wheelbase_m, 2e-4);
    EXPECT_NEAR(found.left_wheel_diameter_m, real.left_wheel_diameter_m, 1e-5);
    EXPECT_NEAR(found.right_wheel_diameter_m, real.right_wheel_diameter_m, 1e-5);
    EXPECT_NEAR(found.left_wheel_diameter_m + found.right_wheel_diameter_m, 0.3, 1e-12);
    EXPECT_EQ(calibration.proof->parts, 10U);
    EXPECT_GT(calibration.proof->times_better, 10.0);
    EXPECT_GT(umbmark.largest_before_m, 10.0 * umbmark.largest_after_m);
    EXPECT_TRUE(mentions(umbmark, "do not tell the distance scale"));
}

TEST(UmbmarkCalibration, ShowsThePapersClosedFormAndWhereItIsTooShort) {
    const UmbmarkCalibration small = calibrationOf(SquareDrives{});
    EXPECT_NEAR(figure(small, "E_d, closed form"), 1.002, 0.0002);
    EXPECT_NEAR(figure(small, "E_b, closed form"), 1.005, 0.001);
    const UmbmarkCalibration large =
        calibrationOf({.diameter_ratio = 0.98, .wheelbase_ratio = 1.04});
    EXPECT_GT(std::abs(figure(large, "E_d, closed form") - 0.98), 0.005);
    EXPECT_NEAR(figure(large, "E_d, diameter right over left"), 0.98, 0.0001);
    EXPECT_TRUE(mentions(large, "closed form"));
}

TEST(UmbmarkCalibration, WorksOnSquaresDrivenAlongATape) {
    const UmbmarkCalibration umbmark =
        calibrationOf({.diameter_ratio = 1.01, .wheelbase_ratio = 1.35, .along_tape = true});
    EXPECT_EQ(umbmark.calibration.verdict, Verdict::kAccepted) << umbmark.calibration.reason;
    EXPECT_NEAR(umbmark.ratios.wheelbase_ratio.value, 1.35, 0.002);
    EXPECT_NEAR(umbmark.ratios.diameter_ratio.value, 1.01, 0.0005);
}

TEST(UmbmarkCalibration, NamesTheRunThatEndedFarAway) {
    Random random(1);
    DrivenSquares driven = drive({.unevenness_m_sqrtm = 1e-5, .tape_m = 0.001}, random);
    driven.ends[2].way.x += 0.14;
    const UmbmarkCalibration umbmark = calibrationOf(driven);
    EXPECT_EQ(umbmark.calibration.verdict, Verdict::kAccepted);
    EXPECT_TRUE(
        mentions(umbmark, "Run 3 (clockwise) ended 14 cm away from the others. It was left out."));
    EXPECT_EQ(umbmark.calibration.proof->parts, 9U);
}

TEST(UmbmarkCalibration, TellsWhatOneMoreRunGives) {
    const UmbmarkCalibration few =
        calibrationOf({.clockwise = 2, .counter_clockwise = 2, .unevenness_m_sqrtm = 1e-3});
    const CalibrationProgress& progress = few.calibration.progress;
    EXPECT_LT(progress.share, 1.0);
    EXPECT_GT(progress.share, 0.0);
    EXPECT_TRUE(progress.known.starts_with("Known so far: E_b ±")) << progress.known;
    EXPECT_TRUE(progress.more.starts_with("One more run gives ±")) << progress.more;
    const UmbmarkCalibration enough = calibrationOf(SquareDrives{});
    EXPECT_EQ(enough.calibration.progress.share, 1.0);
    EXPECT_TRUE(enough.calibration.progress.more.empty());
}

TEST(UmbmarkCalibration, LeadsFromStepToStep) {
    const auto next = [](const UmbmarkCalibration& umbmark) {
        const auto& steps = umbmark.calibration.steps;
        const auto step = std::ranges::find(steps, false, &CalibrationStep::done);
        return step == steps.end() ? std::string("done") : step->title;
    };
    EXPECT_EQ(next(calibrateUmbmark({}, {}, labmate())), "Mark the start");
    EXPECT_EQ(next(calibrationOf({.clockwise = 3, .counter_clockwise = 0})),
              "Drive 5 squares clockwise");
    EXPECT_EQ(next(calibrationOf({.clockwise = 5, .counter_clockwise = 4})),
              "Drive 5 counter-clockwise");
    Random random(2);
    DrivenSquares driven = drive({}, random);
    EXPECT_EQ(next(calibrationOf(driven)), "done");
    driven.ends.pop_back();
    EXPECT_EQ(next(calibrationOf(driven)), "Enter where it stopped");
}

TEST(UmbmarkCalibration, DrawsBothClustersOnOneScale) {
    const UmbmarkCalibration umbmark = calibrationOf(SquareDrives{});
    ASSERT_EQ(umbmark.calibration.plots.size(), 1U);
    const EvidencePlot& plot = umbmark.calibration.plots[0];
    EXPECT_TRUE(plot.same_scale);
    const auto series = [&plot](EvidenceSeries::Shape shape) {
        return *std::ranges::find(plot.series, shape, &EvidenceSeries::shape);
    };
    EXPECT_EQ(series(EvidenceSeries::Shape::kDots).name, "clockwise, 5 runs");
    EXPECT_EQ(series(EvidenceSeries::Shape::kDots).x.size(), 5U);
    EXPECT_EQ(series(EvidenceSeries::Shape::kSquares).name, "counter-clockwise, 5 runs");
    EXPECT_EQ(series(EvidenceSeries::Shape::kEllipse).name, "clockwise, 5 runs");
    EXPECT_EQ(
        std::ranges::count(plot.series, EvidenceSeries::Shape::kEllipse, &EvidenceSeries::shape),
        2);
}

TEST(UmbmarkCalibration, SaysSomethingSensibleWithoutAnything) {
    expectRefused(calibrateUmbmark({}, {}, labmate()), "No square has been driven yet.");
    Random random(1);
    const DrivenSquares driven = drive({}, random);
    expectRefused(calibrateUmbmark(driven.sets, {}, labmate()), "has to be measured");
    EXPECT_TRUE(mentions(calibrateUmbmark(driven.sets, {}, labmate()),
                         "No end is given for runs 1 to 10."));
}

TEST(UmbmarkCalibration, IsRefusedWithTooFewSquares) {
    expectRefused(calibrationOf({.clockwise = 1, .counter_clockwise = 5}),
                  "Two squares each way are the least");
}

// They were driven: whoever types one end after the other is not sent out again.
TEST(UmbmarkCalibration, AsksForEndsBeforeItAsksForSquares) {
    Random random(1);
    DrivenSquares driven = drive({}, random);
    std::erase_if(driven.ends, [](const UmbmarkEnd& end) { return end.run % 2 == 0; });
    const std::string reason = calibrationOf(driven).calibration.reason;
    EXPECT_NE(reason.find("Enter where run"), std::string::npos) << reason;
    EXPECT_EQ(reason.find("All squares were driven"), std::string::npos) << reason;
}

TEST(UmbmarkCalibration, IsRefusedWithSquaresOfOneDirection) {
    expectRefused(calibrationOf({.clockwise = 10, .counter_clockwise = 0}),
                  "All squares were driven clockwise.");
    expectRefused(calibrationOf({.clockwise = 0, .counter_clockwise = 10}),
                  "All squares were driven counter-clockwise.");
}

TEST(UmbmarkCalibration, IsRefusedWhereSquaresWereDrivenInTheWrongDirection) {
    Random random(1);
    DrivenSquares driven = drive({.clockwise = 10, .counter_clockwise = 0}, random);
    for (std::size_t i = 0; i < 10; ++i) {
        driven.ends[i].said = i < 5 ? Turning::kClockwise : Turning::kCounterClockwise;
    }
    const UmbmarkCalibration umbmark = calibrationOf(driven);
    expectRefused(umbmark, "All squares were driven clockwise.");
    EXPECT_TRUE(mentions(
        umbmark, "Run 6 turned clockwise by its encoders, but counter-clockwise was said."));
}

// Without the last square nothing tells a moved mark from wheels whose errors make up for each
// other clockwise.
TEST(UmbmarkCalibration, IsNotProvenWhereAMovedMarkWouldLookLikeOtherWheels) {
    SquareDrives drives{.in_turns = false};
    Random random(1);
    DrivenSquares driven = drive(drives, random);
    const UmbmarkCalibration honest = calibrationOf(driven);
    EXPECT_EQ(honest.calibration.verdict, Verdict::kNotProven);
    EXPECT_TRUE(honest.calibration.reason.ends_with("Drive one more clockwise square."))
        << honest.calibration.reason;
    EXPECT_NEAR(honest.ratios.wheelbase_ratio.value, 1.005, 0.0005);
}

TEST(UmbmarkCalibration, IsProvenByOneMoreSquareTheFirstWay) {
    Random random(2);
    DrivenSquares first =
        drive({.clockwise = 5, .counter_clockwise = 5, .in_turns = false}, random);
    DrivenSquares more = drive({.clockwise = 1, .counter_clockwise = 0}, random);
    more.sets[0].origin = "one more";
    more.ends[0].run = 11;
    first.sets.push_back(more.sets[0]);
    first.ends.push_back(more.ends[0]);
    EXPECT_EQ(calibrationOf(first).calibration.verdict, Verdict::kAccepted);
    for (std::size_t i = 5; i < 11; ++i) {
        first.ends[i].way = first.ends[i].way + Vector<Robot>{0.2, -0.2};
    }
    EXPECT_NE(calibrationOf(first).calibration.verdict, Verdict::kAccepted);
}

TEST(UmbmarkCalibration, IsRefusedWhereAllEndsAreTheSame) {
    Random random(1);
    DrivenSquares driven = drive({}, random);
    for (UmbmarkEnd& end : driven.ends) end.way = {0.1, 0.05};
    expectRefused(calibrationOf(driven),
                  "All clockwise squares have the same end: measure each to the millimetre.");
}

TEST(UmbmarkCalibration, IsUnchangedWhereARobotByItsOwnOdometryAlwaysCameBack) {
    Random random(1);
    DrivenSquares driven = drive({.diameter_ratio = 1.0, .wheelbase_ratio = 1.0}, random);
    for (UmbmarkEnd& end : driven.ends) end.way = {};
    EXPECT_NE(calibrationOf(driven).calibration.verdict, Verdict::kAccepted);
}

TEST(UmbmarkCalibration, IsRefusedWhereAxesAreMirrored) {
    Random random(1);
    DrivenSquares driven = drive({}, random);
    for (UmbmarkEnd& end : driven.ends) end.way.y = -end.way.y;
    const UmbmarkCalibration umbmark = calibrationOf(driven);
    EXPECT_FALSE(umbmark.directions_agree);
    expectRefused(umbmark, "do not want the same wheels");
}

TEST(UmbmarkCalibration, IsRefusedWhereEndsAreNotInMetres) {
    Random random(1);
    DrivenSquares driven = drive({}, random);
    for (UmbmarkEnd& end : driven.ends) end.way = 100.0 * end.way;
    const UmbmarkCalibration umbmark = calibrationOf(driven);
    EXPECT_EQ(umbmark.calibration.verdict, Verdict::kRefused);
    EXPECT_TRUE(mentions(umbmark, "Ends are in metres"));
}

// Ends of a centimetre or two, written as metres, could be true; not so their scatter.
TEST(UmbmarkCalibration, IsRefusedWhereEndsScatterAsNoRobotDoes) {
    Random random(1);
    DrivenSquares driven = drive({.diameter_ratio = 1.0, .wheelbase_ratio = 1.0}, random);
    for (UmbmarkEnd& end : driven.ends) end.way = 100.0 * end.way;
    expectRefused(calibrationOf(driven), "Whatever the wheels, ends are off by");
}

TEST(UmbmarkCalibration, TellsThatTheLastDriveHasNotEnded) {
    Random random(1);
    DrivenSquares driven = drive({}, random);
    driven.sets[0].reports.resize(driven.sets[0].reports.size() - 40);
    const UmbmarkCalibration umbmark = calibrationOf(driven);
    EXPECT_TRUE(mentions(umbmark, "The last drive has not ended: it is not counted."));
    EXPECT_EQ(umbmark.squares.size(), 9U);
}

TEST(UmbmarkCalibration, TellsOfEndsAndRunsThatDoNotGoTogether) {
    Random random(1);
    DrivenSquares driven = drive({}, random);
    std::ranges::reverse(driven.ends);  // the order does not matter
    driven.ends.front().run = 12;
    driven.ends.back().way.x = std::numeric_limits<double>::quiet_NaN();
    const UmbmarkCalibration umbmark = calibrationOf(driven);
    EXPECT_EQ(umbmark.calibration.verdict, Verdict::kAccepted);
    EXPECT_TRUE(mentions(umbmark, "No end is given for run 10."));
    EXPECT_TRUE(mentions(umbmark, "ends for run 12, which were not driven."));
    EXPECT_TRUE(mentions(umbmark, "Run 1 has an end that is no number. It was left out."));
}

TEST(UmbmarkCalibration, TakesTheLastEndOfARun) {
    Random random(1);
    DrivenSquares driven = drive({}, random);
    const UmbmarkCalibration once = calibrationOf(driven);
    UmbmarkEnd wrong = driven.ends[4];
    wrong.way.x += 1.0;
    driven.ends.insert(driven.ends.begin(), wrong);
    EXPECT_EQ(calibrationOf(driven).ratios.diameter_ratio, once.ratios.diameter_ratio);
}

TEST(UmbmarkCalibration, IsRefusedWithoutWheelsThatAreToldApart) {
    Random random(1);
    DrivenSquares driven = drive({}, random);
    for (SensorReport& report : driven.sets[0].reports) {
        report.odometry = PathTravel{report.robot_time_s};
    }
    expectRefused(calibrationOf(driven), "tell the left wheel from the right one");
}

}  // namespace
}  // namespace hedr
