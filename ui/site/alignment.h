#pragma once

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "core/site/control_points.h"
#include "core/site/geo_tie.h"
#include "core/site/plan.h"
#include "core/site/site.h"

namespace hedr {

// What an operator has said about where a plan lies, and where it lies therefore. A value: undo
// keeps the earlier ones.
struct Alignment {
    PlanPlacement placement{};
    std::vector<ControlPoint> points{};    // on the plan, and where they are on the map
    std::optional<Point<Plan>> waiting{};  // clicked on the plan; the next click is on the map
    std::vector<Point<Plan>> ruler{};      // the ends of a known distance, as far as clicked
    std::optional<double> distance_m{};    // between them
    bool keep_scale = false;
    bool keep_rotation = false;
};

// How an alignment's points fit; none with fewer than two of them.
struct AlignmentFit {
    std::optional<PlanFit> fit{};
    std::optional<Error> error{};  // why they fit nothing
};

// An image of that height, aligned by its points: the plan goes where they want it, with one point
// by a shift. With points that fit nothing it stays.
AlignmentFit fitOf(const Alignment& alignment, int height_px);
Alignment fitted(Alignment alignment, int height_px);

// Its points where they still say where the plan lies; none after another way of placing it.
PlacingPoints placingPointsOf(const Alignment& alignment, int height_px);

// A click in the method of points: first on the plan, then on the map.
Alignment withClick(Alignment alignment, Point<World> at, int height_px);
// The map's end typed instead of clicked. Errors: those of worldPointFromText.
Result<Alignment> withTypedPlace(Alignment alignment, std::string_view text,
                                 const std::optional<GeoTie>& tie, int height_px);
// The points of a file instead of those there are. Errors: those of loadControlPoints; kNoData
// (places on the globe, without a tie), kBadValue (out of its reach).
Result<Alignment> withPointsOf(const std::filesystem::path& file, Alignment alignment,
                               const std::optional<GeoTie>& tie, int height_px);
Alignment withoutPoint(Alignment alignment, std::size_t point, int height_px);

// A click in the method of a known distance; the third one begins anew.
Alignment withRulerClick(Alignment alignment, Point<World> at, int height_px);
// Scales the plan about the ruler's first end. Errors: kBadValue (the ends coincide).
Result<Alignment> withDistance(Alignment alignment, double distance_m, int height_px);

}  // namespace hedr
