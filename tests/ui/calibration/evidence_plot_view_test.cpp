#include "ui/calibration/evidence_plot_view.h"

#include <gtest/gtest.h>

#include <QImage>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <limits>

#include "tests/ui/calibration/samples.h"
#include "ui/calibration/plot_frame.h"

namespace hedr {
namespace {

using Shape = EvidenceSeries::Shape;

QImage pictureOf(const EvidencePlot& plot, const Theme& theme = dayTheme()) {
    EvidencePlotView view;
    view.setTheme(theme);
    view.resize(640, 560);
    view.show(plot);
    QImage picture(view.size(), QImage::Format_RGB32);
    picture.fill(theme.chrome);
    view.render(&picture, {}, {}, {});
    return picture;
}

int pixels(const QImage& picture, const QColor& colour) {
    int count = 0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) count += picture.pixel(x, y) == colour.rgb();
    }
    return count;
}

EvidencePlot plotOf(Shape shape, std::vector<double> x, std::vector<double> y) {
    return {.title = "", .series = {{"a", shape, std::move(x), std::move(y)}}};
}

TEST(EvidencePlotView, ShowsMarksWhereTheyAre) {
    const EvidencePlot plot = plotOf(Shape::kDots, {0.0, 1.0, 2.0}, {0.0, 5.0, 1.0});
    const QImage picture = pictureOf(plot);
    const PlotFrame frame = plotFrame(plot, picture.size());
    for (std::size_t i = 0; i < 3; ++i) {
        const QPoint at(static_cast<int>(frame.x.pixelOf(plot.series[0].x[i])),
                        static_cast<int>(frame.y.pixelOf(plot.series[0].y[i])));
        EXPECT_EQ(picture.pixelColor(at), dayTheme().accent) << i;
    }
}

TEST(EvidencePlotView, AsksForSamplesWhereThereAreNone) {
    const double nan = std::nan("");
    EXPECT_FALSE(showsAnything({}));
    EXPECT_FALSE(showsAnything(plotOf(Shape::kLine, {1.0, nan}, {nan, 2.0})));
    EvidencePlot decades = plotOf(Shape::kLine, {1.0}, {-2.0});
    decades.y.logarithmic = true;
    EXPECT_FALSE(showsAnything(decades));
    EXPECT_GT(pixels(pictureOf(decades), dayTheme().dim), 50) << "a sentence";
}

TEST(EvidencePlotView, DrawsWhatCanBeDrawnOfBadNumbers) {
    const double infinity = std::numeric_limits<double>::infinity();
    const double nan = std::nan("");
    for (const Shape shape : {Shape::kLine, Shape::kDashes, Shape::kDots, Shape::kSquares,
                              Shape::kBand, Shape::kEllipse}) {
        for (const bool logarithmic : {false, true}) {
            EvidencePlot plot = plotOf(shape, {1.0, 2.0, nan, 4.0, 5.0, 6.0, 7.0},
                                       {1.0, infinity, 3.0, 2.0, 1e200, -1.0});
            plot.series[0].y_high = {2.0, nan, 3.0};
            plot.x.logarithmic = plot.y.logarithmic = logarithmic;
            plot.same_scale = true;
            ASSERT_TRUE(showsAnything(plot));
            EXPECT_FALSE(pictureOf(plot).isNull());
        }
    }
}

TEST(EvidencePlotView, ReadsBothAxesInOneUnitWhereTheyHaveOneScale) {
    EvidencePlot plot = plotOf(Shape::kDots, {0.0, 0.3}, {0.0, 0.02});
    plot.x.unit = plot.y.unit = "m";
    plot.same_scale = true;
    const PlotFrame frame = plotFrame(plot, {640, 560});
    EXPECT_EQ(frame.x_unit.name, "m");
    EXPECT_EQ(frame.y_unit.name, "m");
    EXPECT_NEAR(frame.x.pixelOf(0.1) - frame.x.pixelOf(0.0),
                frame.y.pixelOf(0.0) - frame.y.pixelOf(0.1), 1e-9);
}

TEST(EvidencePlotView, StaysWhereItIsWhileSamplesComeInBetween) {
    EvidencePlot plot = plotOf(Shape::kDots, {0.0, 10.0}, {0.013, 0.987});
    const PlotFrame before = plotFrame(plot, {640, 560});
    plot.series[0].x.insert(plot.series[0].x.end(), {3.0, 9.9});
    plot.series[0].y.insert(plot.series[0].y.end(), {0.5, 0.99});
    const PlotFrame after = plotFrame(plot, {640, 560});
    EXPECT_EQ(before.area, after.area);
    EXPECT_EQ(before.y.high, after.y.high);
}

TEST(EvidencePlotView, ReadsAnAllanDeviationInDegreesAnHour) {
    const PlotFrame frame = plotFrame(test::allanPlot(), {640, 560});
    EXPECT_EQ(frame.y_unit.name, "°/h");
    EXPECT_EQ(frame.x_unit.name, "s") << "in its middle";
}

TEST(EvidencePlotView, ShowsALineUponACloud) {
    EvidencePlot plot = plotOf(Shape::kDots, {}, {});
    for (int i = 0; i < 20'000; ++i) {
        plot.series[0].x.push_back(i);
        plot.series[0].y.push_back(std::sin(1e4 * std::sin(i)));
    }
    plot.series.push_back({"model", Shape::kLine, {0.0, 20'000.0}, {0.1, 0.1}});
    std::swap(plot.series[0], plot.series[1]);
    EXPECT_GT(pixels(pictureOf(plot), dayTheme().accent), 500);
}

// A hundred thousand samples: noise, or a drive that goes round and round.
EvidencePlot manySamples(Shape shape, bool goes_round) {
    EvidencePlot plot = plotOf(shape, {}, {});
    EvidenceSeries& series = plot.series.front();
    for (int i = 0; i < 100'000; ++i) {
        const double noise = std::sin(1e4 * std::sin(1.0 * i));
        const double radius = 1.0 + 1e-5 * i;
        series.x.push_back(goes_round ? radius * std::cos(1e-3 * i) : 0.01 * i);
        series.y.push_back(goes_round ? radius * std::sin(1e-3 * i) : noise);
        series.y_high.push_back(noise + 2.0);
    }
    return plot;
}

// Of the processor, best of five.
double paintingTime_ms(const EvidencePlot& plot) {
    EvidencePlotView view;
    view.resize(700, 640);
    view.show(plot);
    QImage picture(view.size(), QImage::Format_RGB32);
    double best_ms = 1e9;
    for (int i = 0; i < 5; ++i) {
        const std::clock_t before = std::clock();
        view.render(&picture);
        best_ms =
            std::min(best_ms, 1e3 * static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC);
    }
    return best_ms;
}

// The figure counts where the code is optimised.
TEST(EvidencePlotView, DISABLED_DrawsAHundredThousandSamplesWithinAFrame) {
    for (const Shape shape :
         {Shape::kLine, Shape::kDashes, Shape::kDots, Shape::kSquares, Shape::kBand}) {
        const double noise_ms = paintingTime_ms(manySamples(shape, false));
        const double drive_ms = paintingTime_ms(manySamples(shape, true));
        std::printf("shape %d: noise %.1f ms, drive %.1f ms\n", static_cast<int>(shape), noise_ms,
                    drive_ms);
        EXPECT_LT(noise_ms, 16.0);
        if (shape == Shape::kBand) continue;  // which always goes right
        EXPECT_LT(drive_ms, 16.0);
    }
}

}  // namespace
}  // namespace hedr
