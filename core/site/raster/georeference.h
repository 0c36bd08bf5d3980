#pragma once

#include <ogr_spatialref.h>

#include <memory>
#include <optional>
#include <string>

#include "core/site/geo_tie.h"
#include "core/site/plan.h"
#include "core/site/raster/gdal_file.h"
#include "core/site/world_file.h"

namespace hedr {

// Where an image lies in the coordinates of a map.
struct Georeference {
    Transform<Ground, Plan> ground_from_plan{};
    OGRSpatialReference system{};  // empty: unknown
};

// What the file itself says, if anything. Error: kBadValue (not finite, no area).
Result<std::optional<Georeference>> georeferenceOf(GDALDataset& dataset, const std::string& path);

// WGS 84 in degrees, longitude first.
OGRSpatialReference globeInDegrees();

// From coordinates of that system to globeInDegrees; null where nobody knows the way.
using Projection = std::unique_ptr<OGRCoordinateTransformation>;
Projection toGlobe(const OGRSpatialReference& system);
// None for what is not on the globe.
std::optional<LatLon> latLon(OGRCoordinateTransformation& globe_from_ground, Point<Ground> p);

// A picture in the mission's local metres.
struct GroundRaster {
    Dataset dataset;
    PlanPlacement placement{};
    std::optional<GeoTie> geo_tie{};
};

// Takes a dataset of bytes to local metres. Square pixels of a projection in metres stay as they
// are; others (degrees, Web Mercator, skewed, mirrored) are warped north up, by a view that warps
// what is read. Error: kBadValue (outside the globe), kNotAnImage.
Result<GroundRaster> onGround(Dataset dataset, const Georeference& where, const std::string& path);

}  // namespace hedr
