#include <gtest/gtest.h>

#include <QPainter>
#include <cmath>
#include <random>

#include "core/geometry/angle.h"
#include "tests/ui/golden_image.h"
#include "tests/ui/scene.h"
#include "ui/map/base_image.h"
#include "ui/map/marks.h"
#include "ui/map/plan_layer.h"
#include "ui/map/robot_symbol.h"
#include "ui/trail_style.h"

namespace hedr {
namespace {

ViewTransform viewOf(const PlanImage& plan, double rotation_rad) {
    const ViewTransform view{{}, 1.0, rotation_rad, 480.0, 320.0};
    return view.fitted(planBounds(plan), {10, 10, 10, 10});
}

MapScene sceneOf(ThemeName theme) {
    LiveModel model;
    model.apply(test::sampleBatch(test::kDrive_s), test::atSecond(test::kDrive_s));
    MapScene scene{{{test::samplePlan()}}, {}, themeOf(theme)};
    for (auto trail = model.trails().rbegin(); trail != model.trails().rend(); ++trail) {
        const bool primary = &*trail == model.primary();
        scene.trails.push_back({*trail, trailPen(trail->name, primary, scene.theme)});
    }
    return scene;
}

TEST(MapLayers, DrawPlanAndTrailsByDay) {
    const MapScene scene = sceneOf(ThemeName::kDay);
    test::expectGolden("base-day",
                       renderBase(scene, viewOf(scene.plans.front().image, 0.0), 1.0).image);
}

TEST(MapLayers, DrawPlanAndTrailsByNight) {
    const MapScene scene = sceneOf(ThemeName::kNight);
    test::expectGolden("base-night",
                       renderBase(scene, viewOf(scene.plans.front().image, 0.0), 1.0).image);
}

TEST(MapLayers, DrawATurnedPlan) {
    const MapScene scene = sceneOf(ThemeName::kDay);
    test::expectGolden("base-turned",
                       renderBase(scene, viewOf(scene.plans.front().image, 0.4), 1.0).image);
}

TEST(MapLayers, TurnTheLightnessOfAColouredPlanOverAtNight) {
    const MapScene scene{{{test::colouredPlan()}}, {}, nightTheme()};
    test::expectGolden("plan-coloured-night",
                       renderBase(scene, viewOf(scene.plans.front().image, 0.0), 1.0).image);
}

// The picture of one plan, drawn as `change` says.
template <class Change>
QImage pictureOf(const Theme& theme, Change change) {
    MapScene scene{{{test::samplePlan()}}, {}, theme};
    change(scene.plans.front());
    return renderBase(scene, viewOf(scene.plans.front().image, 0.0), 1.0).image;
}

int pixelsOf(const QImage& image, const QColor& colour) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) count += image.pixel(x, y) == colour.rgb();
    }
    return count;
}

TEST(MapLayers, LetTheGroundThroughAPlanThatIsNotOpaque) {
    const Theme day = dayTheme();
    const QImage opaque = pictureOf(day, [](MapPlan&) {});
    const QImage faint = pictureOf(day, [](MapPlan& plan) { plan.opacity = 0.25; });
    EXPECT_GT(pixelsOf(opaque, day.paper), 50'000);
    EXPECT_EQ(pixelsOf(faint, day.paper), 0);
    const QColor ground = faint.pixelColor(240, 160);
    EXPECT_NEAR(ground.red(), 0.75 * day.background.red() + 0.25 * day.paper.red(), 2.0);
}

TEST(MapLayers, ShowOnlyWhatACropLeaves) {
    const Theme day = dayTheme();
    const QImage whole = pictureOf(day, [](MapPlan&) {});
    const QImage half = pictureOf(day, [](MapPlan& plan) {
        plan.crop = PlanCrop{{0.0, 0.0}, {800.0, 980.0}};
    });
    EXPECT_NEAR(pixelsOf(half, day.paper), pixelsOf(whole, day.paper) / 2, 2'500);
    EXPECT_EQ(half.pixelColor(400, 160), day.background);
}

TEST(MapLayers, LeaveAPhotoLightAtNight) {
    const Theme night = nightTheme();
    const QImage photo = pictureOf(night, [](MapPlan& plan) { plan.inverted_at_night = false; });
    EXPECT_GT(pixelsOf(photo, dayTheme().paper), 50'000);
    EXPECT_EQ(pixelsOf(photo, night.paper), 0);
}

TEST(MapLayers, DrawEveryKindOfTrailInItsOwnWay) {
    MapScene scene{{}, {}, dayTheme()};
    double y = 0.0;
    const auto add = [&](const char* name, bool primary) {
        Track track;
        for (int i = 0; i <= 200; ++i) track.append({0.1 * i, {{0.1 * i, y}, 0.0}, 0.0});
        scene.trails.push_back({{name, track}, trailPen(name, primary, scene.theme)});
        y += 1.0;
    };
    add("hedr_bayes", true);
    for (const TrailStyle& style : trailStyles()) add(style.name, false);
    const ViewTransform view{{10.0, (y - 1.0) / 2.0}, 20.0, 0.0, 480.0, 20.0 * (y + 1.0)};
    test::expectGolden("trails", renderBase(scene, view, 1.0).image);
}

class Marks : public testing::TestWithParam<ThemeName> {};

TEST_P(Marks, StandOutFromTheMap) {
    const Theme theme = themeOf(GetParam());
    QImage image(480, 320, QImage::Format_RGB32);
    image.fill(theme.background);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    double x = 60.0;
    for (const LinkState state : {LinkState::kLive, LinkState::kStale, LinkState::kLost}) {
        drawRobot(painter, {{x, 60.0}, 0.6, 48.0, state}, theme);
        x += 90.0;
    }
    drawHome(painter, {340.0, 60.0}, theme);
    drawSpread(painter, {{60.0, 60.0}, 50.0, 24.0, 0.5}, theme.accent);
    drawReach(painter, {{110.0, 220.0}, 50.0, "could be here"}, {QRectF(0, 0, 480, 320)},
              theme.warning, theme);
    drawDial(painter, {200.0, 280.0}, 0.0, Needle{1.0, LinkState::kStale}, theme);
    drawDial(painter, {280.0, 200.0}, 0.0, Needle{1.0}, theme);
    drawDial(painter, {380.0, 200.0}, 0.0, Needle{1.0, LinkState::kLost}, theme);
    drawScaleBar(painter, {460.0, 300.0}, scaleBar(20.0, 120.0), theme);
    drawEdgePointer(painter, {{900.0, 60.0}, 0.0, 0.0, LinkState::kLive}, QRectF(0, 0, 440, 320),
                    theme);
    drawStaleFrame(painter, image.rect(), theme.warning);
    painter.end();
    test::expectGolden(GetParam() == ThemeName::kDay ? "marks-day" : "marks-night", image);
}

INSTANTIATE_TEST_SUITE_P(Both, Marks, testing::Values(ThemeName::kDay, ThemeName::kNight));

TEST(PlanLayer, MakesAWhitePlanDarkWithLightWallsAtNight) {
    const Theme night = nightTheme();
    const PlanColours colours = planColours(night);
    EXPECT_EQ(colours[255], night.paper.rgb());
    EXPECT_EQ(colours[0], night.wall.rgb());
    EXPECT_EQ(themedColour(qRgb(255, 255, 255), night), night.paper.rgb());
    EXPECT_EQ(themedColour(qRgb(0, 0, 0), night), night.wall.rgb());
    EXPECT_EQ(themedColour(qRgb(12, 200, 90), dayTheme()), qRgb(12, 200, 90));
}

TEST(PlanLayer, KeepsGreyLabelsReadableAtNight) {
    const Theme night = nightTheme();
    for (const QRgb day : {qRgb(0x99, 0xA2, 0xA8), qRgb(0xA0, 0xA0, 0xA0)}) {
        EXPECT_GE(contrastRatio(themedColour(day, night), night.paper), 4.5);
        EXPECT_GE(
            contrastRatio(planColours(night)[static_cast<std::size_t>(qGray(day))], night.paper),
            4.5);
    }
    EXPECT_EQ(themedColour(qRgb(0xFA, 0xFB, 0xF8), night), night.paper.rgb()) << "even paper";
    EXPECT_GE(qGray(planColours(night)[0x3A]), qGray(night.wall.rgb()) - 3);
}

TEST(ReachLabel, LiesWhereNoCardAndNoRobotIs) {
    const QRectF inside(100, 40, 800, 400);
    const QSizeF size(220, 20);
    const Reach reach{{500.0, 200.0}, 60.0, {}};
    EXPECT_LT(reachLabelRect(reach, size, {inside}).bottom(), 140.0);
    const LabelRoom banner{inside, QRect(200, 40, 600, 130)};
    const QRectF below = reachLabelRect(reach, size, banner);
    EXPECT_GT(below.top(), 260.0);
    LabelRoom narrow = banner;
    narrow.covered += QRect(200, 230, 600, 300);
    EXPECT_GT(reachLabelRect(reach, size, narrow).left(), 560.0);
    for (double y = 60.0; y < 440.0; y += 20.0) {
        const QRectF at = reachLabelRect({{500.0, y}, 300.0, {}}, size, banner);
        EXPECT_TRUE(inside.contains(at)) << y;
        EXPECT_FALSE(banner.covered.intersects(at.toAlignedRect())) << y;
        EXPECT_FALSE(at.contains(QPointF(500.0, y))) << y;
    }
}

TEST(PlanLayer, ShowsTheSamePlaceFromEveryLevelOfThePyramid) {
    const PlanImage plan = test::samplePlan();
    const MapScene scene{{{plan}}, {}, dayTheme()};
    for (const double pixels_per_metre : {20.0, 10.0, 5.0, 2.5}) {
        // The middle of the outer wall is at 0.3 m.
        const double half_pixel_m = 0.5 / pixels_per_metre;
        const ViewTransform view{{0.3 - half_pixel_m, 25.0}, pixels_per_metre, 0.0, 200.0, 100.0};
        const QImage image = renderBase(scene, view, 1.0).image;
        EXPECT_LT(qGray(image.pixel(100, 50)), 160) << pixels_per_metre;
        EXPECT_GT(qGray(image.pixel(100 + static_cast<int>(pixels_per_metre), 50)), 240)
            << pixels_per_metre;
    }
}

TEST(Spread, IsTheEllipseOfTwoStandardDeviations) {
    const ViewTransform view{{}, 10.0, 0.0, 480.0, 320.0};
    const Spread along_y = spreadOf({0.25F, 0.0F, 4.0F, 0.0F}, {1.0, 2.0}, view);
    EXPECT_NEAR(along_y.major_px, 40.0, 1e-9);
    EXPECT_NEAR(along_y.minor_px, 10.0, 1e-9);
    EXPECT_NEAR(std::abs(along_y.angle_rad), kPi / 2.0, 1e-9);
    EXPECT_EQ(along_y.centre, view.viewFromWorld() * (Point<World>{1.0, 2.0}));
    const Spread diagonal = spreadOf({2.5F, 1.5F, 2.5F, 0.0F}, {}, view);
    EXPECT_NEAR(diagonal.major_px, 40.0, 1e-9);
    EXPECT_NEAR(diagonal.minor_px, 20.0, 1e-9);
    EXPECT_NEAR(diagonal.angle_rad, kPi / 4.0, 1e-9);
    const ViewTransform turned{{}, 10.0, 0.3, 480.0, 320.0};
    EXPECT_NEAR(spreadOf({2.5F, 1.5F, 2.5F, 0.0F}, {}, turned).angle_rad, kPi / 4.0 + 0.3, 1e-9);
    EXPECT_EQ(spreadOf({1.0F, 1.0F, 1.0F, 0.0F}, {}, view).minor_px, 0.0) << "not NaN";
}

TEST(Spread, IsDrawnOnlyWhereItFitsIntoTheView) {
    const QSizeF view_px(480.0, 320.0);
    EXPECT_TRUE(fitsInto({{}, 160.0, 20.0, 0.0}, view_px));
    EXPECT_FALSE(fitsInto({{}, 161.0, 20.0, 0.0}, view_px));
    const ViewTransform view{{}, 10.0, 0.0, 480.0, 320.0};
    EXPECT_FALSE(fitsInto(spreadOf({3e38F, 0.0F, 3e38F, 0.0F}, {}, view), view_px));
}

TEST(ScaleBar, IsTheLongestRoundLengthThatFits) {
    EXPECT_DOUBLE_EQ(scaleBar(20.0, 180.0).length_m, 5.0);
    EXPECT_DOUBLE_EQ(scaleBar(14.0, 180.0).length_m, 10.0);
    for (double scale = 0.03; scale < 2000.0; scale *= 1.3) {
        const ScaleBar bar = scaleBar(scale, 180.0);
        EXPECT_LE(bar.length_px, 180.0 + 1e-9);
        EXPECT_GT(bar.length_px, 180.0 / 2.6);
    }
}

int differentPixels(const QImage& a, const QImage& b) {
    int different = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            different += std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y))) > 90 ? 1 : 0;
        }
    }
    return different;
}

TEST(TrailLayer, GoesOnWhereTheBaseImageEnds) {
    Track track;
    for (int i = 0; i <= 400; ++i) {
        track.append({0.1 * i, {{0.05 * i, std::sin(0.05 * i)}, 0.0}, 0.0});
    }
    Track half;
    for (std::size_t i = 0; i <= 200; ++i) half.append(track.at(i));
    const ViewTransform view{{10.0, 0.0}, 20.0, 0.0, 480.0, 160.0};
    const QPen pen = trailPen("odometry", false, dayTheme());
    const auto drawn = [&](bool in_two_parts) {
        QImage image(480, 160, QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        painter.setRenderHint(QPainter::Antialiasing);
        const TrailEnd end = drawTrail(painter, in_two_parts ? half : track, pen, view);
        if (in_two_parts) drawTrailTail(painter, track, pen, view, end, view.pixels_per_metre);
        return image;
    };
    EXPECT_LT(differentPixels(drawn(false), drawn(true)), 60);
}

// There and back, spins on the spot, standing with a little noise: what a robot does in a corridor.
Track restlessDrive() {
    std::mt19937 random(1);
    std::normal_distribution<double> noise_m(0.0, 0.002);
    Track track;
    Point<World> at{};
    double heading_rad = 0.0;
    for (int i = 0; i < 1000; ++i) {
        const int phase = i / 50 % 5;
        const double step_m = phase == 1 ? -0.02 : phase == 2 || phase == 3 ? 0.0 : 0.02;
        heading_rad += phase == 2 ? 0.05 : phase == 4 ? 0.01 : 0.0;
        at = at + Vector<World>{step_m * std::cos(heading_rad), step_m * std::sin(heading_rad)};
        track.append({0.01 * i, {at + Vector<World>{noise_m(random), noise_m(random)}, 0.0}, 0.0});
    }
    return track;
}

TEST(TrailLayer, DrawsATailLikeTheTrailItself) {
    const Track track = restlessDrive();
    const QPen pen = trailPen("hedr_bayes", true, dayTheme());
    const ViewTransform view =
        ViewTransform{{}, 1.0, 0.0, 640.0, 480.0}.fitted(track.bounds(), {20, 20, 20, 20});
    const auto drawn = [&](bool as_tail) {
        QImage image(640, 480, QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        painter.setRenderHint(QPainter::Antialiasing);
        if (as_tail) {
            drawTrailTail(painter, track, pen, view, {}, view.pixels_per_metre);
        } else {
            drawTrail(painter, track, pen, view);
        }
        return image;
    };
    EXPECT_LT(differentPixels(drawn(false), drawn(true)), 10);
}

TEST(BaseImage, TakesInWhatHasComeOfATrail) {
    const Track track = restlessDrive();
    LiveTrail trail{"hedr_bayes", {}};
    for (std::size_t i = 0; i < 400; ++i) trail.track.append(track.at(i));
    const QPen pen = trailPen(trail.name, true, dayTheme());
    const ViewTransform view =
        ViewTransform{{}, 1.0, 0.0, 640.0, 480.0}.fitted(track.bounds(), {20, 20, 20, 20});
    MapScene scene{{}, {{trail, pen}}, dayTheme()};
    BaseImage grown = renderBase(scene, view, 2.0);
    for (std::size_t i = 400; i < track.size(); ++i) {
        scene.trails.front().trail.track.append(track.at(i));
        if (i % 100 == 99) growBase(grown, scene.trails.front().trail, pen, kFirstRobot);
    }
    growBase(grown, {"another", {}}, pen, kFirstRobot);
    EXPECT_EQ(grown.grown_points, 600U);
    const BaseImage whole = renderBase(scene, view, 2.0);
    EXPECT_EQ(grown.trails.front().end.points, whole.trails.front().end.points);
    // Of 1.2 million: a few at each of the six joints.
    EXPECT_LT(differentPixels(grown.image, whole.image), 100);
}

}  // namespace
}  // namespace hedr
