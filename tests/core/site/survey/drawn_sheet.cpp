#include "tests/core/site/survey/drawn_sheet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <vector>

#include "core/geometry/angle.h"
#include "core/simulation/random.h"
#include "core/site/mip_pyramid.h"

namespace hedr {
namespace {

constexpr int kFiner = 3;          // drawn so much finer and averaged
constexpr double kMargin_m = 2.0;  // of paper around the building
constexpr double kPen_px = 1.5;
constexpr double kWidestDoor_m = 2.1;

using Corners = std::vector<Point<Floor>>;

Corners cornersOf(const Wall& wall) {
    const Vector<Floor> along = wall.to - wall.from;
    const Vector<Floor> half = (0.5 * wall.thickness_m / along.length()) * along;
    const Vector<Floor> side{-half.y, half.x};
    const Point<Floor> begin = wall.from + (-1.0) * half;
    const Point<Floor> end = wall.to + half;
    return {begin + (-1.0) * side, end + (-1.0) * side, end + side, begin + side};
}

class Sheet {
  public:
    Sheet(const FloorPlan& floor, const SheetStyle& style)
        : style_(style), from_floor_(sheetFromFloor(floor, style)), random_(style.seed) {
        double right = 0.0;
        double bottom = 0.0;
        for (const Wall& wall : floor.walls) {
            for (const Point<Floor>& corner : cornersOf(wall)) {
                right = std::max(right, (from_floor_ * corner).x);
                bottom = std::max(bottom, (from_floor_ * corner).y);
            }
        }
        const double margin = kMargin_m / style.resolution_m;
        size_ = {static_cast<int>(right + margin), static_cast<int>(bottom + margin)};
        ink_ = cv::Mat(size_ * kFiner, CV_8U, cv::Scalar(0));
    }

    void walls(const FloorPlan& floor) {
        cv::Mat solid(ink_.size(), CV_8U, cv::Scalar(0));
        for (const Wall& wall : floor.walls) {
            cv::fillConvexPoly(solid, finePoints(cornersOf(wall)), cv::Scalar(255), cv::LINE_8, 4);
        }
        if (style_.hollow) {
            const int pen = finePen();
            cv::Mat inner;
            cv::erode(solid, inner,
                      cv::getStructuringElement(cv::MORPH_ELLIPSE, {2 * pen + 1, 2 * pen + 1}));
            solid &= ~inner;
        }
        ink_ |= solid;
    }

    void line(const Corners& points, bool closed = false) {
        const std::vector<std::vector<cv::Point>> lines{finePoints(points)};
        cv::polylines(ink_, lines, closed, cv::Scalar(255), finePen(), cv::LINE_8, 4);
    }

    // A leaf at right angles to the wall and the quarter circle to the other jamb.
    void door(Point<Floor> hinge, Point<Floor> jamb) {
        const Vector<Floor> leaf = jamb - hinge;
        Corners swing{hinge};
        for (int i = 18; i >= 0; --i) {
            const double angle = radFromDeg(5.0 * i);
            swing.push_back(hinge +
                            Vector<Floor>{leaf.x * std::cos(angle) - leaf.y * std::sin(angle),
                                          leaf.x * std::sin(angle) + leaf.y * std::cos(angle)});
        }
        line(swing);
    }

    // A table or a cupboard in a quarter of a room, at any angle.
    void furniture(const Room& room, int quarter) {
        const Vector<Floor> size = room.max - room.min;
        const Point<Floor> middle =
            room.min + Vector<Floor>{(quarter % 2 == 0 ? 0.3 : 0.7) * size.x,
                                     (quarter / 2 == 0 ? 0.3 : 0.7) * size.y};
        const double angle = random_.uniform() < 0.5 ? 0.0 : random_.uniform(0.0, kPi);
        const double length_m = random_.uniform(0.6, 2.0);
        const double width_m = random_.uniform(0.5, 1.0);
        const Vector<Floor> along{0.5 * length_m * std::cos(angle),
                                  0.5 * length_m * std::sin(angle)};
        const Vector<Floor> across{-0.5 * width_m * std::sin(angle),
                                   0.5 * width_m * std::cos(angle)};
        line({middle + along + across, middle + along + (-1.0) * across,
              middle + (-1.0) * along + (-1.0) * across, middle + (-1.0) * along + across},
             true);
    }

    void hatching(const Room& room) {
        const Vector<Floor> along{std::cos(style_.hatched_rad), std::sin(style_.hatched_rad)};
        const Vector<Floor> across{-along.y, along.x};
        const Point<Floor> middle = room.min + 0.5 * (room.max - room.min);
        const double half_m =
            0.5 * std::min(room.max.x - room.min.x, room.max.y - room.min.y) - 0.4;
        for (double offset = -half_m; offset <= half_m; offset += 0.6) {
            const double reach = std::sqrt(std::max(0.0, half_m * half_m - offset * offset));
            line({middle + offset * across + (-reach) * along,
                  middle + offset * across + reach * along});
        }
    }

    void text(const std::string& words, Point<Floor> at) {
        const double scale = 0.75 / style_.resolution_m * kFiner / 21.0;
        const cv::Point corner = finePoints({at})[0] / 16;
        cv::putText(ink_, words, corner, cv::FONT_HERSHEY_SIMPLEX, scale, cv::Scalar(255),
                    finePen());
    }

    PlanLevel onPaper() {
        cv::Mat grey;
        cv::resize(~ink_, grey, size_, 0.0, 0.0, cv::INTER_AREA);
        grey = style_.light_on_dark ? cv::Mat(235 - grey * (205.0 / 255.0))
                                    : cv::Mat(40 + grey * (205.0 / 255.0));
        if (style_.skewed_rad != 0.0) {
            const cv::Matx23d lean(1.0, std::tan(style_.skewed_rad), 0.0, 0.0, 1.0, 0.0);
            cv::warpAffine(grey, grey, lean, grey.size(), cv::INTER_AREA, cv::BORDER_REPLICATE);
        }
        if (style_.photographed) grey = photographed(grey);
        for (int row = 0; row < grey.rows; ++row) {
            for (int column = 0; column < grey.cols; ++column) age(grey, row, column);
        }
        if (style_.jpeg_quality > 0) {
            std::vector<std::uint8_t> bytes;
            cv::imencode(".jpg", grey, bytes, {cv::IMWRITE_JPEG_QUALITY, style_.jpeg_quality});
            grey = cv::imdecode(bytes, cv::IMREAD_GRAYSCALE);
        }
        return {grey.cols, grey.rows, 1,
                std::make_shared<std::vector<std::uint8_t>>(grey.datastart, grey.dataend)};
    }

  private:
    int finePen() const { return static_cast<int>(std::lround(kPen_px * kFiner)); }

    std::vector<cv::Point> finePoints(const Corners& corners) const {
        std::vector<cv::Point> points;
        for (const Point<Floor>& corner : corners) {
            const Point<Plan> p = from_floor_ * corner;
            points.emplace_back(cvRound(16.0 * (kFiner * p.x - 0.5)),
                                cvRound(16.0 * (kFiner * p.y - 0.5)));
        }
        return points;
    }

    cv::Mat photographed(const cv::Mat& grey) {
        const auto w = static_cast<float>(grey.cols);
        const auto h = static_cast<float>(grey.rows);
        const std::vector<cv::Point2f> sheet{{0, 0}, {w, 0}, {w, h}, {0, h}};
        std::vector<cv::Point2f> photo{
            {0.15F * w, 0.1F * h}, {0.9F * w, 0}, {w, h}, {0, 0.85F * h}};
        cv::Mat picture;
        cv::warpPerspective(grey, picture, cv::getPerspectiveTransform(sheet, photo), grey.size(),
                            cv::INTER_LINEAR, cv::BORDER_CONSTANT, grey.at<std::uint8_t>(0, 0));
        for (cv::Point2f& corner : photo) {
            corner.x += static_cast<float>(random_.uniform(-1.0, 1.0));
            corner.y += static_cast<float>(random_.uniform(-1.0, 1.0));
        }
        cv::Mat rectified;
        cv::warpPerspective(picture, rectified, cv::getPerspectiveTransform(photo, sheet),
                            grey.size(), cv::INTER_LINEAR, cv::BORDER_REPLICATE);
        return rectified;
    }

    void age(cv::Mat& grey, int row, int column) {
        auto& value = grey.at<std::uint8_t>(row, column);
        const double way =
            0.5 * (static_cast<double>(row) / grey.rows + static_cast<double>(column) / grey.cols);
        const double noise = style_.noise > 0.0 ? style_.noise * random_.normal() : 0.0;
        value = cv::saturate_cast<std::uint8_t>(value * (1.0 - style_.shade * way) + noise);
    }

    SheetStyle style_;
    Transform<Plan, Floor> from_floor_;
    Random random_;
    cv::Size size_;
    cv::Mat ink_;  // 255 where there is any, kFiner times the size
};

// The gap between a wall and the one that continues it.
std::optional<std::array<Point<Floor>, 2>> doorBetween(const Wall& wall, const Wall& next) {
    const Vector<Floor> along = (1.0 / (wall.to - wall.from).length()) * (wall.to - wall.from);
    const Vector<Floor> gap = next.from - wall.to;
    const double length_m = along.x * gap.x + along.y * gap.y;
    const double aside_m = along.x * gap.y - along.y * gap.x;
    if (std::abs(aside_m) > 1e-9 || length_m <= 0.0 || length_m > kWidestDoor_m) return {};
    const Vector<Floor> frame = (0.5 * wall.thickness_m) * along;
    return std::array{wall.to + frame, next.from + (-1.0) * frame};
}

}  // namespace

FloorPlan office() {
    FloorPlan floor;
    const auto row = [&](double outer_y, double inner_y, int rooms) {
        const double width = 20.0 / rooms;
        double begin = 0.0;
        for (int i = 0; i < rooms; ++i) {
            const double left = i * width;
            const std::string name = (outer_y > inner_y ? "2" : "1") + std::to_string(i);
            floor.rooms.push_back({name,
                                   {left, std::min(outer_y, inner_y)},
                                   {left + width, std::max(outer_y, inner_y)}});
            if (i > 0) floor.walls.push_back({{left, outer_y}, {left, inner_y}, 0.12});
        }
        for (int i = 0; i < rooms; ++i) {
            const double door = (i + 0.6) * width;
            floor.walls.push_back({{begin, inner_y}, {door - 0.5, inner_y}, 0.12});
            begin = door + 0.5;
        }
        floor.walls.push_back({{begin, inner_y}, {20.0, inner_y}, 0.12});
        floor.walls.push_back({{0.0, outer_y}, {20.0, outer_y}, 0.3});
    };
    row(0.0, 5.0, 4);
    row(12.0, 7.0, 3);
    floor.walls.push_back({{0.0, 0.0}, {0.0, 12.0}, 0.3});
    floor.walls.push_back({{20.0, 0.0}, {20.0, 12.0}, 0.3});
    return floor;
}

Transform<Plan, Floor> sheetFromFloor(const FloorPlan& floor, const SheetStyle& style) {
    Eigen::Matrix2d turn;
    turn << std::cos(style.turned_rad), -std::sin(style.turned_rad), -std::sin(style.turned_rad),
        -std::cos(style.turned_rad);
    const Eigen::Matrix2d linear = turn / style.resolution_m;
    Eigen::Vector2d corner(1e9, 1e9);
    for (const Wall& wall : floor.walls) {
        for (const Point<Floor>& p : cornersOf(wall)) {
            corner = corner.cwiseMin(linear * Eigen::Vector2d(p.x, p.y));
        }
    }
    return {linear, Eigen::Vector2d::Constant(kMargin_m / style.resolution_m) - corner};
}

PlanImage drawnSheet(const FloorPlan& floor, const SheetStyle& style) {
    Sheet sheet(floor, style);
    sheet.walls(floor);
    for (std::size_t i = 0; style.doors && i + 1 < floor.walls.size(); ++i) {
        if (const auto door = doorBetween(floor.walls[i], floor.walls[i + 1])) {
            sheet.door((*door)[0], (*door)[1]);
        }
    }
    for (const Room& room : floor.rooms) {
        for (int i = 1; style.furniture && i < 4; ++i) sheet.furniture(room, i);
        if (style.hatched_rad != 0.0) sheet.hatching(room);
        if (style.texts) sheet.text(room.name, room.min + 0.2 * (room.max - room.min));
    }
    return {{}, mipPyramid(sheet.onPaper()), {style.resolution_m, {}}};
}

}  // namespace hedr
