#pragma once

#include <Eigen/Core>

#include "core/geometry/frames.h"

namespace hedr {

// The covariance of a pose that is reckoned step by step. The heading's error has a part that comes
// anew with every step and a drift: an unknown constant, for example a gyro's bias.
class PoseCovariance {
  public:
    // What one step adds to the uncertainty.
    struct Step {
        double along_m2 = 0.0;
        double turn_rad2 = 0.0;
        double drift_share = 0.0;  // of the drift that goes into the heading, for a bias the time
        double drift_variance = 0.0;  // by which the drift itself walks
        double heading_kept = 1.0;    // of the heading's error before the step
    };

    explicit PoseCovariance(double drift_variance = 0.0) : var_drift_(drift_variance) {}

    void move(Vector<World> way, const Step& step) {
        shear(way);
        stretch(way, step.along_m2);
        turn(step);
    }
    double heading_rad2() const { return var_heading_; }
    Eigen::Matrix3d matrix() const {
        Eigen::Matrix3d matrix;
        matrix << var_x_, cov_xy_, cov_xh_,  //
            cov_xy_, var_y_, cov_yh_,        //
            cov_xh_, cov_yh_, var_heading_;
        return matrix;
    }

  private:
    // A heading error moves the end of the way sideways.
    void shear(Vector<World> way) {
        var_x_ += way.y * (way.y * var_heading_ - 2.0 * cov_xh_);
        cov_xy_ += way.x * cov_xh_ - way.y * cov_yh_ - way.x * way.y * var_heading_;
        var_y_ += way.x * (way.x * var_heading_ + 2.0 * cov_yh_);
        cov_xh_ -= way.y * var_heading_;
        cov_yh_ += way.x * var_heading_;
        cov_xd_ -= way.y * cov_hd_;
        cov_yd_ += way.x * cov_hd_;
    }
    void stretch(Vector<World> way, double along_m2) {
        const double squared_m2 = way.x * way.x + way.y * way.y;
        if (squared_m2 < 1e-24) return;
        const double share = along_m2 / squared_m2;
        var_x_ += share * way.x * way.x;
        cov_xy_ += share * way.x * way.y;
        var_y_ += share * way.y * way.y;
    }
    void turn(const Step& step) {
        const double keep = step.heading_kept;
        const double share = step.drift_share;
        var_heading_ = keep * keep * var_heading_ + 2.0 * keep * share * cov_hd_ +
                       share * share * var_drift_ + step.turn_rad2;
        cov_xh_ = keep * cov_xh_ + share * cov_xd_;
        cov_yh_ = keep * cov_yh_ + share * cov_yd_;
        cov_hd_ = keep * cov_hd_ + share * var_drift_;
        var_drift_ += step.drift_variance;
    }

    double var_x_ = 0.0;
    double cov_xy_ = 0.0;
    double var_y_ = 0.0;
    double cov_xh_ = 0.0;
    double cov_yh_ = 0.0;
    double var_heading_ = 0.0;
    double cov_xd_ = 0.0;  // with the drift
    double cov_yd_ = 0.0;
    double cov_hd_ = 0.0;
    double var_drift_;
};

}  // namespace hedr
