#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <random>
#include <vector>

#include "core/geometry/angle.h"
#include "core/site/plan.h"
#include "core/site/survey/quad.h"

namespace hedr::test {

struct Table {};  // metres on the table that a sheet lies on, x right, y down, (0, 0) its middle

// A pinhole camera above a table, with what a phone adds to that.
struct PhoneCamera {
    int width_px = 1200;
    int height_px = 900;
    double focal_mm = 27.0;       // on film of 24 x 36 mm
    Vector<Plan> principal_px{};  // the principal point's offset from the middle
    double k1 = 0.0;              // radial lens distortion
    double tilt_rad = 0.0;
    double azimuth_rad = 0.0;  // of the tilt's axis on the table
    double roll_rad = 0.0;
    double distance_m = 0.5;
    Point<Table> aim{};

    double focal_px() const { return focal_mm / 43.267 * std::hypot(width_px, height_px); }
    Eigen::Matrix3d cameraFromTable() const {
        const auto turn = [](double angle, const Eigen::Vector3d& axis) {
            return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
        };
        return turn(roll_rad, Eigen::Vector3d::UnitZ()) *
               turn(tilt_rad, {std::cos(azimuth_rad), std::sin(azimuth_rad), 0.0});
    }
    Point<Plan> seen(Point<Table> p) const {
        Eigen::Vector3d at = cameraFromTable() * Eigen::Vector3d(p.x - aim.x, p.y - aim.y, 0.0);
        at.z() += distance_m;
        const Eigen::Vector2d ray = at.hnormalized();
        return pixel((1.0 + k1 * ray.squaredNorm()) * ray);
    }
    Point<Table> onTable(Point<Plan> p, const Eigen::Matrix3d& table_from_camera) const {
        const Eigen::Vector2d bent((p.x - 0.5 * width_px - principal_px.x) / focal_px(),
                                   (p.y - 0.5 * height_px - principal_px.y) / focal_px());
        Eigen::Vector2d ray = bent;
        for (int round = 0; round < 6 && k1 != 0.0; ++round) {
            ray = bent / (1.0 + k1 * ray.squaredNorm());
        }
        const Eigen::Vector3d eye = table_from_camera * Eigen::Vector3d(0.0, 0.0, -distance_m);
        const Eigen::Vector3d way = table_from_camera * ray.homogeneous();
        const Eigen::Vector3d hit = eye - eye.z() / way.z() * way;
        return {aim.x + hit.x(), aim.y + hit.y()};
    }

  private:
    Point<Plan> pixel(const Eigen::Vector2d& ray) const {
        return {0.5 * width_px + principal_px.x + focal_px() * ray.x(),
                0.5 * height_px + principal_px.y + focal_px() * ray.y()};
    }
};

inline Quad quadOf(const PhoneCamera& camera, double width_m, double height_m) {
    const double x = 0.5 * width_m;
    const double y = 0.5 * height_m;
    return {
        {camera.seen({-x, -y}), camera.seen({x, -y}), camera.seen({x, y}), camera.seen({-x, y})}};
}

// The camera, gone away until the whole sheet is in the picture, with a margin.
inline PhoneCamera framing(PhoneCamera camera, double width_m, double height_m) {
    const double margin_px = 0.04 * camera.width_px;
    const auto outside = [&](Point<Plan> p) {
        return p.x < margin_px || p.y < margin_px || p.x > camera.width_px - margin_px ||
               p.y > camera.height_px - margin_px;
    };
    camera.distance_m = 0.6 * std::max(width_m, height_m);
    while (std::ranges::any_of(quadOf(camera, width_m, height_m).corners, outside)) {
        camera.distance_m *= 1.02;
    }
    return camera;
}

// What the camera sees of `brightness`, a function of Point<Table> that gives 0..255; each pixel
// the mean of `finer` x `finer` rays. `light`, a function of Point<Plan>, dims it.
template <class Brightness, class Light>
PlanLevel photoOf(const PhoneCamera& camera, const Brightness& brightness, const Light& light,
                  double noise, unsigned seed, int finer) {
    auto pixels = std::make_shared<std::vector<std::uint8_t>>();
    pixels->reserve(static_cast<std::size_t>(camera.width_px * camera.height_px));
    std::minstd_rand random(seed + 1);
    std::normal_distribution<double> grain(0.0, noise);
    const Eigen::Matrix3d table_from_camera = camera.cameraFromTable().transpose();
    for (int y = 0; y < camera.height_px; ++y) {
        for (int x = 0; x < camera.width_px; ++x) {
            double sum = 0.0;
            for (int i = 0; i < finer * finer; ++i) {
                const Point<Plan> p{x + (i % finer + 0.5) / finer, y + (i / finer + 0.5) / finer};
                sum += brightness(camera.onTable(p, table_from_camera));
            }
            const double seen = sum / (finer * finer) * light(Point<Plan>{x + 0.5, y + 0.5});
            const double value = std::clamp(seen + (noise > 0.0 ? grain(random) : 0.0), 0.0, 255.0);
            pixels->push_back(static_cast<std::uint8_t>(std::lround(value)));
        }
    }
    return {camera.width_px, camera.height_px, 1, pixels};
}

}  // namespace hedr::test
