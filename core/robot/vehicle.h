#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace hedr {

enum class HeadingSource : unsigned char { kGyro, kEncoders };

struct VehicleGeometry {
    double left_wheel_diameter_m = 0.2;
    double right_wheel_diameter_m = 0.2;
    double wheelbase_m = 0.4;
    double ticks_per_revolution = 1000.0;
    friend bool operator==(const VehicleGeometry&, const VehicleGeometry&) = default;
};

// How the bias of a gyro drifts while it warms up, t seconds after it was switched on:
// C1 (1 - exp(-t / T)) + C2.
struct GyroDrift {
    double c1_rad_s = 0.0;
    double c2_rad_s = 0.0;
    double time_s = 300.0;  // T
    friend bool operator==(const GyroDrift&, const GyroDrift&) = default;
};

// The middle and half the range of the field's horizontal components over a full rotation, in the
// sensor's own unit. A negative range is that of an axis mounted the other way. The correlation is
// that of both components over their ranges: of an ellipse that lies askew; 0: along the axes.
struct MagnetometerRange {
    double centre_x = 0.0;
    double centre_y = 0.0;
    double range_x = 1.0;
    double range_y = 1.0;
    double correlation = 0.0;  // between -1 and 1
    friend bool operator==(const MagnetometerRange&, const MagnetometerRange&) = default;
};

// How a robot prints its text lines, where they do not say it themselves (docs/text_robots.md).
struct TextLineFormat {
    std::vector<std::string> columns{};  // names with units, in order; empty: a header line's
    std::optional<double> rate_hz{};     // lines per second, of a robot that prints no time
    friend bool operator==(const TextLineFormat&, const TextLineFormat&) = default;
};

// Everything that must be known of a robot to compute its pose from its sensors.
struct Vehicle {
    std::string name = "robot";
    VehicleGeometry geometry{};
    HeadingSource heading_source = HeadingSource::kGyro;
    int encoder_counter_bits = 32;            // the counter wraps at 2^bits
    double gyro_scale = 1.0;                  // true rate per reported rate
    std::optional<double> gyro_bias_rad_s{};  // none: measured while standing at the start
    double gyro_noise_rad_s_sqrthz = 0.0;     // angle random walk, rad/s/sqrt(Hz)
    double gyro_bias_walk_rad_s_sqrts = 0.0;  // rate random walk, rad/s/sqrt(s)
    std::optional<GyroDrift> gyro_drift{};
    std::optional<MagnetometerRange> magnetometer{};
    double max_speed_m_s = 5.0;  // a faster sample is a broken one
    std::optional<TextLineFormat> text{};
    friend bool operator==(const Vehicle&, const Vehicle&) = default;
};

// Reads a vehicle.toml. Errors: kFileMissing, kBadFormat (with the line), kMissingKey, kBadValue.
// An unknown key is an error too: a misspelt parameter must not pass silently.
Result<Vehicle> loadVehicle(const std::filesystem::path& file);
Result<Vehicle> parseVehicle(std::string_view toml, const std::string& name_for_errors);

// The same as text; parseVehicle(formatVehicle(v)) == v, to the last bit.
std::string formatVehicle(const Vehicle& vehicle);

// A number of the vehicle file by its key; none where the file does not say it, or has no such key.
std::optional<double> vehicleNumber(const Vehicle& vehicle, std::string_view key);

// Errors: kUnknownName, kBadValue (as in a file), with the vehicle as it was.
Result<void> setVehicleNumber(Vehicle& vehicle, std::string_view key, double value);

// A vehicle.toml, or the preset of that name where there is no such file.
Result<Vehicle> loadVehicleOrPreset(const std::string& file_or_preset);

// Presets shipped in assets/vehicles: packbot, labmate, romi.
std::vector<Vehicle> vehiclePresets();

}  // namespace hedr
