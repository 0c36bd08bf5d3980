#include "radio/wire/mavlink/mavlink_axes.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/angle.h"

namespace hedr {
namespace {

constexpr double kMilliUnit = 1e-3;  // mrad/s, mgauss, mV
constexpr double kCentidegree_c = 0.01;
constexpr std::uint16_t kHasGyro = 0x0020;  // HIGHRES_IMU.fields_updated: zgyro
constexpr std::uint16_t kHasMagnetometer = 0x01C0;
constexpr std::uint16_t kHasTemperature = 0x1000;

std::optional<double> finite(double value) {
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

// All zero is no field of this Earth, but what is sent where there is no magnetometer.
std::optional<MagneticField> fieldOf(double x, double y, double z, double unit) {
    const bool some = x != 0.0 || y != 0.0 || z != 0.0;
    if (!some || !std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z)) return std::nullopt;
    return MagneticField{unit * x, -unit * y, -unit * z};
}

template <class Imu>
MavlinkImu integerImu(const Imu& m) {
    MavlinkImu imu{.yaw_rate_rad_s = -kMilliUnit * m.zgyro,
                   .magnetic_field = fieldOf(m.xmag, m.ymag, m.zmag, kMilliUnit)};
    if (m.temperature != 0) imu.temperature_c = kCentidegree_c * m.temperature;
    return imu;
}

enum class Axes { kUnknown, kDown, kEastNorthUp, kForwardLeftUp };

// MAV_FRAME; 14 to 19 are older names of local frames.
Axes axesOf(std::uint8_t mav_frame) {
    switch (mav_frame) {
        case 1:   // LOCAL_NED
        case 7:   // LOCAL_OFFSET_NED
        case 14:  // MOCAP_NED
        case 16:  // VISION_NED
        case 18:  // ESTIM_NED
        case 20:  // LOCAL_FRD
            return Axes::kDown;
        case 4:   // LOCAL_ENU
        case 15:  // MOCAP_ENU
        case 17:  // VISION_ENU
        case 19:  // ESTIM_ENU
            return Axes::kEastNorthUp;
        case 21:  // LOCAL_FLU
            return Axes::kForwardLeftUp;
        default:
            return Axes::kUnknown;
    }
}

// Of rates: BODY_FRD and the older body frames point down, as do the local ones that do.
bool pointsUp(std::uint8_t child_frame) {
    constexpr std::uint8_t kBodyForwardLeftUp = 13;
    const Axes axes = axesOf(child_frame);
    return child_frame == kBodyForwardLeftUp || axes == Axes::kEastNorthUp ||
           axes == Axes::kForwardLeftUp;
}

// The direction of the body's x axis in the frame, whatever the other axes are. None: no rotation.
std::optional<double> yawOf(const std::array<float, 4>& q) {
    const auto w = static_cast<double>(q[0]);
    const auto x = static_cast<double>(q[1]);
    const auto y = static_cast<double>(q[2]);
    const auto z = static_cast<double>(q[3]);
    const double norm = w * w + x * x + y * y + z * z;
    if (!std::isfinite(norm) || norm < 0.25) return std::nullopt;
    return std::atan2(2.0 * (w * z + x * y), w * w + x * x - y * y - z * z);
}

}  // namespace

MavlinkImu imuOf(const MavlinkHighresImu& m) {
    // Some senders leave the bits at zero.
    const unsigned sent = m.fields_updated != 0 ? m.fields_updated : 0xFFFFU;
    MavlinkImu imu;
    if ((sent & kHasGyro) != 0) imu.yaw_rate_rad_s = finite(-static_cast<double>(m.zgyro));
    if ((sent & kHasTemperature) != 0)
        imu.temperature_c = finite(static_cast<double>(m.temperature));
    if ((sent & kHasMagnetometer) == kHasMagnetometer) {
        imu.magnetic_field = fieldOf(static_cast<double>(m.xmag), static_cast<double>(m.ymag),
                                     static_cast<double>(m.zmag), 1.0);
    }
    return imu;
}

MavlinkImu imuOf(const MavlinkScaledImu& m) { return integerImu(m); }
MavlinkImu imuOf(const MavlinkRawImu& m) { return integerImu(m); }

std::optional<MavlinkYaw> yawOf(const MavlinkAttitude& m) {
    if (!std::isfinite(m.yaw) || !std::isfinite(m.yawspeed)) return std::nullopt;
    return MavlinkYaw{-static_cast<double>(m.yaw), -static_cast<double>(m.yawspeed)};
}

std::optional<Point<World>> positionOf(const MavlinkLocalPositionNed& m) {
    if (!std::isfinite(m.x) || !std::isfinite(m.y)) return std::nullopt;
    return Point<World>{static_cast<double>(m.x), -static_cast<double>(m.y)};
}

std::optional<MavlinkPose> poseOf(const MavlinkOdometry& m) {
    const Axes axes = axesOf(m.frame_id);
    const std::optional<double> yaw = yawOf(m.q);
    const double x = static_cast<double>(m.x);
    const double y = static_cast<double>(m.y);
    const bool usable = yaw && std::isfinite(x) && std::isfinite(y) && m.quality >= 0;
    if (!usable || axes == Axes::kUnknown) return std::nullopt;

    MavlinkPose result;
    if (axes == Axes::kDown) result.pose = {{x, -y}, -*yaw};
    if (axes == Axes::kEastNorthUp) result.pose = {{y, -x}, wrapAngle(*yaw - kPi / 2.0)};
    if (axes == Axes::kForwardLeftUp) result.pose = {{x, y}, *yaw};
    const double rate = finite(static_cast<double>(m.yawspeed)).value_or(0.0);
    result.yaw_rate_rad_s = pointsUp(m.child_frame_id) ? rate : -rate;
    return result;
}

Odometry travelOf(const MavlinkWheelDistance& m) {
    if (m.count == 0 || !std::isfinite(m.distance[0])) return {};
    if (m.count == 1) return PathTravel{m.distance[0]};
    if (!std::isfinite(m.distance[1])) return {};
    return WheelTravel{m.distance[0], m.distance[1]};
}

std::uint16_t faultsOf(const MavlinkSysStatus& m) {
    struct Fault {
        std::uint32_t sensor;  // MAV_SYS_STATUS_SENSOR
        std::uint16_t bit;     // radio/README.md
    };
    constexpr std::array kFaults{Fault{0x00000001, 1U << 2},   // 3D_GYRO: gyro
                                 Fault{0x00008000, 1U << 4},   // MOTOR_OUTPUTS: drive
                                 Fault{0x02000000, 1U << 3}};  // BATTERY: battery low
    const std::uint32_t ill = m.onboard_control_sensors_enabled & ~m.onboard_control_sensors_health;
    unsigned faults = 0;
    for (const Fault& fault : kFaults) faults |= (ill & fault.sensor) != 0 ? fault.bit : 0U;
    return static_cast<std::uint16_t>(faults);
}

std::optional<int> radioOf(const MavlinkRadioStatus& m) {
    if (m.rssi == 255) return std::nullopt;
    return static_cast<int>(std::lround(m.rssi / 1.9 - 127.0));
}

}  // namespace hedr
