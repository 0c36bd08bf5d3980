#include "core/site/floor_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/site/mip_pyramid.h"

namespace hedr {
namespace {

const cv::Scalar kPaper(0xFF, 0xFF, 0xFF);  // blue, green, red
const cv::Scalar kWallInk(0x44, 0x3F, 0x3A);
const cv::Scalar kRoomTint(0xF8, 0xFB, 0xFA);
const cv::Scalar kNameInk(0x6B, 0x64, 0x5B);
constexpr double kNameHeight_m = 0.75;
constexpr double kPenShare = 0.11;  // of the height of a name
constexpr int kSubpixelBits = 8;
constexpr int kFiner = 3;  // drawn so much finer and averaged: OpenCV's own smoothing is coarse

struct Box {
    Point<Floor> min{};
    Point<Floor> max{};
};

// A wall reaches half its thickness beyond its ends: corners are whole, and doors have frames.
std::array<Point<Floor>, 4> cornersOf(const Wall& wall) {
    const Vector<Floor> along = wall.to - wall.from;
    const Vector<Floor> half = (0.5 * wall.thickness_m / along.length()) * along;
    const Vector<Floor> side{-half.y, half.x};
    const Point<Floor> begin = wall.from + (-1.0) * half;
    const Point<Floor> end = wall.to + half;
    return {begin + (-1.0) * side, end + (-1.0) * side, end + side, begin + side};
}

std::array<Point<Floor>, 4> cornersOf(const Room& room) {
    return {room.min, {room.max.x, room.min.y}, room.max, {room.min.x, room.max.y}};
}

Box boundsOf(const FloorPlan& floor) {
    Box box{{1e9, 1e9}, {-1e9, -1e9}};
    for (const Wall& wall : floor.walls) {
        for (const Point<Floor>& corner : cornersOf(wall)) {
            box.min = {std::min(box.min.x, corner.x), std::min(box.min.y, corner.y)};
            box.max = {std::max(box.max.x, corner.x), std::max(box.max.y, corner.y)};
        }
    }
    return box;
}

class Canvas {
  public:
    Canvas(const Box& box, double resolution_m)
        : origin_(box.min),
          step_m_(resolution_m / kFiner),
          size_(pixels(box.max.x - box.min.x), pixels(box.max.y - box.min.y)),
          image_(size_ * kFiner, CV_8UC3, kPaper) {}

    void fill(const std::array<Point<Floor>, 4>& corners, const cv::Scalar& ink) {
        std::array<cv::Point, 4> points;
        std::ranges::transform(corners, points.begin(),
                               [this](Point<Floor> p) { return subpixel(p); });
        cv::fillConvexPoly(image_, points.data(), 4, ink, cv::LINE_AA, kSubpixelBits);
    }

    void write(const std::string& text, Point<Floor> middle) {
        constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;
        constexpr double kFontHeight_px = 21.0;  // of a capital letter at scale 1
        const double height_px = kNameHeight_m / step_m_;
        const double scale = height_px / kFontHeight_px;
        const int pen = std::max(1, static_cast<int>(std::lround(kPenShare * height_px)));
        const cv::Size size = cv::getTextSize(text, kFont, scale, pen, nullptr);
        const cv::Point centre = subpixel(middle);
        const cv::Point corner((centre.x >> kSubpixelBits) - size.width / 2,
                               (centre.y >> kSubpixelBits) + size.height / 2);
        cv::putText(image_, text, corner, kFont, scale, kNameInk, pen, cv::LINE_AA);
    }

    PlanLevel averaged() const {
        cv::Mat small;
        cv::resize(image_, small, size_, 0.0, 0.0, cv::INTER_AREA);
        cv::cvtColor(small, small, cv::COLOR_BGR2BGRA);
        return {small.cols, small.rows, 4,
                std::make_shared<std::vector<std::uint8_t>>(small.datastart, small.dataend)};
    }

  private:
    int pixels(double length_m) const {
        return std::max(1, static_cast<int>(std::ceil(length_m / (kFiner * step_m_) - 1e-6)));
    }

    // OpenCV counts from the middle of a pixel.
    cv::Point subpixel(Point<Floor> p) const {
        const double right = (p.x - origin_.x) / step_m_ - 0.5;
        const double down = image_.rows - (p.y - origin_.y) / step_m_ - 0.5;
        constexpr double kUnits = 1 << kSubpixelBits;
        return {static_cast<int>(std::lround(right * kUnits)),
                static_cast<int>(std::lround(down * kUnits))};
    }

    Point<Floor> origin_;
    double step_m_;
    cv::Size size_;
    cv::Mat image_;
};

}  // namespace

PlanImage drawFloorPlan(const FloorPlan& floor, double resolution_m,
                        const Pose<World>& floor_origin) {
    const Box box = boundsOf(floor);
    Canvas canvas(box, resolution_m);
    for (const Room& room : floor.rooms) canvas.fill(cornersOf(room), kRoomTint);
    for (const Wall& wall : floor.walls) canvas.fill(cornersOf(wall), kWallInk);
    for (const Room& room : floor.rooms) {
        canvas.write(room.name, room.min + 0.5 * (room.max - room.min));
    }
    const Pose<World> corner{rigidTransform<World, Floor>(floor_origin) * box.min,
                             floor_origin.heading_rad};
    return {{}, mipPyramid(canvas.averaged()), {resolution_m, corner}};
}

}  // namespace hedr
