#include "radio/wire/mavlink/mavlink_choice.h"

namespace hedr {

namespace {
constexpr double kListening_s = 2.0;
}

bool MavlinkChoice::hear(MavlinkSensor sensor, std::uint8_t component, bool preferred,
                         double robot_time_s) {
    // A clock that has gone back starts the listening again.
    if (!began_s_ || robot_time_s < *began_s_) began_s_ = robot_time_s;
    if (robot_time_s - *began_s_ >= kListening_s) made_ = true;
    if (made_) return source(sensor) == component;
    if (!heard(sensor) || preferred) source(sensor) = component;
    return false;
}

std::optional<MavlinkSensor> MavlinkChoice::tick() const {
    using enum MavlinkSensor;
    if (heard(kHighresImu)) return kHighresImu;
    if (heard(kScaledImu)) return kScaledImu;
    if (heard(kRawImu) && (trusts_raw_imu_ || !heard(kAttitude))) return kRawImu;
    if (heard(kAttitude)) return kAttitude;
    if (pose()) return pose();
    if (wheels()) return kWheelDistance;
    return std::nullopt;
}

bool MavlinkChoice::gyro() const { return tick() && *tick() <= MavlinkSensor::kAttitude; }

std::optional<MavlinkSensor> MavlinkChoice::pose() const {
    using enum MavlinkSensor;
    if (heard(kOdometry)) return kOdometry;
    if (heard(kLocalPosition) && heard(kAttitude)) return kLocalPosition;
    return std::nullopt;
}

}  // namespace hedr
