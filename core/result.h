#pragma once

#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace hedr {

enum class ErrorCode {
    kFileMissing,
    kFileUnreadable,
    kFileEmpty,
    kFileTooLarge,
    kFileUnwritable,
    kFileExists,
    kFileChanged,
    kBadFormat,
    kMissingColumn,
    kMissingKey,
    kBadValue,
    kUnknownName,
    kNotAnImage,
    kImageTooLarge,
    kKeyExposed,
    kPortMissing,
    kNotAPort,
    kOtherWheels,
    kPortPermission,
    kPortBusy,
    kPortFailed,
    kPeerMissing,
    kAddressInUse,
    kReplayGap,
    kReplayEnded,
    kUnreachable,
    kNotOnGlobe,
    kDiskFull,
    kNotAMission,
    kMissionBusy,    // another program records into it
    kMissionSigned,  // and cannot be computed without the robot's key
    kMissionTooNew,
    kMissionDamaged,
    kMissionIncomplete,  // read as far as it goes
    kMissionMoved,       // goes on in another file
    kWheelsUnknown,      // computed with assumed ones
    kSensorsRare,        // too seldom to follow quick turns
    kNoData,
    kCalibrationRefused,
    kCanceled,
};

// What went wrong, as a value. `subject` says where (a path, a path:line, a port, a key);
// `detail` says what exactly, in plain English ("wheelbase_m is -0.4, must be positive").
// ui/error_text.h makes a sentence with advice of it.
struct Error {
    ErrorCode code{};
    std::string subject;
    std::string detail;
};

template <class T>
using Result = tl::expected<T, Error>;

inline tl::unexpected<Error> fail(ErrorCode code, std::string subject, std::string detail = {}) {
    return tl::make_unexpected(Error{code, std::move(subject), std::move(detail)});
}

}  // namespace hedr
