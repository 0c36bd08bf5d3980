#include "radio/wire/mavlink/mavlink_requests.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "radio/wire/mavlink/mavlink_text.h"

namespace hedr {
namespace {

constexpr std::uint8_t kInt32 = 6;  // MAV_PARAM_TYPE
constexpr std::uint8_t kReal32 = 9;
constexpr int kUserCommand = 31009;  // MAV_CMD_USER_1 is 31010: command 1

struct Parameter {
    RobotParameter id;
    std::string_view name;
};
constexpr std::array kParameters{
    Parameter{RobotParameter::kLeftWheelDiameterUm, "HEDR_WHEEL_L_UM"},
    Parameter{RobotParameter::kRightWheelDiameterUm, "HEDR_WHEEL_R_UM"},
    Parameter{RobotParameter::kWheelbaseUm, "HEDR_BASE_UM"},
    Parameter{RobotParameter::kTicksPerRevolutionMilli, "HEDR_TICKS_MILLI"},
    Parameter{RobotParameter::kHedrGainUradS2, "HEDR_GAIN_URAD"},
    Parameter{RobotParameter::kDominantDirections, "HEDR_DIRECTIONS"},
    Parameter{RobotParameter::kDominantOffset, "HEDR_OFFSET"},
};

MavlinkParamName padded(std::string_view name) {
    MavlinkParamName result{};
    std::ranges::copy(name, result.begin());
    return result;
}

// A request to `target` as a frame; none where the request has no word.
class Encoder {
  public:
    Encoder(std::uint8_t sequence, MavlinkAddress target, MavlinkParameterCoding coding)
        : target_(target), coding_(coding) {
        header_.sequence = sequence;
        header_.system = kMavlinkOwnSystem;
        header_.component = kMavlinkOwnComponent;
    }

    std::optional<MavlinkBytes> operator()(const ParameterGet& get) const {
        const std::string_view name = mavlinkParameterName(RobotParameter{get.id});
        if (name.empty()) return std::nullopt;
        MavlinkParamRequestRead m;
        m.param_id = padded(name);
        return addressed(m);
    }

    std::optional<MavlinkBytes> operator()(const ParameterSet& set) const {
        const std::string_view name = mavlinkParameterName(RobotParameter{set.id});
        if (name.empty()) return std::nullopt;
        MavlinkParamSet m;
        const bool by_value = coding_ == MavlinkParameterCoding::kValue;
        m.param_value = by_value ? static_cast<float>(set.value) : std::bit_cast<float>(set.value);
        m.param_type = by_value ? kReal32 : kInt32;
        m.param_id = padded(name);
        return addressed(m);
    }

    std::optional<MavlinkBytes> operator()(const RobotCommand& command) const {
        if (command.kind == CommandKind::kNone) return std::nullopt;
        MavlinkCommandLong m;
        m.command = static_cast<std::uint16_t>(kUserCommand + static_cast<int>(command.kind));
        if (command.kind == CommandKind::kResetPose) {
            m.param[0] = static_cast<float>(command.pose.position.x);
            m.param[1] = static_cast<float>(-command.pose.position.y);
            m.param[2] = static_cast<float>(-command.pose.heading_rad);
        }
        return addressed(m);
    }

    // The token stands where the time of who asks would: it only has to come back.
    std::optional<MavlinkBytes> operator()(const TimeRequest& request) const {
        MavlinkTimesync m;
        m.ts1 = request.token;
        return addressed(m);
    }

    MavlinkBytes operator()(const MavlinkCommandLong& command) const { return addressed(command); }

  private:
    template <class Message>
    MavlinkBytes addressed(Message m) const {
        m.target_system = target_.system;
        m.target_component = target_.component;
        return encodeMavlink(m, header_);
    }

    MavlinkAddress target_;
    MavlinkParameterCoding coding_;
    MavlinkFrame header_{};
};

AcknowledgeResult resultOf(std::uint8_t mav_result) {
    switch (mav_result) {
        case 0:  // ACCEPTED
            return AcknowledgeResult::kDone;
        case 1:  // TEMPORARILY_REJECTED
            return AcknowledgeResult::kNotWhileMoving;
        case 2:  // DENIED: its parameters
            return AcknowledgeResult::kOutOfRange;
        case 3:  // UNSUPPORTED
            return AcknowledgeResult::kUnknownCommand;
        default:  // FAILED, CANCELLED and newer ones
            return AcknowledgeResult::kNotSupported;
    }
}

}  // namespace

std::string_view mavlinkParameterName(RobotParameter parameter) {
    const auto found = std::ranges::find(kParameters, parameter, &Parameter::id);
    return found != kParameters.end() ? found->name : std::string_view{};
}

std::optional<MavlinkBytes> encodeMavlinkRequest(const Request& request, std::uint8_t sequence,
                                                 MavlinkAddress target,
                                                 MavlinkParameterCoding coding) {
    return std::visit(Encoder(sequence, target, coding), request);
}

MavlinkBytes encodeMessageInterval(std::uint32_t message_id, double interval_s,
                                   std::uint8_t sequence, MavlinkAddress target) {
    constexpr std::uint16_t kSetMessageInterval = 511;
    constexpr double kMicrosecond_s = 1e-6;
    MavlinkCommandLong m;
    m.command = kSetMessageInterval;
    m.param[0] = static_cast<float>(message_id);
    m.param[1] = static_cast<float>(interval_s / kMicrosecond_s);
    return Encoder(sequence, target, MavlinkParameterCoding::kBits)(m);
}

std::optional<ParameterReport> parameterOf(const MavlinkParamValue& m,
                                           MavlinkParameterCoding coding) {
    const auto found = std::ranges::find(kParameters, mavlinkText(m.param_id), &Parameter::name);
    if (found == kParameters.end()) return std::nullopt;
    const auto id = static_cast<std::uint8_t>(found->id);
    if (m.param_type == kInt32 && coding == MavlinkParameterCoding::kBits)
        return ParameterReport{id, std::bit_cast<std::int32_t>(m.param_value)};
    const double value = std::round(static_cast<double>(m.param_value));
    if ((m.param_type != kReal32 && m.param_type != kInt32) || !(std::abs(value) < 2147483648.0))
        return std::nullopt;
    return ParameterReport{id, static_cast<std::int32_t>(value)};
}

std::optional<AcknowledgeReport> acknowledgeOf(const MavlinkCommandAck& m) {
    constexpr std::uint8_t kInProgress = 5;
    const int command = m.command - kUserCommand;
    const bool ours = command > 0 && command <= static_cast<int>(CommandKind::kHedrOff);
    const bool to_us = m.target_system == 0 || m.target_system == kMavlinkOwnSystem;
    if (!ours || !to_us || m.result == kInProgress) return std::nullopt;
    return AcknowledgeReport{static_cast<std::uint8_t>(command),
                             static_cast<std::uint8_t>(resultOf(m.result))};
}

}  // namespace hedr
