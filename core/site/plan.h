#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/geometry/frames.h"
#include "core/result.h"

namespace hedr {

// Pixels of one level: 8-bit grey (channels = 1) or BGRA (channels = 4), rows tightly packed.
struct PlanLevel {
    int width_px = 0;
    int height_px = 0;
    int channels = 1;
    std::shared_ptr<const std::vector<std::uint8_t>> pixels;
};

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
    std::vector<PlanLevel> levels;  // full size first, each next one half as large
    PlanPlacement placement{};

    Transform<World, Plan> worldFromPlan() const;
};

// Called with 0..1 now and then; returning false cancels the load (kCanceled).
using PlanProgress = std::function<bool(double)>;

// Loads an image (PNG, JPEG, PGM, ...) with its placement, or a placement file that names its image
// (plan.toml: image, resolution_m, origin_x_m, origin_y_m, rotation_deg; ROS map yaml: image,
// resolution, origin). For an image the placement is looked for beside it (same name with .toml,
// .yaml, .yml), else 0.05 m per pixel at the origin.
// Errors: kFileMissing, kNotAnImage, kImageTooLarge, kMissingKey, kBadValue, kBadFormat, kCanceled.
Result<PlanImage> loadPlan(const std::filesystem::path& file, const PlanProgress& progress = {});

}  // namespace hedr
