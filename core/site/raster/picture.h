#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/site/geo_tie.h"
#include "core/site/plan.h"

namespace hedr {

// What a format gives of a file: the picture, and where it lies if the file knows.
struct Picture {
    std::vector<PlanLevel> levels;
    std::optional<PlanPlacement> placement{};
    std::optional<GeoTie> geo_tie{};
    std::optional<FocalLength> focal_length{};
};

// How a picture is wanted.
struct PictureJob {
    PlanChoice choice{};
    int longest_side_px = 0;  // of a small picture for a list; 0: full size
    PlanProgress progress{};
    std::function<void(const Picture&)> on_preview{};
};

bool wasCanceled(const PictureJob& job, double share);

// The pixels per inch for a page of that size: what was chosen, else 150, but no more than make
// `longest_side_px`, or 10,000 pixels.
double dpiOf(const PictureJob& job, double longer_side_mm);

// Metres on the ground per pixel of a page.
double pageResolution_m(const PlanChoice& choice, double dpi);

}  // namespace hedr
