#include "core/site/raster/exif_lens.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace hedr {
namespace {

constexpr double kFilmDiagonal_mm = 43.267;  // of 24 x 36 mm; CIPA DCG-001 compares diagonals
constexpr double kSameShape = 0.01;
constexpr double kLeast = 0.2;  // a fisheye's; no photo is flat with less
constexpr double kMost = 20.0;

// One standard deviation of what a lens is beside what is printed on it: its making, and that it
// moves out to focus at what is near (1.4 % for 4 mm at 0.3 m).
constexpr double kSigmaOfLens = 0.01;
// The same, where a film's length is meant. Makers who compare widths instead of diagonals say 3.9
// % less for 4:3; one in seven makes 1.4 %.
constexpr double kSigmaOfFilm = 0.0175;
constexpr double kAgree = 3.0;  // sigmas

double shapeOf(double width, double height) {
    return std::max(width, height) / std::min(width, height);
}

bool isAlike(double shape, double other) { return std::abs(shape / other - 1.0) < kSameShape; }

bool isAsTaken(const ExifLens& lens, int width_px, int height_px) {
    const double shape = shapeOf(width_px, height_px);
    const bool cut_before = lens.digital_zoom.value_or(1.0) > 1.0 + kSameShape;
    const bool cut_after = lens.taken_width_px && lens.taken_height_px &&
                           !isAlike(shape, shapeOf(*lens.taken_width_px, *lens.taken_height_px));
    return !cut_before && !cut_after && (isAlike(shape, 4.0 / 3.0) || isAlike(shape, 3.0 / 2.0));
}

// Of a number that was rounded to as many decimals as it has, two at most.
double sigmaOfRounding(double value) {
    double unit = 1.0;
    while (unit > 0.01 && std::abs(value / unit - std::round(value / unit)) > 1e-3) unit *= 0.1;
    return unit / std::sqrt(12.0) / value;
}

// In diagonals of the photo, which do not change with its size.
std::optional<FocalLength> byFilm(const ExifLens& lens) {
    if (!lens.film_mm || !(*lens.film_mm > 0.0)) return {};
    return FocalLength{*lens.film_mm / kFilmDiagonal_mm,
                       std::hypot(sigmaOfRounding(*lens.film_mm), kSigmaOfFilm)};
}

std::optional<FocalLength> bySensor(const ExifLens& lens) {
    const bool said =
        lens.lens_mm && lens.sensor_px_per_mm && lens.taken_width_px && lens.taken_height_px;
    if (!said || !(*lens.lens_mm > 0.0)) return {};
    return FocalLength{*lens.lens_mm * *lens.sensor_px_per_mm /
                           std::hypot(*lens.taken_width_px, *lens.taken_height_px),
                       std::hypot(sigmaOfRounding(*lens.lens_mm), kSigmaOfLens)};
}

// The sensor's is the better one, unless the lens is a rounded 4 mm, or the sensor another's: some
// cameras state that of the whole chip.
std::optional<FocalLength> best(const ExifLens& lens) {
    const auto film = byFilm(lens);
    const auto sensor = bySensor(lens);
    if (!film || !sensor) return film ? film : sensor;
    const bool agree =
        std::abs(std::log(sensor->px / film->px)) < kAgree * std::hypot(sensor->sigma, film->sigma);
    return agree && sensor->sigma < film->sigma ? sensor : film;
}

}  // namespace

std::optional<FocalLength> focalLengthOf(const ExifLens& lens, int width_px, int height_px) {
    if (width_px < 1 || height_px < 1 || !isAsTaken(lens, width_px, height_px)) return {};
    const auto focal = best(lens);
    const bool sane = focal && focal->px > kLeast && focal->px < kMost;
    if (!sane) return {};
    return FocalLength{focal->px * std::hypot(width_px, height_px), focal->sigma};
}

}  // namespace hedr
