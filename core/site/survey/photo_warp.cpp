#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "core/site/survey/rectification.h"

namespace hedr {
namespace {

constexpr int kTile_px = 256;
constexpr int kLeastTile_px = 8;
constexpr int kFinest = 8;    // a pixel is the mean of at most 8 x 8 samples
constexpr int kReach_px = 3;  // of the cubic kernel, and one to spare

using Matrix = cv::Matx33d;

// OpenCV counts from the middle of a pixel, Plan and Flat from its corner.
Matrix betweenPixelMiddles(const Eigen::Matrix3d& m) {
    const Matrix between_corners(m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2), m(2, 0),
                                 m(2, 1), m(2, 2));
    return Matrix(1, 0, -0.5, 0, 1, -0.5, 0, 0, 1) * between_corners *
           Matrix(1, 0, 0.5, 0, 1, 0.5, 0, 0, 1);
}

struct Tile {
    cv::Rect photo;  // the pixels that it shows
    int finer = 1;   // samples per pixel and axis that leave no pixel of the photo out
};

std::array<Point<Flat>, 4> cornersOf(const cv::Rect& tile) {
    const double left = tile.x;
    const double top = tile.y;
    const double right = left + tile.width;
    const double bottom = top + tile.height;
    return {{{left, top}, {right, top}, {right, bottom}, {left, bottom}}};
}

// None where nothing of the photo is seen.
std::optional<Tile> tileAt(const Perspective<Plan, Flat>& photo_from_flat, const cv::Rect& flat,
                           const cv::Size& photo) {
    cv::Rect2d seen;
    double stretch = 1.0;
    for (const Point<Flat> p : cornersOf(flat)) {
        const Point<Plan> at = photo_from_flat * p;
        const cv::Rect2d here(at.x - kReach_px, at.y - kReach_px, 2 * kReach_px, 2 * kReach_px);
        seen = seen.empty() ? here : seen | here;
        stretch = std::max({stretch, (photo_from_flat * (p + Vector<Flat>{1.0, 0.0}) - at).length(),
                            (photo_from_flat * (p + Vector<Flat>{0.0, 1.0}) - at).length()});
    }
    seen &= cv::Rect2d(0.0, 0.0, photo.width, photo.height);
    if (seen.empty()) return {};
    const cv::Point from(static_cast<int>(seen.x), static_cast<int>(seen.y));
    const cv::Point to(static_cast<int>(std::ceil(seen.br().x)),
                       static_cast<int>(std::ceil(seen.br().y)));
    // A tenth too coarse is not seen, and saves most tiles three of four samples.
    return Tile{cv::Rect(from, to),
                std::clamp(static_cast<int>(std::ceil(stretch - 0.1)), 1, kFinest)};
}

std::array<cv::Rect, 2> halvesOf(const cv::Rect& tile) {
    cv::Rect first = tile;
    cv::Rect second = tile;
    if (tile.width > tile.height) {
        first.width /= 2;
        second.x += first.width;
        second.width -= first.width;
    } else {
        first.height /= 2;
        second.y += first.height;
        second.height -= first.height;
    }
    return {first, second};
}

// Warps a tile finer than it is wanted and averages: sharp where the photo is magnified, without
// aliasing where it is reduced. White where the tile lies behind the camera.
void warpTile(const cv::Mat& photo, const Perspective<Plan, Flat>& photo_from_flat,
              const cv::Rect& flat, cv::Mat target) {
    const auto behind = [&](Point<Flat> p) { return photo_from_flat.depth(p) <= 0.0; };
    const bool is_behind = std::ranges::any_of(cornersOf(flat), behind);
    if (is_behind && std::max(flat.width, flat.height) > kLeastTile_px) {
        const cv::Rect all(0, 0, flat.width, flat.height);
        for (const cv::Rect& half : halvesOf(all)) {
            warpTile(photo, photo_from_flat, half + flat.tl(), target(half));
        }
        return;
    }
    const auto tile = is_behind ? std::nullopt : tileAt(photo_from_flat, flat, photo.size());
    if (!tile) {
        target.setTo(cv::Scalar::all(255));
        return;
    }
    const double step = 1.0 / tile->finer;
    Eigen::Matrix3d flat_from_samples;
    flat_from_samples << step, 0.0, flat.x, 0.0, step, flat.y, 0.0, 0.0, 1.0;
    Eigen::Matrix3d part_from_photo = Eigen::Matrix3d::Identity();
    part_from_photo.topRightCorner<2, 1>() << -tile->photo.x, -tile->photo.y;
    const Matrix matrix =
        betweenPixelMiddles(part_from_photo * photo_from_flat.matrix() * flat_from_samples);
    const int how = cv::WARP_INVERSE_MAP | (tile->finer == 1 ? cv::INTER_CUBIC : cv::INTER_LINEAR);
    cv::Mat samples;
    cv::warpPerspective(photo(tile->photo), samples, matrix, flat.size() * tile->finer, how,
                        cv::BORDER_CONSTANT, cv::Scalar::all(255));
    cv::resize(samples, target, target.size(), 0.0, 0.0, cv::INTER_AREA);
}

cv::Mat matOf(const PlanLevel& level) {
    return {level.height_px, level.width_px, CV_8UC(level.channels),
            const_cast<std::uint8_t*>(level.pixels->data())};  // only read
}

PlanLevel blankLevel(int width_px, int height_px, int channels,
                     std::shared_ptr<std::vector<std::uint8_t>>& pixels) {
    pixels = std::make_shared<std::vector<std::uint8_t>>(static_cast<std::size_t>(width_px) *
                                                         static_cast<std::size_t>(height_px) *
                                                         static_cast<std::size_t>(channels));
    return {width_px, height_px, channels, pixels};
}

}  // namespace

Result<PlanLevel> rectified(const PlanLevel& photo, const Rectification& rectification,
                            const PlanProgress& progress) {
    Result<PlanLevel> whole = readWhole(photo);
    if (!whole) return whole;
    const int width_px = rectification.width_px;
    const int height_px = rectification.height_px;
    const auto photo_from_flat = rectification.flat_from_photo.inverse();
    try {
        std::shared_ptr<std::vector<std::uint8_t>> pixels;
        PlanLevel flat = blankLevel(width_px, height_px, photo.channels, pixels);
        const cv::Mat source = matOf(*whole);
        cv::Mat target(height_px, width_px, source.type(), pixels->data());
        const cv::Rect all(0, 0, width_px, height_px);
        for (int y = 0; y < height_px; y += kTile_px) {
            if (progress && !progress(static_cast<double>(y) / height_px)) {
                return fail(ErrorCode::kCanceled, "photo");
            }
            for (int x = 0; x < width_px; x += kTile_px) {
                const cv::Rect tile = cv::Rect(x, y, kTile_px, kTile_px) & all;
                warpTile(source, photo_from_flat, tile, target(tile));
            }
        }
        return flat;
    } catch (const std::bad_alloc&) {
        return fail(ErrorCode::kImageTooLarge, "photo",
                    std::to_string(width_px) + " x " + std::to_string(height_px) + " pixels");
    }
}

PlanLevel rectifiedPreview(const std::vector<PlanLevel>& photo_levels,
                           const Rectification& rectification, int most_px) {
    const double longest_px = std::max(rectification.width_px, rectification.height_px);
    const double scale = std::min(1.0, most_px / longest_px);
    const PlanLevel& whole = photo_levels.front();
    // The smallest level that is fine enough, or the finest that is in memory.
    const PlanLevel* level = nullptr;
    for (const PlanLevel& next : photo_levels) {
        if (next.pixels && (!level || next.width_px >= scale * whole.width_px)) level = &next;
    }
    if (!level) return {};
    const Eigen::Vector3d level_scale(static_cast<double>(whole.width_px) / level->width_px,
                                      static_cast<double>(whole.height_px) / level->height_px, 1.0);
    const Eigen::Vector3d flat_scale(scale, scale, 1.0);
    Rectification small = rectification;
    small.width_px = std::max(1, static_cast<int>(scale * rectification.width_px));
    small.height_px = std::max(1, static_cast<int>(scale * rectification.height_px));
    small.flat_from_photo =
        Perspective<Flat, Plan>(flat_scale.asDiagonal() * rectification.flat_from_photo.matrix() *
                                level_scale.asDiagonal());
    return rectified(*level, small).value_or(PlanLevel{});
}

}  // namespace hedr
