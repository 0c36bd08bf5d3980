#include "ui/link/link_plot.h"

#include <gtest/gtest.h>

#include <QImage>

namespace hedr {
namespace {

// How many pixels of the first strip have the alarm's colour.
int alarmed(const std::vector<LinkSample>& samples, double span_s, bool counts_loss = true) {
    LinkPlot plot;
    plot.setTheme(dayTheme());
    plot.resize(340, plot.height());
    plot.show(samples, span_s, counts_loss);
    QImage picture(plot.size(), QImage::Format_RGB32);
    plot.render(&picture);
    int count = 0;
    for (int y = 0; y < plot.height() / 3; ++y) {
        for (int x = 0; x < plot.width(); ++x) {
            count += picture.pixelColor(x, y) == dayTheme().alarm ? 1 : 0;
        }
    }
    return count;
}

TEST(LinkPlot, ShowsTheWorstSecondOfAPixel) {
    std::vector<LinkSample> samples;
    for (int i = 0; i < 28'800; ++i) samples.push_back({.receive_time_s = 1.0 * i});
    EXPECT_EQ(alarmed(samples, 28'800.0), 0);
    samples[14'000].loss = 0.6;
    EXPECT_GT(alarmed(samples, 28'800.0), 20) << "a second of eight hours";
    EXPECT_EQ(alarmed(samples, 60.0), 0) << "long ago";
}

TEST(LinkPlot, ShowsNoLossOfARobotThatDoesNotNumberWhatItSays) {
    const std::vector<LinkSample> samples(60, {.receive_time_s = 1.0, .loss = 0.5});
    EXPECT_GT(alarmed(samples, 60.0), 0);
    EXPECT_EQ(alarmed(samples, 60.0, false), 0);
}

TEST(LinkPlot, StaysWithinItsStripWhereAClockWentBack) {
    std::vector<LinkSample> samples;
    for (int i = 0; i < 600; ++i) samples.push_back({.receive_time_s = 1.0 * i, .loss = 0.5});
    for (int i = 0; i < 5; ++i) samples.push_back({.receive_time_s = 1.0 * i, .loss = 0.5});
    for (const double span_s : {60.0, 600.0, 3600.0}) EXPECT_GT(alarmed(samples, span_s), 0);
}

}  // namespace
}  // namespace hedr
