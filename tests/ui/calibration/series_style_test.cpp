#include "ui/calibration/series_style.h"

#include <gtest/gtest.h>

namespace hedr {
namespace {

using Shape = EvidenceSeries::Shape;

EvidencePlot plotOf(std::vector<EvidenceSeries> series) {
    return {.title = "", .series = std::move(series)};
}

TEST(SeriesStyle, GivesSeriesOfOneNameOneColourAndOneEntry) {
    const EvidencePlot plot = plotOf({{.name = "clockwise", .shape = Shape::kEllipse},
                                      {.name = "clockwise", .shape = Shape::kDots},
                                      {.name = "", .shape = Shape::kDashes},
                                      {.name = "back", .shape = Shape::kSquares}});
    const auto styles = seriesStyles(plot, dayTheme());
    ASSERT_EQ(styles.size(), 4U);
    EXPECT_EQ(styles[1].colour, styles[0].colour);
    EXPECT_EQ(styles[2].colour, styles[0].colour);
    EXPECT_NE(styles[3].colour, styles[0].colour);
    const auto entries = legendEntries(plot, dayTheme());
    ASSERT_EQ(entries.size(), 2U);
    EXPECT_EQ(entries[0].shape, Shape::kDots) << "marks tell more than a field";
    EXPECT_EQ(entries[1].name, "back");
}

TEST(SeriesStyle, TellsSeriesOfOneShapeApartWithoutTheirColour) {
    const EvidencePlot plot = plotOf({{.name = "a", .shape = Shape::kLine},
                                      {.name = "b", .shape = Shape::kLine},
                                      {.name = "c", .shape = Shape::kDashes},
                                      {.name = "d", .shape = Shape::kDashes},
                                      {.name = "e", .shape = Shape::kLine}});
    const auto styles = seriesStyles(plot, dayTheme());
    for (std::size_t i = 0; i < styles.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            EXPECT_NE(linePen(styles[i]).dashPattern(), linePen(styles[j]).dashPattern())
                << i << " and " << j;
        }
    }
}

TEST(SeriesStyle, HasColoursThatAreSeenOnACard) {
    std::vector<EvidenceSeries> series;
    for (int i = 0; i < 7; ++i)
        series.push_back({.name = std::to_string(i), .shape = Shape::kLine});
    for (const Theme& theme : {dayTheme(), nightTheme()}) {
        for (const SeriesStyle& style : seriesStyles(plotOf(series), theme)) {
            EXPECT_GE(contrastRatio(style.colour, theme.chrome), 3.0) << style.name.toStdString();
        }
    }
}

}  // namespace
}  // namespace hedr
