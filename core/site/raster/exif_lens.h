#pragma once

#include <optional>

#include "core/site/focal_length.h"

namespace hedr {

// What the Exif tags of a photo say of its lens; none where a tag is missing or no number.
struct ExifLens {
    std::optional<double> film_mm{};           // FocalLengthIn35mmFilm
    std::optional<double> lens_mm{};           // FocalLength
    std::optional<double> sensor_px_per_mm{};  // FocalPlaneXResolution
    std::optional<double> digital_zoom{};      // DigitalZoomRatio
    std::optional<double> taken_width_px{};    // PixelXDimension: as the camera wrote it
    std::optional<double> taken_height_px{};
};

// The focal length of a photo that now has that many pixels, smaller perhaps than it was taken.
// None where the tags do not say it, or mean another picture than this: zoomed by cutting, or cut
// afterwards, which shows where the shape is no longer the sensor's, 4:3 or 3:2. README.md says how
// sure it is.
std::optional<FocalLength> focalLengthOf(const ExifLens& lens, int width_px, int height_px);

}  // namespace hedr
