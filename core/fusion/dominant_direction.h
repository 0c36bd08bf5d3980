#pragma once

#include <complex>
#include <optional>

namespace hedr {

// Learns where the building's dominant directions lie from the headings of the first straight
// drives: the mean, weighted by distance, on a circle on which all of them coincide.
class DominantDirection {
  public:
    // `known_rad`: heading of one dominant direction, where it need not be learnt.
    DominantDirection(double interval_rad, std::optional<double> known_rad);

    // A piece of straight driving.
    void observe(double heading_rad, double distance_m);

    bool known() const { return known_; }
    // Signed angle from the nearest dominant direction to `heading_rad`; only when known.
    double deviation_rad(double heading_rad) const;

  private:
    double interval_rad_;
    bool known_ = false;
    double direction_rad_ = 0.0;
    double weight_m_ = 0.0;
    double total_m_ = 0.0;
    std::complex<double> sum_m_{};
};

}  // namespace hedr
