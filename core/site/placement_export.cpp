#include "core/site/placement_export.h"

#include <cstdint>
#include <optional>
#include <string>

#include "core/site/raster_file.h"
#include "core/site/world_file.h"
#include "core/text/number.h"
#include "core/text/plain_toml.h"
#include "core/text/text_file.h"

namespace hedr {
namespace {

namespace fs = std::filesystem;

// Of blue, green, red; ITU-R BT.601 in 256ths.
std::uint8_t greyOf(const std::uint8_t* pixel) {
    return static_cast<std::uint8_t>((29 * pixel[0] + 150 * pixel[1] + 77 * pixel[2] + 128) >> 8);
}

// None where it was canceled.
std::optional<std::string> pgmOf(const PlanLevel& image, const PlanProgress& progress) {
    std::string pgm =
        "P5\n" + std::to_string(image.width_px) + ' ' + std::to_string(image.height_px) + "\n255\n";
    const std::uint8_t* pixel = image.pixels->data();
    pgm.reserve(pgm.size() + image.pixels->size() / static_cast<std::size_t>(image.channels));
    for (int row = 0; row < image.height_px; ++row) {
        if (progress && !progress(static_cast<double>(row) / image.height_px)) return std::nullopt;
        for (int i = 0; i < image.width_px; ++i, pixel += image.channels) {
            pgm += static_cast<char>(image.channels == 1 ? *pixel : greyOf(pixel));
        }
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

// Whoever names one file does not see that another one is written beside it.
Result<void> refuseToReplaceAStranger(const fs::path& named, const fs::path& beside) {
    std::error_code ignored;
    if (fs::exists(named, ignored) || !fs::exists(beside, ignored)) return {};
    return fail(ErrorCode::kFileUnwritable, beside.string(), "another file has that name");
}

// Nothing is left of an image whose description cannot be written.
template <class WriteImage, class WriteText>
Result<void> writeBoth(const fs::path& image, WriteImage write_image, WriteText write_text) {
    std::error_code ignored;
    const bool is_new = !fs::exists(image, ignored);
    Result<void> written = write_image().and_then(write_text);
    if (!written && is_new) fs::remove(image, ignored);
    return written;
}

}  // namespace

Result<void> exportWorldFile(const PlanPlacement& placement, int height_px, const fs::path& file) {
    return writeTextFile(file, worldFileText(worldFileOf(worldFromPlan(placement, height_px))));
}

fs::path rosImageBeside(const fs::path& yaml_file) {
    return fs::path(yaml_file).replace_extension(".pgm");
}

fs::path worldFileOfPng(const fs::path& png_file) {
    return fs::path(png_file).replace_extension(".pgw");
}

Result<void> exportRosMap(const PlanLevel& image, const PlanPlacement& placement,
                          const fs::path& yaml_file, const PlanProgress& progress) {
    const fs::path pgm_file = rosImageBeside(yaml_file);
    if (auto mine = refuseToReplaceAStranger(yaml_file, pgm_file); !mine) return mine;
    const auto whole = readWhole(image);
    if (!whole) return tl::make_unexpected(whole.error());
    const auto pgm = pgmOf(*whole, progress);
    if (!pgm) return fail(ErrorCode::kCanceled, yaml_file.string());
    const std::string yaml = rosYaml(placement, pgm_file.filename().string());
    return writeBoth(
        pgm_file, [&] { return writeTextFile(pgm_file, *pgm); },
        [&] { return writeTextFile(yaml_file, yaml); });
}

Result<void> exportPng(const PlanLevel& image, const PlanPlacement& placement,
                       const fs::path& png_file, const PlanProgress& progress) {
    const fs::path world_file = worldFileOfPng(png_file);
    if (auto mine = refuseToReplaceAStranger(png_file, world_file); !mine) return mine;
    const auto whole = readWhole(image);
    if (!whole) return tl::make_unexpected(whole.error());
    return writeBoth(
        png_file, [&] { return savePlanImage(*whole, png_file, progress); },
        [&] { return exportWorldFile(placement, image.height_px, world_file); });
}

}  // namespace hedr
