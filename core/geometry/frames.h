#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <cmath>

namespace hedr {

// A coordinate says its frame in its type, so that a wrong order of transforms does not compile.
struct World {};  // metres, x right, y up; the mission's ground plane
struct Robot {};  // metres, x forward, y left
struct Plan {};   // pixels of a plan image, x right, y down, (0, 0) the outer top left corner
struct View {};   // pixels of a widget, x right, y down

template <class Frame>
struct Vector {
    double x = 0.0;
    double y = 0.0;

    double length() const { return std::hypot(x, y); }
    friend Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y}; }
    friend Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y}; }
    friend Vector operator*(double s, Vector a) { return {s * a.x, s * a.y}; }
    friend bool operator==(const Vector&, const Vector&) = default;
};

template <class Frame>
struct Point {
    double x = 0.0;
    double y = 0.0;

    friend Point operator+(Point p, Vector<Frame> v) { return {p.x + v.x, p.y + v.y}; }
    friend Vector<Frame> operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
    friend bool operator==(const Point&, const Point&) = default;
};

// A position and a heading in Frame: counter-clockwise positive, 0 along +x, not wrapped, so that
// the number of full turns survives.
template <class Frame>
struct Pose {
    Point<Frame> position{};
    double heading_rad = 0.0;

    friend bool operator==(const Pose&, const Pose&) = default;
};

// An affine map of coordinates: to_from * Point<From> is a Point<To>.
template <class To, class From>
class Transform {
  public:
    Transform() = default;
    Transform(const Eigen::Matrix2d& linear, const Eigen::Vector2d& offset)
        : linear_(linear), offset_(offset) {}

    Point<To> operator*(Point<From> p) const {
        return {linear_(0, 0) * p.x + linear_(0, 1) * p.y + offset_.x(),
                linear_(1, 0) * p.x + linear_(1, 1) * p.y + offset_.y()};
    }
    Vector<To> operator*(Vector<From> v) const {
        return {linear_(0, 0) * v.x + linear_(0, 1) * v.y,
                linear_(1, 0) * v.x + linear_(1, 1) * v.y};
    }
    template <class Inner>
    Transform<To, Inner> operator*(const Transform<From, Inner>& inner) const {
        return {linear_ * inner.linear(), linear_ * inner.offset() + offset_};
    }
    Transform<From, To> inverse() const {
        const Eigen::Matrix2d back = linear_.inverse();
        return {back, -back * offset_};
    }
    // Units of To per unit of From, where the map is a similarity.
    double scale() const { return std::sqrt(std::abs(linear_.determinant())); }

    const Eigen::Matrix2d& linear() const { return linear_; }
    const Eigen::Vector2d& offset() const { return offset_; }

  private:
    Eigen::Matrix2d linear_ = Eigen::Matrix2d::Identity();
    Eigen::Vector2d offset_ = Eigen::Vector2d::Zero();
};

// Turns and shifts only: rigidTransform<World, Robot>(pose_in_world) is world_from_robot.
template <class To, class From>
Transform<To, From> rigidTransform(const Pose<To>& from_origin_in_to) {
    const double c = std::cos(from_origin_in_to.heading_rad);
    const double s = std::sin(from_origin_in_to.heading_rad);
    Eigen::Matrix2d rotation;
    rotation << c, -s, s, c;
    return {rotation, {from_origin_in_to.position.x, from_origin_in_to.position.y}};
}

}  // namespace hedr
