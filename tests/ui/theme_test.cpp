#include "ui/theme.h"

#include <gtest/gtest.h>

#include "ui/trail_style.h"

namespace hedr {
namespace {

class EveryTheme : public testing::TestWithParam<ThemeName> {
  protected:
    const Theme theme = themeOf(GetParam());
};

TEST_P(EveryTheme, ShowsDataWithAContrastOfSeven) {
    for (const QColor& below : {theme.background, theme.paper, theme.chrome, theme.chip}) {
        EXPECT_GE(contrastRatio(theme.ink, below), 7.0) << below.name().toStdString();
    }
}

TEST_P(EveryTheme, ShowsControlsAndStatesWithAContrastOfFourAndAHalf) {
    for (const QColor& below : {theme.paper, theme.chrome, theme.chip}) {
        for (const QColor& colour :
             {theme.dim, theme.good, theme.warning, theme.alarm, theme.accent}) {
            EXPECT_GE(contrastRatio(colour, below), 4.5)
                << colour.name().toStdString() << " on " << below.name().toStdString();
        }
    }
}

TEST_P(EveryTheme, ShowsTrailsAndWallsWithAContrastOfThree) {
    for (const TrailStyle& style : trailStyles()) {
        EXPECT_GE(contrastRatio(theme.*style.colour, theme.paper), 3.0) << style.name;
        EXPECT_GE(contrastRatio(theme.*style.colour, theme.background), 3.0) << style.name;
    }
    EXPECT_GE(contrastRatio(theme.wall, theme.paper), 3.0);
}

INSTANTIATE_TEST_SUITE_P(Both, EveryTheme, testing::Values(ThemeName::kDay, ThemeName::kNight));

TEST(Theme, MeasuresContrastAsTheGuidelinesDo) {
    EXPECT_NEAR(contrastRatio(Qt::black, Qt::white), 21.0, 1e-6);
    EXPECT_NEAR(contrastRatio(QColor("#777777"), Qt::white), 4.48, 0.01);
    EXPECT_EQ(contrastRatio(Qt::red, Qt::red), 1.0);
}

TEST(TrailStyle, TellsEveryTrailByItsDashesToo) {
    for (const TrailStyle& a : trailStyles()) {
        EXPECT_FALSE(a.dashes.empty()) << a.name << " looks like the primary one";
        for (const TrailStyle& b : trailStyles()) {
            if (&a == &b) continue;
            EXPECT_NE(a.dashes, b.dashes) << a.name << " and " << b.name;
        }
    }
}

TEST(TrailStyle, DrawsThePrimaryTrailAloneAsASolidLineInTheAccent) {
    for (const Theme& theme : {dayTheme(), nightTheme()}) {
        for (const TrailStyle& style : trailStyles()) {
            EXPECT_EQ(trailPen(style.name, true, theme), trailPen("hedr_bayes", true, theme));
            EXPECT_EQ(trailPen(style.name, true, theme).style(), Qt::SolidLine);
            EXPECT_NE(trailPen(style.name, false, theme).color(), theme.accent) << style.name;
        }
    }
}

TEST(TrailStyle, ShowsAnUnknownEstimatorUnderItsOwnName) {
    EXPECT_EQ(trailLabel("wall_filter"), "wall_filter");
    EXPECT_EQ(trailRank("wall_filter"), trailStyles().size());
}

}  // namespace
}  // namespace hedr
