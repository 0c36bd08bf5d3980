#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/calibration/calibration.h"
#include "core/calibration/procedure_input.h"
#include "core/result.h"

namespace hedr {

// The samples that a calibration was made of, kept beside its record.
struct RawSamples {
    std::string file;      // name in the record's folder
    std::string sha256{};  // of the file
    std::string origin{};  // where they came from: a log, a mission, "live"
    friend bool operator==(const RawSamples&, const RawSamples&) = default;
};

struct RecordedParameter {
    std::string key;
    std::optional<double> was{};
    Estimate now{};
    bool stays = false;
    bool follows = false;
    friend bool operator==(const RecordedParameter&, const RecordedParameter&) = default;
};

// Everything that must be known of a calibration later: who, when, on what, from what, with what
// result. One file of the robot's history.
struct CalibrationRecord {
    std::string procedure{};
    std::string time_utc{};  // ISO 8601
    std::string who{};       // may be empty
    std::string robot{};
    std::string surface{};  // may be empty
    std::optional<double> temperature_c{};
    std::string program_version{};
    Verdict verdict = Verdict::kNotProven;
    std::string reason{};
    bool taken_over = false;   // written into the vehicle file
    ProcedureSettings told{};  // by the operator
    std::vector<RecordedParameter> found{};
    std::vector<TrackWidth> track_widths{};
    std::optional<Proof> proof{};
    std::vector<std::string> remarks{};
    std::vector<RawSamples> raw{};
    std::string vehicle_before{};  // the vehicle file's whole text
    std::string vehicle_after{};   // the same where nothing was taken over
    friend bool operator==(const CalibrationRecord&, const CalibrationRecord&) = default;
};

// What a calibration says; who, when, where, from what and what was told is left to the caller.
CalibrationRecord recordOf(const Calibration& calibration);

std::string_view nameOf(Verdict verdict);  // "accepted", as in files and on the command line

// TOML; parseRecord(formatRecord(r)) == r, to the last bit.
std::string formatRecord(const CalibrationRecord& record);
// Errors with path:line: kBadFormat, kMissingKey, kBadValue.
Result<CalibrationRecord> parseRecord(std::string_view toml, const std::string& name_for_errors);

}  // namespace hedr
