#pragma once

#include <QPen>
#include <QString>
#include <string_view>
#include <vector>

#include "ui/theme.h"

namespace hedr {

// How one estimator's trail looks: told apart by dashes as well as by colour.
struct TrailStyle {
    const char* name;   // the estimator's, or "robot"
    const char* label;  // for people
    double width_px;
    std::vector<double> dashes;  // in widths; empty: solid
    QColor Theme::*colour;
    bool shown_at_first;  // the others wait in the legend: a calm map tells more
};

// The primary one first. Drawn in reverse, so that the primary lies on top.
const std::vector<TrailStyle>& trailStyles();

const TrailStyle& trailStyle(std::string_view name);
std::size_t trailRank(std::string_view name);  // place in the table
QString trailLabel(std::string_view name);
QPen trailPen(std::string_view name, const Theme& theme);

}  // namespace hedr
