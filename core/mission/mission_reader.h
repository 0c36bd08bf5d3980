#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/mission/link_sample.h"
#include "core/mission/mission.h"
#include "core/mission/mission_salvage.h"
#include "core/result.h"
#include "core/robot/vehicle.h"
#include "core/site/site.h"
#include "core/track/track.h"

namespace hedr {

// Reads a mission, also one that is just being recorded or was left by a crash, and of a damaged
// one what is left of it: the file stays as it is. Errors of every call: kMissionDamaged,
// kFileUnreadable.
class MissionReader {
  public:
    // Further errors: kFileMissing, kNotAMission, kMissionTooNew.
    static Result<MissionReader> open(const std::filesystem::path& file);

    MissionReader(MissionReader&&) noexcept;
    MissionReader& operator=(MissionReader&&) noexcept;
    ~MissionReader();

    // What a damaged mission lacks; none: it is whole.
    const std::optional<SalvageReport>& salvaged() const;

    Result<MissionInfo> info() const;

    // In the order of recording, until `visit` returns false; only rows behind the number `after`.
    Result<void> forEachStreamRow(const std::function<bool(const StreamRow&)>& visit,
                                  std::int64_t after = 0) const;

    Result<std::vector<std::string>> tracks() const;
    Result<std::vector<TrackPoint>> estimates(const std::string& track) const;
    Result<std::vector<MissionEvent>> events() const;
    Result<std::vector<LinkSample>> linkSamples() const;
    Result<std::vector<RejectedRow>> rejected() const;  // in the order of their numbers
    Result<std::optional<Vehicle>> vehicle() const;
    Result<std::optional<MissionPlan>> plan() const;
    // As it was last. Images that lay below the mission's folder are looked for below the one where
    // it lies now. A site that cannot be read is kMissionDamaged.
    Result<std::optional<Site>> site() const;

  private:
    struct Database;
    explicit MissionReader(std::unique_ptr<Database> database);
    static Result<MissionReader> openWhatIsLeft(const std::filesystem::path& file);
    std::unique_ptr<Database> database_;
};

}  // namespace hedr
