#include "ui/theme.h"

#include <algorithm>
#include <cmath>

namespace hedr {
namespace {

double linear(double channel) {
    return channel <= 0.03928 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

double luminance(const QColor& colour) {
    return 0.2126 * linear(static_cast<double>(colour.redF())) +
           0.7152 * linear(static_cast<double>(colour.greenF())) +
           0.0722 * linear(static_cast<double>(colour.blueF()));
}

}  // namespace

Theme dayTheme() {
    return {ThemeName::kDay,   QColor("#F4F5F2"), QColor("#FFFFFF"), QColor("#FFFFFF"),
            QColor("#D5D9DC"), QColor("#EEF1F3"), QColor("#14181B"), QColor("#5B646B"),
            QColor("#3A3F44"), QColor("#0072B2"), QColor("#7A4A1E"), QColor("#6A4FA3"),
            QColor("#009E73"), QColor("#D55E00"), QColor("#AA3377"), QColor("#59636E"),
            QColor("#6B7A00"), QColor("#00734F"), QColor("#8A5A00"), QColor("#C62828"),
            QColor("#C62828")};
}

Theme nightTheme() {
    return {ThemeName::kNight, QColor("#0E1114"), QColor("#15191D"), QColor("#1A1F24"),
            QColor("#2C343B"), QColor("#242B31"), QColor("#E8ECEF"), QColor("#9AA5AD"),
            QColor("#8A939B"), QColor("#56B4E9"), QColor("#D9B08C"), QColor("#B39DDB"),
            QColor("#4FD1A1"), QColor("#E69F00"), QColor("#E58FC2"), QColor("#B4BEC8"),
            QColor("#C5D86D"), QColor("#4FD1A1"), QColor("#F0C05A"), QColor("#FF6B6B"),
            QColor("#D83A3A")};
}

Theme themeOf(ThemeName name) { return name == ThemeName::kDay ? dayTheme() : nightTheme(); }

double contrastRatio(const QColor& a, const QColor& b) {
    const auto [low, high] = std::minmax({luminance(a), luminance(b)});
    return (high + 0.05) / (low + 0.05);
}

}  // namespace hedr
