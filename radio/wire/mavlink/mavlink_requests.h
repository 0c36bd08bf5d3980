#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "core/robot/report.h"
#include "radio/wire/mavlink/mavlink_codec.h"
#include "radio/wire/request.h"

namespace hedr {

// Our requests in MAVLink's words, and the answers to them; docs/mavlink.md has the tables.

// Who we are: what ground stations are by custom.
inline constexpr std::uint8_t kMavlinkOwnSystem = 255;
inline constexpr std::uint8_t kMavlinkOwnComponent = 190;

struct MavlinkAddress {
    std::uint8_t system = 0;  // 0: whoever hears it
    std::uint8_t component = 0;
    friend bool operator==(const MavlinkAddress&, const MavlinkAddress&) = default;
};

// How an integer lies in the float of a parameter message: its bits, as MAVLink recommends, or its
// value, as ArduPilot does whatever the type says.
enum class MavlinkParameterCoding : std::uint8_t { kBits, kValue };

// A version 2 frame. None where MAVLink has no word for it: a parameter that is not in the table,
// or no command.
std::optional<MavlinkBytes> encodeMavlinkRequest(const Request& request, std::uint8_t sequence,
                                                 MavlinkAddress target,
                                                 MavlinkParameterCoding coding);

// Asks that `message_id` be sent so often (MAV_CMD_SET_MESSAGE_INTERVAL).
MavlinkBytes encodeMessageInterval(std::uint32_t message_id, double interval_s,
                                   std::uint8_t sequence, MavlinkAddress target);

// At most 16 characters; empty where there is none.
std::string_view mavlinkParameterName(RobotParameter parameter);

// The answers; none where they are not to us, or say nothing (yet).
std::optional<ParameterReport> parameterOf(const MavlinkParamValue& m,
                                           MavlinkParameterCoding coding);
std::optional<AcknowledgeReport> acknowledgeOf(const MavlinkCommandAck& m);

}  // namespace hedr
