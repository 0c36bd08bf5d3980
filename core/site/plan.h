#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/frames.h"
#include "core/result.h"
#include "core/site/focal_length.h"
#include "core/site/geo_tie.h"

namespace hedr {

struct PlanLevel;

// A rectangle of one level's pixels.
struct PlanPart {
    int left_px = 0;
    int top_px = 0;
    int width_px = 0;
    int height_px = 0;
};
using PlanPartReader = std::function<Result<PlanLevel>(const PlanPart&)>;

// Pixels of one level: 8-bit grey (channels = 1) or BGRA (channels = 4), rows tightly packed.
struct PlanLevel {
    int width_px = 0;
    int height_px = 0;
    int channels = 1;
    std::shared_ptr<const std::vector<std::uint8_t>> pixels{};  // null: not in memory
    PlanPartReader read_part{};  // of a level that stays in its file; on any thread
};

// A part of a level as a level of its own, from memory or from the file; the whole level is shared,
// not copied, where it is in memory. Errors: kNoData (a preview has no such level yet),
// kNotAnImage, kFileUnreadable (the file has changed meanwhile).
Result<PlanLevel> readPart(const PlanLevel& level, const PlanPart& part);
Result<PlanLevel> readWhole(const PlanLevel& level);

// Where a plan image lies on the ground.
struct PlanPlacement {
    double resolution_m = 0.05;  // metres per pixel
    Pose<World> origin{};        // of the image's lower left corner (as in a ROS map)
    friend bool operator==(const PlanPlacement&, const PlanPlacement&) = default;
};

// Plan pixels (y down) to metres in the world, for an image of that height.
Transform<World, Plan> worldFromPlan(const PlanPlacement& placement, int height_px);

struct PlanImage {
    std::filesystem::path image_file;
    std::vector<PlanLevel> levels;  // full size first, each next one half as large (rounded up)
    PlanPlacement placement{};
    std::optional<GeoTie> geo_tie{};  // of the world that `placement` is in, where the file says it
    std::optional<FocalLength> focal_length{};  // of a photo that says it, whole and not flattened
    bool placement_is_guess = false;            // no file says it: 0.05 m per pixel at the origin

    Transform<World, Plan> worldFromPlan() const;
};

// Called with 0..1 now and then; returning false cancels the load (kCanceled).
using PlanProgress = std::function<bool(double)>;

// Called once before a long load is done, with an image whose finest levels are not there yet.
using PlanPreview = std::function<void(const PlanImage&)>;

// What only the operator knows of a PDF or SVG.
struct PlanChoice {
    int page = 1;
    double paper_scale = 100.0;  // of a plan drawn 1:100
    // Pixels per inch of paper; without it 150, but no more than make 10,000 pixels.
    std::optional<double> dpi{};
    friend bool operator==(const PlanChoice&, const PlanChoice&) = default;
};

// Loads a plan: an image, page or drawing of any format in raster/README.md, or a small file that
// names its image (plan.toml, ROS map yaml, KML ground overlay). Where it lies says, in this order:
// a .toml, .yaml or .yml beside it that names it, the file's own georeference, a world file beside
// it; else it gets 0.05 m per pixel at the origin. The same page tells the rules.
// Errors: kFileMissing, kFileUnreadable, kFileEmpty, kNotAnImage, kImageTooLarge, kMissingKey,
// kBadValue, kBadFormat, kCanceled.
Result<PlanImage> loadPlan(const std::filesystem::path& file, const PlanProgress& progress = {},
                           const PlanPreview& on_preview = {}, const PlanChoice& choice = {});

struct PlanPage {
    int width_px = 0;  // as loadPlan would load it
    int height_px = 0;
    double paper_width_mm = 0.0;  // 0: the format knows no paper
    double paper_height_mm = 0.0;
};

struct PlanDescription {
    std::string format;                    // "PNG", "PDF", ... as people call it
    std::vector<PlanPage> pages;           // one, unless it is a PDF
    std::optional<double> resolution_m{};  // metres per pixel, where a file says it
};

// What a file is, without reading its pixels. Errors: those of loadPlan.
Result<PlanDescription> describePlan(const std::filesystem::path& file,
                                     const PlanChoice& choice = {});

// A small picture for a file dialog, at most `side_px` wide and high. Errors: those of loadPlan.
Result<PlanLevel> planThumbnail(const std::filesystem::path& file, int side_px);

}  // namespace hedr
