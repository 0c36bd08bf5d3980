#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/site/plan.h"

namespace hedr {

// Times in a mission are seconds since its start.

struct MissionHeader {
    std::chrono::system_clock::time_point start{};  // of this recording; its receive times count on
    std::string program_version{};
    double first_time_s = 0.0;  // of the first row that will be written
};

// A good frame that was not believed when it came, by its number among all good frames.
struct RejectedRow {
    std::uint64_t frame = 0;
    int reason = 0;  // the numbers of radio/wire/signing
    friend bool operator==(const RejectedRow&, const RejectedRow&) = default;
};

// What a row of the recorded stream is. The numbers are in the file.
enum class StreamKind : int {
    kBytes = 0,
    kPortOpened = 1,
    kPortLost = 2,
    kDirection = 3,
    kSent = 4  // bytes that went to the robot
};

struct StreamRow {
    double receive_time_s = 0.0;
    StreamKind kind = StreamKind::kBytes;
    std::span<const std::uint8_t> data{};  // valid during the callback only
    std::int64_t number = 0;               // in the file, from 1 on and growing
};

// The data of a kDirection row: the heading of one corridor, which the estimators were told there,
// as a little-endian double of radians; nothing: to learn it.
std::vector<std::uint8_t> packDirection(std::optional<double> direction_rad);
std::optional<double> unpackDirection(std::span<const std::uint8_t> data);

// The kind of event that says on which floor, by its name, the robot is from then on.
inline constexpr const char* kFloorEvent = "floor";
// That a floor has another name: the earlier one, a line's end, the new one.
inline constexpr const char* kFloorRenamedEvent = "floor_renamed";

// What was asked of the robot and what came of it; what the robot said in words.
inline constexpr const char* kRequestEvent = "request";
inline constexpr const char* kRobotEvent = "robot";
// A silence is over: how many seconds it lasted.
inline constexpr const char* kGapEvent = "gap";
// What the operator was warned of; of wheels that nobody has described it begins so.
inline constexpr const char* kWarningEvent = "warning";
inline constexpr const char* kWheelsWarning = "wheels: ";

struct MissionEvent {
    double receive_time_s = 0.0;
    std::string kind;
    std::string text;
    friend bool operator==(const MissionEvent&, const MissionEvent&) = default;
};

// The plan that lay under the trail.
struct MissionPlan {
    std::filesystem::path file;
    PlanPlacement placement{};
    std::optional<std::string> sha256{};
    friend bool operator==(const MissionPlan&, const MissionPlan&) = default;
};

struct MissionInfo {
    std::chrono::system_clock::time_point start{};
    std::string start_utc;  // the same, ISO 8601
    double duration_s = 0.0;
    std::uint64_t bytes = 0;  // on disk, with what is not yet moved from the log into the database
    std::uint64_t stream_rows = 0;
    std::uint64_t events = 0;
    std::vector<std::pair<std::string, std::uint64_t>> tracks;  // name and number of points
    std::string program_version;
    int schema = 0;
};

}  // namespace hedr
