#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "ui/live_model.h"
#include "ui/panels/status_tiles.h"

namespace hedr {

// One line of the link card.
struct LinkFigure {
    QString label;
    QString value;
    Tone tone = Tone::kPlain;
    friend bool operator==(const LinkFigure&, const LinkFigure&) = default;
};

// How the link is in figures, the weightiest first; what is not known is left out.
std::vector<LinkFigure> linkFigures(const LiveModel& model);

// Share of the frames of the last ten seconds that did not come; since the start where there are
// no samples yet. None where nothing came that could tell, and of lines of text, which are not
// numbered.
std::optional<double> recentLoss(const LiveModel& model);
// Whether the robot numbers what it sends, so that one can tell what is missing.
bool countsLoss(const LiveModel& model);

}  // namespace hedr
