#pragma once

#include <QPen>
#include <QString>
#include <string_view>
#include <vector>

#include "ui/theme.h"

namespace hedr {

// How one estimator's trail looks while it is not the primary one: told apart by dashes as well as
// by colour.
struct TrailStyle {
    const char* name;   // the estimator's, or "robot"
    const char* label;  // for people
    double width_px;
    std::vector<double> dashes;  // in widths
    QColor Theme::*colour;
    bool shown_at_first;  // the others wait in the legend: a calm map tells more
};

// The most trusted one first: where the operator has not chosen, the first one that there is is the
// primary one.
const std::vector<TrailStyle>& trailStyles();

const TrailStyle& trailStyle(std::string_view name);
std::size_t trailRank(std::string_view name);  // place in the table
QString trailLabel(std::string_view name);
// The primary trail is a solid line in the accent colour, whichever it is.
QPen trailPen(std::string_view name, bool primary, const Theme& theme);

}  // namespace hedr
