#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/fusion/estimators.h"
#include "core/fusion/lost_times.h"
#include "core/mission/mission_salvage.h"
#include "core/result.h"
#include "core/robot/vehicle.h"
#include "core/track/track.h"
#include "radio/receiver.h"
#include "radio/wire/signing/key_text.h"

namespace hedr {

class MissionReader;
struct StreamRow;

// What was not believed when the mission was recorded, to be judged so again.
Result<std::vector<RejectedFrame>> rejectedIn(const MissionReader& mission);

// Lets a receiver hear a mission again. `after_each_row` may be empty. Errors: those of
// MissionReader.
Result<void> feedMission(const MissionReader& mission, Receiver& receiver,
                         const std::function<void(const StreamRow&)>& after_each_row);

struct RecomputeOptions {
    std::optional<Vehicle> vehicle{};     // none: the one that was used live
    std::optional<Pose<World>> start{};   // none: where the live tracks started
    std::vector<std::string> settings{};  // KEY=VALUE of core/fusion/estimators.h
    // Judges every frame anew, for a mission that was recorded without the robot's key; none:
    // believed is what was believed live.
    std::optional<RobotKey> key{};
};

// What a robot's sensors said in one mission, from one start of the robot to the next.
struct SensorStretch {
    std::vector<SensorReport> reports{};
};
struct MissionSensors {
    std::vector<SensorStretch> stretches{};
    Vehicle vehicle{};                        // that was used live, or as the robot says
    std::optional<SalvageReport> salvaged{};  // of a damaged mission
};

// Errors: those of MissionReader; kNoData where the mission holds no sensors; kMissionSigned where
// nothing was believed.
Result<MissionSensors> sensorsIn(const std::filesystem::path& mission,
                                 const std::optional<RobotKey>& key = {});

struct RecomputedTrack {
    std::string name;  // an estimator's, or kRobotTrack
    std::vector<TrackPoint> points;
    bool as_live = false;  // the same bits as all that was recorded of it live
    LostTimes lost{};
    std::optional<SalvageReport> salvaged{};  // of a damaged mission
};

struct RecomputedTracks {
    std::vector<RecomputedTrack> tracks;
    EstimatorInputs given{};                  // what the mission's reports and the vehicle give
    std::optional<SalvageReport> salvaged{};  // of a damaged mission
};

// Computes one track of a mission again from its raw bytes. Without options it is the live track,
// bit for bit. Errors: those of MissionReader; kUnknownName for `track`; kNoData or kMissingKey
// where reports or vehicle do not give what it needs; kMissionSigned where nothing was believed.
Result<RecomputedTrack> recomputeTrack(const std::filesystem::path& mission,
                                       const std::string& track, const RecomputeOptions& options);

// All of them: in the order of the table of estimators, the robot's own last. Errors: those of
// MissionReader; kNoData where the mission holds no reports; kMissionSigned.
Result<RecomputedTracks> recomputeTracks(const std::filesystem::path& mission,
                                         const RecomputeOptions& options);

}  // namespace hedr
