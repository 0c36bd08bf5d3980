#include "radio/simulated_robot.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/fusion/hedr.h"
#include "core/geometry/angle.h"
#include "core/robot/wheel_motion.h"

namespace hedr {

namespace {

constexpr double kPosePeriod_s = 0.05;
constexpr double kSlowPeriod_s = 1.0;  // hello and status
constexpr double kHeadingUnitsPerTurn = 1048576.0;
constexpr double kBattery_v = 24.0;

using FrameBuffer = std::array<std::uint8_t, HEDR_FRAME_MAX>;

std::int32_t micro(double value) { return static_cast<std::int32_t>(std::lround(value * 1e6)); }

std::int32_t milli(double value) { return static_cast<std::int32_t>(std::lround(value * 1e3)); }

std::int32_t headingUnits(double rad) {
    return static_cast<std::int32_t>(std::lround(rad / (2.0 * kPi) * kHeadingUnitsPerTurn));
}

hedr_config configOf(const Vehicle& vehicle, const Pose<World>& start) {
    hedr_config config = hedr_default_config();
    config.left_wheel_diameter_um = micro(vehicle.geometry.left_wheel_diameter_m);
    config.right_wheel_diameter_um = micro(vehicle.geometry.right_wheel_diameter_m);
    config.wheelbase_um = micro(vehicle.geometry.wheelbase_m);
    config.ticks_per_revolution_milli = milli(vehicle.geometry.ticks_per_revolution);
    config.hedr_gain_urad_s2 = micro(hedrPreset(vehicle.heading_source).gain_rad_s2);
    config.dominant_offset = headingUnits(start.heading_rad);
    config.heading_source =
        vehicle.heading_source == HeadingSource::kGyro ? HEDR_SOURCE_GYRO : HEDR_SOURCE_ENCODERS;
    return config;
}

// The wire has 32-bit counters that wrap.
std::int32_t wireCount(double ticks) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(std::llround(ticks)));
}

// The wire has whole numbers in the sensor's own unit: those of the log where they are as fine as
// counts, and thousandths of it (gauss, perhaps) elsewhere.
double magnetometerScale(const Vehicle& vehicle) {
    constexpr double kLeastCounts = 50.0;
    const bool counts =
        vehicle.magnetometer && std::abs(vehicle.magnetometer->range_x) >= kLeastCounts;
    return counts ? 1.0 : 1e3;
}

std::int16_t magnetometerUnits(double value) {
    return static_cast<std::int16_t>(std::lround(std::clamp(value, -32767.0, 32767.0)));
}

void sendFrame(const FrameBuffer& frame, std::uint8_t size, const SimulatedRobot::Send& send) {
    send(std::span(frame).first(size));
}

}  // namespace

SimulatedRobot::SimulatedRobot(const Vehicle& vehicle, const Pose<World>& start)
    : vehicle_(vehicle) {
    boot(start);
}

void SimulatedRobot::boot(const Pose<World>& start) {
    ++boot_id_;
    hedr_decoder_init(&decoder_);
    const hedr_config config = configOf(vehicle_, start);
    hedr_robot_init(&robot_, &config);
    hedr_robot_reset_pose(&robot_, milli(start.position.x), milli(start.position.y),
                          headingUnits(start.heading_rad));
}

void SimulatedRobot::restart() {
    sequence_ = 0;
    left_ticks_ = 0.0;
    right_ticks_ = 0.0;
    last_odometry_ = std::monostate{};
    next_pose_s_ = 0.0;
    next_slow_s_ = 0.0;
    time_zero_s_.reset();
    boot({});
}

void SimulatedRobot::sense(const SensorReport& report, const Send& send) {
    // The first life keeps the log's own times, so that tracks can be compared with its truth.
    if (!time_zero_s_) {
        time_zero_s_ = boot_id_ == 1 ? 0.0 : report.robot_time_s;
        next_pose_s_ = next_slow_s_ = report.robot_time_s - *time_zero_s_;
    }
    time_s_ = report.robot_time_s - *time_zero_s_;
    count(report.odometry);
    const auto* rate = std::get_if<GyroRate>(&report.gyro);
    has_gyro_ = rate != nullptr;
    has_magnetometer_ = has_magnetometer_ || report.magnetic_field;
    const auto time_us = static_cast<std::uint32_t>(std::llround(time_s_ * 1e6));
    hedr_robot_update(&robot_, time_us, wireCount(left_ticks_), wireCount(right_ticks_),
                      rate ? micro(rate->rad_s) : 0);
    if (due(next_slow_s_, kSlowPeriod_s)) {
        sayHello(send);
        sayStatus(send);
    }
    if (due(next_pose_s_, kPosePeriod_s)) sayPose(send);
    saySensors(report, send);
}

bool SimulatedRobot::due(double& next_s, double period_s) const {
    constexpr double kRounding_s = 1e-6;
    if (time_s_ < next_s - kRounding_s) return false;
    next_s = std::max(next_s + period_s, time_s_ - period_s);
    return true;
}

void SimulatedRobot::count(const Odometry& odometry) {
    if (std::holds_alternative<std::monostate>(odometry)) return;
    const WheelMotion wheels = wheelMotionBetween(last_odometry_, odometry, vehicle_);
    last_odometry_ = odometry;
    const VehicleGeometry& geometry = vehicle_.geometry;
    const double ticks_per_m_of_1_m_wheel = geometry.ticks_per_revolution / kPi;
    const double half_m = 0.5 * geometry.wheelbase_m * wheels.turn_rad.value_or(0.0);
    left_ticks_ +=
        (wheels.distance_m - half_m) * ticks_per_m_of_1_m_wheel / geometry.left_wheel_diameter_m;
    right_ticks_ +=
        (wheels.distance_m + half_m) * ticks_per_m_of_1_m_wheel / geometry.right_wheel_diameter_m;
}

void SimulatedRobot::sayHello(const Send& send) {
    const hedr_hello hello{
        .boot_id = boot_id_,
        .capabilities = static_cast<std::uint16_t>(
            kCapabilityHedr | kCapabilityRequests | (has_gyro_ ? kCapabilityGyro : 0) |
            (has_magnetometer_ ? kCapabilityMagnetometer : 0)),
        .left_wheel_diameter_um = static_cast<std::uint32_t>(robot_.config.left_wheel_diameter_um),
        .right_wheel_diameter_um =
            static_cast<std::uint32_t>(robot_.config.right_wheel_diameter_um),
        .wheelbase_um = static_cast<std::uint32_t>(robot_.config.wheelbase_um),
        .ticks_per_revolution_milli =
            static_cast<std::uint32_t>(robot_.config.ticks_per_revolution_milli),
        .heading_source = robot_.config.heading_source,
        .vehicle = vehicle_.name.c_str(),
        .firmware = "simulated",
    };
    FrameBuffer frame{};
    sendFrame(frame, hedr_encode_hello(frame.data(), sequence_++, &hello), send);
}

void SimulatedRobot::sayStatus(const Send& send) {
    const hedr_status status{.battery_mv = static_cast<std::uint16_t>(milli(kBattery_v)),
                             .faults = 0,
                             .radio_dbm = HEDR_NO_RADIO};
    FrameBuffer frame{};
    sendFrame(frame, hedr_encode_status(frame.data(), sequence_++, &status), send);
}

void SimulatedRobot::sayPose(const Send& send) {
    const hedr_pose pose = hedr_robot_pose(&robot_);
    FrameBuffer frame{};
    sendFrame(frame, hedr_encode_pose(frame.data(), sequence_++, &pose), send);
}

void SimulatedRobot::saySensors(const SensorReport& report, const Send& send) {
    hedr_sensors sensors = hedr_robot_sensors(&robot_);
    sensors.has_gyro = has_gyro_;
    if (report.temperature_c) {
        sensors.temperature_centi_c =
            static_cast<std::int16_t>(std::lround(*report.temperature_c * 100.0));
    }
    if (const auto& field = report.magnetic_field) {
        sensors.has_magnetometer = 1;
        const double scale = magnetometerScale(vehicle_);
        const std::array axes{field->x, field->y, field->z};
        for (std::size_t i = 0; i < axes.size(); ++i) {
            sensors.magnetometer[i] = magnetometerUnits(scale * axes[i]);
        }
    }
    FrameBuffer frame{};
    sendFrame(frame, hedr_encode_sensors(frame.data(), sequence_++, &sensors), send);
}

void SimulatedRobot::hear(std::span<const std::uint8_t> bytes, const Send& send) {
    for (const std::uint8_t byte : bytes) {
        hedr_request request{};
        if (!hedr_decoder_push(&decoder_, byte, &request)) continue;
        FrameBuffer frame{};
        const auto time_us = static_cast<std::uint32_t>(std::llround(time_s_ * 1e6));
        sendFrame(frame, hedr_robot_answer(&robot_, &request, time_us, frame.data(), sequence_++),
                  send);
    }
}

}  // namespace hedr
