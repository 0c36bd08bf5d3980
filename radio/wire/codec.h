#pragma once

#include <optional>
#include <tl/expected.hpp>

#include "core/robot/report.h"
#include "radio/wire/frame.h"
#include "radio/wire/request.h"

namespace hedr {

// Robot time counts microseconds modulo 2^32: after this it starts again at 0.
inline constexpr double kRobotClockPeriod_s = 4294.967296;

enum class DecodeFailure : std::uint8_t {
    kUnknownId,  // of a newer version: to be skipped, not an error
    kTooShort,   // a known id with less than its fields: a bad frame
};

// Wire units become SI units here and nowhere else. Longer payloads than known are read as far as
// they are known.
tl::expected<Report, DecodeFailure> decodeReport(const Frame& frame);
tl::expected<Request, DecodeFailure> decodeRequest(const Frame& frame);

// The frame as it goes on the line. Values that are out of a field's range saturate; time, counts
// and headings wrap; texts are cut. Nothing for a SensorReport that the wire has no place for:
// without WheelTicks, or with a GyroRate.
std::optional<FrameBytes> encodeReport(const Report& report, std::uint16_t sequence);
FrameBytes encodeRequest(const Request& request, std::uint16_t sequence);

}  // namespace hedr
