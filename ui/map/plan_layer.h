#pragma once

#include <QImage>
#include <QPainter>
#include <array>

#include "core/site/plan.h"
#include "ui/map/map_plan.h"
#include "ui/map/view_transform.h"
#include "ui/theme.h"

namespace hedr {

// What each grey value of a plan looks like in a theme: ink becomes the walls' colour and paper the
// paper's, so that a white plan is dark at night.
using PlanColours = std::array<QRgb, 256>;
PlanColours planColours(const Theme& theme);

// A colour of a plan or photo in a theme: unchanged by day, its lightness turned over at night.
QRgb themedColour(QRgb colour, const Theme& theme);

// Draws the visible part from the level of the pyramid that suits the screen's resolution.
void drawPlan(QPainter& painter, const PlanImage& plan, const Theme& theme,
              const ViewTransform& view);

WorldBox planBounds(const PlanImage& plan);
WorldBox planBounds(const MapPlan& plan);  // of what its crop leaves

}  // namespace hedr
