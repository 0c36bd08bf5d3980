#include "radio/wire/text_line/text_reporter.h"

#include <cmath>

#include "core/geometry/angle.h"

namespace hedr {
namespace {

using enum TextQuantity;

constexpr double kHelloPeriod_s = 1.0;

// All three, where they are there.
template <class Triple>
std::optional<Triple> tripleOf(const TextSample& sample, TextQuantity a, TextQuantity b,
                               TextQuantity c) {
    if (!sample[a] || !sample[b] || !sample[c]) return std::nullopt;
    return Triple{*sample[a], *sample[b], *sample[c]};
}

std::optional<OdometryPose> poseOf(const TextSample& sample) {
    return tripleOf<OdometryPose>(sample, kX, kY, kHeading);
}

// The order of sensors.csv: what says most comes first.
Odometry odometryOf(const TextSample& sample) {
    if (sample[kLeftTicks] && sample[kRightTicks]) {
        return WheelTicks{static_cast<std::int64_t>(*sample[kLeftTicks]),
                          static_cast<std::int64_t>(*sample[kRightTicks])};
    }
    if (sample[kLeftTravel] && sample[kRightTravel]) {
        return WheelTravel{*sample[kLeftTravel], *sample[kRightTravel]};
    }
    if (const auto pose = poseOf(sample)) return *pose;
    if (sample[kDistance]) return PathTravel{*sample[kDistance]};
    return {};
}

}  // namespace

void TextReporter::learn(const TextLayout& layout) {
    const std::uint16_t before = capabilities_;
    if (layout.hasGyro()) capabilities_ |= kCapabilityGyro;
    if (layout.hasMagnetometer()) capabilities_ |= kCapabilityMagnetometer;
    if (layout.has(kTemperature)) capabilities_ |= kCapabilityTemperature;
    if (capabilities_ != before) hello_time_s_.reset();
}

void TextReporter::restart() {
    ++boot_id_;
    hello_time_s_.reset();
}

HelloReport TextReporter::hello() const {
    HelloReport hello;
    hello.boot_id = boot_id_;
    hello.capabilities = static_cast<std::uint16_t>(capabilities_ | kCapabilityNoGeometry);
    hello.heading_source =
        (capabilities_ & kCapabilityGyro) != 0 ? HeadingSource::kGyro : HeadingSource::kEncoders;
    hello.vehicle = "text robot";
    return hello;
}

// A heading without a position is that of an IMU: an integrated gyro, so it is reported as one.
// Beside a position it may come from the wheels and says nothing new.
Gyro TextReporter::gyroOf(const TextSample& sample) {
    if (const auto rate = sample[kYawRate]) return GyroRate{*rate};
    if (sample[kHeading] && !poseOf(sample)) return follow(*sample[kHeading]);
    return {};
}

// An IMU's heading jumps at a whole turn, which is no multiple of 2^32 microradians.
GyroAngle TextReporter::follow(double heading_rad) {
    turned_rad_ += wrapAngle(heading_rad - last_heading_rad_.value_or(heading_rad));
    last_heading_rad_ = heading_rad;
    return {static_cast<std::uint32_t>(std::llround(1e6 * turned_rad_))};
}

void TextReporter::report(const TextSample& sample, double robot_time_s,
                          const OnReport& on_report) {
    if (!hello_time_s_ || robot_time_s - *hello_time_s_ >= kHelloPeriod_s) {
        hello_time_s_ = robot_time_s;
        on_report(hello());
        if (const auto battery = sample[kBattery]) on_report(StatusReport{.battery_v = *battery});
    }
    if (const auto pose = poseOf(sample)) {
        on_report(PoseReport{.robot_time_s = robot_time_s,
                             .pose = {{pose->x_m, pose->y_m}, pose->heading_rad},
                             .yaw_rate_rad_s = sample[kYawRate].value_or(0.0)});
    }
    on_report(SensorReport{.robot_time_s = robot_time_s,
                           .odometry = odometryOf(sample),
                           .gyro = gyroOf(sample),
                           .temperature_c = sample[kTemperature],
                           .magnetic_field = tripleOf<MagneticField>(sample, kMagX, kMagY, kMagZ)});
}

}  // namespace hedr
