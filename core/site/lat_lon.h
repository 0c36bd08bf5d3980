#pragma once

namespace hedr {

struct LatLon {
    double latitude_deg = 0.0;   // WGS 84, north positive
    double longitude_deg = 0.0;  // east positive
    friend bool operator==(const LatLon&, const LatLon&) = default;
};

}  // namespace hedr
