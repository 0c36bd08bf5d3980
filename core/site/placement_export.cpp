#include "core/site/placement_export.h"

#include <cstdint>
#include <string>

#include "core/site/world_file.h"
#include "core/text/number.h"
#include "core/text/plain_toml.h"
#include "core/text/text_file.h"

namespace hedr {
namespace {

// Of blue, green, red; ITU-R BT.601 in 256ths.
std::uint8_t greyOf(const std::uint8_t* pixel) {
    return static_cast<std::uint8_t>((29 * pixel[0] + 150 * pixel[1] + 77 * pixel[2] + 128) >> 8);
}

std::string pgmOf(const PlanLevel& image) {
    std::string pgm =
        "P5\n" + std::to_string(image.width_px) + ' ' + std::to_string(image.height_px) + "\n255\n";
    const std::uint8_t* pixel = image.pixels->data();
    const std::size_t count = image.pixels->size() / static_cast<std::size_t>(image.channels);
    pgm.reserve(pgm.size() + count);
    for (std::size_t i = 0; i < count; ++i, pixel += image.channels) {
        pgm += static_cast<char>(image.channels == 1 ? *pixel : greyOf(pixel));
    }
    return pgm;
}

std::string rosYaml(const PlanPlacement& placement, const std::string& image_name) {
    const auto& [position, heading_rad] = placement.origin;
    std::string yaml = "image: " + quotedToml(image_name) + "\nresolution: ";
    appendNumber(yaml, placement.resolution_m);
    yaml += "\norigin: [";
    appendNumber(yaml, position.x);
    yaml += ", ";
    appendNumber(yaml, position.y);
    yaml += ", ";
    appendNumber(yaml, heading_rad);
    return yaml + "]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
}

}  // namespace

Result<void> exportWorldFile(const PlanPlacement& placement, int height_px,
                             const std::filesystem::path& file) {
    return writeTextFile(file, worldFileText(worldFileOf(worldFromPlan(placement, height_px))));
}

Result<void> exportRosMap(const PlanLevel& image, const PlanPlacement& placement,
                          const std::filesystem::path& yaml_file) {
    auto pgm_file = yaml_file;
    pgm_file.replace_extension(".pgm");
    const auto whole = readWhole(image);
    if (!whole) return tl::make_unexpected(whole.error());
    return writeTextFile(pgm_file, pgmOf(*whole)).and_then([&] {
        return writeTextFile(yaml_file, rosYaml(placement, pgm_file.filename().string()));
    });
}

}  // namespace hedr
