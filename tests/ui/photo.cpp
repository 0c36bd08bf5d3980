#include "tests/ui/photo.h"

#include <Eigen/Geometry>
#include <cmath>

#include "core/geometry/angle.h"
#include "core/site/mip_pyramid.h"
#include "core/site/survey/perspective.h"
#include "tests/ui/scene.h"

namespace hedr::test {
namespace {

constexpr int kWidth_px = 1200;
constexpr int kHeight_px = 900;
constexpr double kPaper = 1.12;  // as wide as the drawing
constexpr std::uint8_t kTable = 70;
constexpr std::uint8_t kWhite = 235;

Point<Plan> seen(double x, double y) {
    constexpr double kFocal_px = 1100.0;
    const Eigen::Matrix3d turned = (Eigen::AngleAxisd(radFromDeg(-38.0), Eigen::Vector3d::UnitX()) *
                                    Eigen::AngleAxisd(radFromDeg(14.0), Eigen::Vector3d::UnitY()) *
                                    Eigen::AngleAxisd(radFromDeg(5.0), Eigen::Vector3d::UnitZ()))
                                       .toRotationMatrix();
    const Eigen::Vector3d at = turned * Eigen::Vector3d(x, y, 0.0) + Eigen::Vector3d(0, 0.05, 1.9);
    return {kWidth_px / 2.0 + kFocal_px * at.x() / at.z(),
            kHeight_px / 2.0 + kFocal_px * at.y() / at.z()};
}

std::uint8_t paperAt(const PlanLevel& drawing, Point<UnitSquare> p) {
    const double x = 0.5 + kPaper * (p.x - 0.5);
    const double y = 0.5 + kPaper * (p.y - 0.5);
    if (x < 0.0 || y < 0.0 || x >= 1.0 || y >= 1.0) return kWhite;
    const int column = static_cast<int>(x * drawing.width_px);
    const int row = static_cast<int>(y * drawing.height_px);
    const auto index = static_cast<std::size_t>(row) * static_cast<std::size_t>(drawing.width_px) +
                       static_cast<std::size_t>(column);
    return static_cast<std::uint8_t>(30 + 205 * drawing.pixels->at(index) / 255);
}

}  // namespace

Quad sheetInPhoto() {
    constexpr double kHalf = kSheetAspect / 2.0;
    return {{seen(-kHalf, -0.5), seen(kHalf, -0.5), seen(kHalf, 0.5), seen(-kHalf, 0.5)}};
}

Point<Plan> inPhoto(Point<World> on_floor) {
    const Point<UnitSquare> on_sheet{0.5 + (on_floor.x / 80.0 - 0.5) / kPaper,
                                     0.5 + (0.5 - on_floor.y / 49.0) / kPaper};
    return photoFromUnitSquare(sheetInPhoto()) * on_sheet;
}

PlanImage photographedPlan() {
    const PlanLevel drawing = samplePlan().levels.at(1);
    const auto square_from_photo = photoFromUnitSquare(sheetInPhoto()).inverse();
    std::vector<std::uint8_t> pixels;
    pixels.reserve(std::size_t{kWidth_px} * kHeight_px);
    for (int y = 0; y < kHeight_px; ++y) {
        for (int x = 0; x < kWidth_px; ++x) {
            const auto p = square_from_photo * Point<Plan>{x + 0.5, y + 0.5};
            const bool on_sheet = p.x >= 0.0 && p.y >= 0.0 && p.x < 1.0 && p.y < 1.0;
            pixels.push_back(on_sheet ? paperAt(drawing, p) : kTable);
        }
    }
    PlanImage photo;
    photo.image_file = "evacuation-plan.jpg";
    photo.levels =
        mipPyramid({kWidth_px, kHeight_px, 1,
                    std::make_shared<const std::vector<std::uint8_t>>(std::move(pixels))});
    photo.placement.resolution_m = 0.05;
    return photo;
}

}  // namespace hedr::test
