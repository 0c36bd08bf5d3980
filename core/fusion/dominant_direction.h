#pragma once

#include <complex>
#include <optional>

namespace hedr {

// Where the building's dominant directions lie. The paper takes the start heading for one of them;
// here that is a first guess, which straight drives refine while they agree with it, and overrule
// when they agree on another one. Means are weighted by distance and taken on a circle on which all
// dominant directions coincide.
class DominantDirection {
  public:
    struct Config {
        double interval_rad = 0.0;
        double start_heading_rad = 0.0;
        double settled_m = 20.0;            // after so much evidence it is left alone
        std::optional<double> known_rad{};  // heading of one corridor: nothing to learn
    };

    explicit DominantDirection(const Config& config);

    // A piece of straight driving.
    void observe(double heading_rad, double distance_m);

    // False where `heading_rad` contradicts a direction that is not settled yet.
    bool trustedAt(double heading_rad) const;
    // Signed angle from the nearest dominant direction to `heading_rad`.
    double deviation_rad(double heading_rad) const;

  private:
    struct Evidence {
        double weight_m = 0.0;
        std::complex<double> sum_m{};
    };

    void add(Evidence& evidence, double heading_rad, double length_m) const;
    void overrule();

    Config config_;
    bool settled_;
    double direction_rad_;
    Evidence agreeing_;
    Evidence contrary_;
};

}  // namespace hedr
