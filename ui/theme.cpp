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
    return {
        .name = ThemeName::kDay,
        .background = QColor("#F4F5F2"),
        .paper = QColor("#FFFFFF"),
        .chrome = QColor("#FFFFFF"),
        .hairline = QColor("#D5D9DC"),
        .chip = QColor("#EEF1F3"),
        .ink = QColor("#14181B"),
        .dim = QColor("#5B646B"),
        .wall = QColor("#3A3F44"),
        .accent = QColor("#0072B2"),
        .hedr_bayes = QColor("#7A4A1E"),
        .hedr = QColor("#6A4FA3"),
        .robot_trail = QColor("#009E73"),
        .odometry = QColor("#D55E00"),
        .gyro = QColor("#AA3377"),
        .gyrodometry = QColor("#59636E"),
        .gh_filter = QColor("#6B7A00"),
        .good = QColor("#00734F"),
        .warning = QColor("#8A5A00"),
        .alarm = QColor("#C62828"),
        .recording = QColor("#C62828"),
        .robots = {QColor("#0072B2"), QColor("#B0307A"), QColor("#8A4B08"), QColor("#5E3BB5"),
                   QColor("#4D6B00"), QColor("#006D77")},
    };
}

Theme nightTheme() {
    return {
        .name = ThemeName::kNight,
        .background = QColor("#0E1114"),
        .paper = QColor("#15191D"),
        .chrome = QColor("#1A1F24"),
        .hairline = QColor("#2C343B"),
        .chip = QColor("#242B31"),
        .ink = QColor("#E8ECEF"),
        .dim = QColor("#9AA5AD"),
        .wall = QColor("#8A939B"),
        .accent = QColor("#56B4E9"),
        .hedr_bayes = QColor("#D9B08C"),
        .hedr = QColor("#B39DDB"),
        .robot_trail = QColor("#4FD1A1"),
        .odometry = QColor("#E69F00"),
        .gyro = QColor("#E58FC2"),
        .gyrodometry = QColor("#B4BEC8"),
        .gh_filter = QColor("#C5D86D"),
        .good = QColor("#4FD1A1"),
        .warning = QColor("#F0C05A"),
        .alarm = QColor("#FF6B6B"),
        .recording = QColor("#D83A3A"),
        .robots = {QColor("#56B4E9"), QColor("#F08CC6"), QColor("#E8A860"), QColor("#B7A2F5"),
                   QColor("#B8D060"), QColor("#5CD6C8")},
    };
}

Theme themeOf(ThemeName name) { return name == ThemeName::kDay ? dayTheme() : nightTheme(); }

double contrastRatio(const QColor& a, const QColor& b) {
    const auto [low, high] = std::minmax({luminance(a), luminance(b)});
    return (high + 0.05) / (low + 0.05);
}

}  // namespace hedr
