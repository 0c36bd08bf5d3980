#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/frames.h"
#include "core/site/control_points.h"
#include "core/site/geo_tie.h"
#include "core/site/plan.h"
#include "core/site/quad.h"
#include "core/site/wall_stroke.h"

namespace hedr {

// The part of a plan image that is shown, in plan pixels.
struct PlanCrop {
    Point<Plan> min{};
    Point<Plan> max{};
    friend bool operator==(const PlanCrop&, const PlanCrop&) = default;
};

// A photo that is shown as if it had been taken from straight above.
struct Straightening {
    Quad quad{};                     // a rectangle's corners in the photo
    std::optional<double> aspect{};  // its width / height; none: as the perspective tells
    friend bool operator==(const Straightening&, const Straightening&) = default;
};

// The points by which a plan was placed, so that they can be mended later.
struct PlacingPoints {
    std::vector<ControlPoint> points{};
    bool keep_scale = false;     // the scale was not theirs to say
    bool keep_rotation = false;  // nor the rotation
    friend bool operator==(const PlacingPoints&, const PlacingPoints&) = default;
};

// One image of a floor and how it is shown.
struct SitePlan {
    std::filesystem::path image_file;
    int page = 1;  // of a file that has several
    std::optional<Straightening> straightened{};
    std::string sha256{};  // of the image file as it was aligned; empty: not known
    PlanPlacement placement{};
    PlacingPoints placed_by{};  // none: it was placed in another way
    double opacity = 1.0;
    bool visible = true;
    bool locked = false;            // may not be moved
    bool inverted_at_night = true;  // its lightness; off for aerial photos
    std::optional<PlanCrop> crop{};
    bool tells_direction = false;  // the site's direction is that of its walls, and turns with it
    friend bool operator==(const SitePlan&, const SitePlan&) = default;
};

struct SiteFloor {
    std::string name;
    std::vector<SitePlan> plans{};           // the lowest first
    std::vector<WallStroke> wall_strokes{};  // drawn by the operator, in order
    friend bool operator==(const SiteFloor&, const SiteFloor&) = default;
};

// Everything that is known of a place: a value, so that undo keeps old ones.
struct Site {
    std::vector<SiteFloor> floors{};
    std::optional<double> direction_rad{};  // of one corridor in the world; others every 90 degrees
    std::optional<GeoTie> geo_tie{};
    friend bool operator==(const Site&, const Site&) = default;
};

}  // namespace hedr
