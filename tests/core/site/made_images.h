#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/site/plan.h"

namespace hedr {

// How a test's image is written.
struct ImageMaking {
    std::string driver = "GTiff";
    std::vector<std::string> options{};             // of that driver
    std::optional<std::array<double, 6>> affine{};  // as GDAL has it
    std::string system{};                           // "EPSG:32613"
    std::vector<int> overviews{};                   // 2, 4, 8 ...
    std::vector<std::string> band_meanings{};       // "cyan", ...
    bool alpha = false;                             // the fourth channel too
};

void makeImage(const std::filesystem::path& file, const PlanLevel& pixels,
               const ImageMaking& making);

// White with a black block in the upper left corner, a sixth as wide and a quarter as high.
PlanLevel markedPaper(int width_px, int height_px, int channels);

// One page per size (width, height in points), each with a black block in its upper left corner.
std::string pdfText(const std::vector<std::array<int, 2>>& pages, const std::string& trailer = {});

// The same JPEG with a tag that says how the camera was held.
std::string withExifOrientation(const std::string& jpeg, int orientation);

// A tag about the exposure; without a denominator a whole number.
struct ExifTag {
    int tag = 0;
    int numerator = 0;
    int denominator = 0;
};
inline constexpr int kExifFocalLength = 0x920A;
inline constexpr int kExifWidth = 0xA002;
inline constexpr int kExifHeight = 0xA003;
inline constexpr int kExifSensorXResolution = 0xA20E;
inline constexpr int kExifSensorUnit = 0xA210;
inline constexpr int kExifDigitalZoom = 0xA404;
inline constexpr int kExifFilmFocalLength = 0xA405;

// The same JPEG with those tags, in the order of their numbers.
std::string withExif(const std::string& jpeg, int orientation, const std::vector<ExifTag>& tags);

std::string bytesOf(const std::filesystem::path& file);
void writeBytes(const std::filesystem::path& file, const std::string& bytes);

// A zip archive with those files: names and what is in them.
void makeArchive(const std::filesystem::path& file,
                 const std::vector<std::pair<std::string, std::string>>& files);

}  // namespace hedr
