#include "radio/wire/mavlink/mavlink_choice.h"

#include <algorithm>

namespace hedr {

namespace {
constexpr double kListening_s = 2.0;
}

bool MavlinkChoice::hear(MavlinkSensor sensor, std::uint8_t component, bool preferred,
                         double robot_time_s) {
    // A clock that has gone back starts the listening again.
    if (!began_s_ || robot_time_s < *began_s_) began_s_ = robot_time_s;
    if (robot_time_s - *began_s_ >= kListening_s) made_ = true;
    Source& spoke = source(sensor);
    if (made_) return spoke.component == component;
    if (!spoke.component || (preferred && spoke.component != component)) spoke = {component, 0};
    if (spoke.component == component) ++spoke.count;
    return false;
}

std::optional<MavlinkSensor> MavlinkChoice::tick() const {
    if (const auto gyro = gyroSource()) return gyro;
    if (pose()) return pose();
    if (wheels()) return MavlinkSensor::kWheelDistance;
    return std::nullopt;
}

// A rate that is heard twice a second says little of the turn between, however good it is.
std::optional<MavlinkSensor> MavlinkChoice::gyroSource() const {
    using enum MavlinkSensor;
    constexpr std::array kBestFirst{kHighresImu, kScaledImu, kRawImu, kAttitude};
    const auto usable = [this](MavlinkSensor sensor) {
        const bool doubtful = sensor == kRawImu && !trusts_raw_imu_ && heard(kAttitude);
        return heard(sensor) && !doubtful;
    };
    int most = 0;
    for (const MavlinkSensor sensor : kBestFirst) {
        if (usable(sensor)) most = std::max(most, source(sensor).count);
    }
    for (const MavlinkSensor sensor : kBestFirst) {
        if (usable(sensor) && 2 * source(sensor).count >= most) return sensor;
    }
    return std::nullopt;
}

std::optional<MavlinkSensor> MavlinkChoice::pose() const {
    using enum MavlinkSensor;
    if (heard(kOdometry)) return kOdometry;
    if (heard(kLocalPosition) && heard(kAttitude)) return kLocalPosition;
    return std::nullopt;
}

}  // namespace hedr
