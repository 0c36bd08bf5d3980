#pragma once

#include <QColor>
#include <array>

namespace hedr {

enum class ThemeName { kDay, kNight };

// Every colour of the program. Widgets paint with these and with nothing else.
struct Theme {
    ThemeName name = ThemeName::kDay;
    QColor background;  // around the plan
    QColor paper;       // of a plan
    QColor chrome;      // strip, rail and cards
    QColor hairline;
    QColor chip;  // a button, or a chosen entry
    QColor ink;
    QColor dim;
    QColor wall;
    QColor accent;  // the primary trail and what is chosen
    QColor hedr_bayes;
    QColor hedr;
    QColor robot_trail;
    QColor odometry;
    QColor gyro;
    QColor gyrodometry;
    QColor gh_filter;
    QColor good;
    QColor warning;
    QColor alarm;
    QColor recording;
    std::array<QColor, 6> robots;  // one each; the first one's is the accent
};

Theme dayTheme();
Theme nightTheme();
Theme themeOf(ThemeName name);

// Contrast of two opaque colours after WCAG 2.1: 1 (none) to 21 (black on white).
double contrastRatio(const QColor& a, const QColor& b);

}  // namespace hedr
