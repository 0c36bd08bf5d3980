#pragma once

namespace hedr {

// What is known of the focal length of a photo's camera.
struct FocalLength {
    double px = 0.0;     // in pixels of the full-size photo
    double sigma = 0.0;  // one standard deviation, as a share of it
    friend bool operator==(const FocalLength&, const FocalLength&) = default;
};

}  // namespace hedr
