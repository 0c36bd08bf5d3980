#pragma once

#include <string>
#include <vector>

#include "app/tool/track_table.h"
#include "core/fusion/estimators.h"
#include "core/result.h"
#include "core/robot/motion.h"
#include "core/robot/sensor_csv.h"
#include "core/robot/vehicle.h"

namespace hedr::tool {

struct LogAndVehicle {
    SensorLog log;
    Vehicle vehicle;
    FusionConfig config;
};

// Says on stderr which columns of `file` are not used.
void warnOfIgnored(const SensorLog& log, const std::string& file);

// With such a warning. Errors: those of the files and of the settings.
Result<LogAndVehicle> loadLogAndVehicle(const std::string& log_file,
                                        const std::string& vehicle_file,
                                        const std::vector<std::string>& settings);

// Both say on stderr how many samples of `file` were left out. Error: kNoData where no motion can
// be made of them, with the reason.

// One track per estimator, each of which has what it needs.
Result<std::vector<NamedTrack>> trackedBy(const std::vector<const EstimatorEntry*>& estimators,
                                          const LogAndVehicle& input, const Pose<World>& start,
                                          const std::string& file);
Result<std::vector<Motion>> motionsOf(const LogAndVehicle& input, const std::string& file);

}  // namespace hedr::tool
