#include "radio/wire/mavlink/mavlink_messages.h"

#include <algorithm>

namespace hedr {

constinit const std::array<MavlinkMessageInfo, kMavlinkMessageCount> kMavlinkMessages{{
    {MavlinkHeartbeat::kId, 50, 9, 9, "HEARTBEAT"},
    {MavlinkSysStatus::kId, 124, 31, 43, "SYS_STATUS"},
    {MavlinkParamRequestRead::kId, 214, 20, 20, "PARAM_REQUEST_READ"},
    {MavlinkParamValue::kId, 220, 25, 25, "PARAM_VALUE"},
    {MavlinkParamSet::kId, 168, 23, 23, "PARAM_SET"},
    {MavlinkScaledImu::kId, 170, 22, 24, "SCALED_IMU"},
    {MavlinkRawImu::kId, 144, 26, 29, "RAW_IMU"},
    {MavlinkAttitude::kId, 39, 28, 28, "ATTITUDE"},
    {MavlinkLocalPositionNed::kId, 185, 28, 28, "LOCAL_POSITION_NED"},
    {MavlinkCommandLong::kId, 152, 33, 33, "COMMAND_LONG"},
    {MavlinkCommandAck::kId, 143, 3, 10, "COMMAND_ACK"},
    {MavlinkHighresImu::kId, 93, 62, 63, "HIGHRES_IMU"},
    {MavlinkRadioStatus::kId, 185, 9, 9, "RADIO_STATUS"},
    {MavlinkTimesync::kId, 34, 16, 18, "TIMESYNC"},
    {MavlinkStatustext::kId, 83, 51, 54, "STATUSTEXT"},
    {MavlinkOdometry::kId, 91, 230, 233, "ODOMETRY"},
    {MavlinkWheelDistance::kId, 113, 137, 137, "WHEEL_DISTANCE"},
}};

const MavlinkMessageInfo* findMavlinkMessage(std::uint32_t id) {
    const auto found = std::ranges::lower_bound(kMavlinkMessages, id, {}, &MavlinkMessageInfo::id);
    return found != kMavlinkMessages.end() && found->id == id ? found : nullptr;
}

}  // namespace hedr
