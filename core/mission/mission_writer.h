#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "core/mission/link_sample.h"
#include "core/mission/mission.h"
#include "core/result.h"
#include "core/robot/vehicle.h"
#include "core/site/site.h"
#include "core/track/track.h"

namespace hedr {

// Records one mission. What is written is safe from a crash of the program or the computer after
// the next commit. After an error (kDiskFull, kFileUnwritable) every later call gives that error
// again; what was committed stays readable. Closes the file when it goes.
//
// Receive times are seconds since `header.start`. Where a mission goes on, they are stored as
// seconds since the mission's first start.
class MissionWriter {
  public:
    static constexpr double kCommitPeriod_s = 0.5;

    // Begins a new mission, or goes on with the one in `file`. Errors: kFileUnwritable (also where
    // another program is recording into it), kDiskFull, kNotAMission (another file is not
    // overwritten), kMissionTooNew, kMissionDamaged.
    static Result<MissionWriter> create(const std::filesystem::path& file,
                                        const MissionHeader& header);

    MissionWriter(MissionWriter&&) noexcept;
    MissionWriter& operator=(MissionWriter&&) noexcept;
    ~MissionWriter();

    // Raw bytes come before anything that is made of them.
    Result<void> writeBytes(double receive_time_s, std::span<const std::uint8_t> bytes);
    Result<void> writeStreamMark(double receive_time_s, StreamKind mark,
                                 std::span<const std::uint8_t> data = {});
    // Gathered and stored with the next commit.
    Result<void> writeEstimates(const std::string& track, std::span<const TrackPoint> points);
    Result<void> writeEvent(double receive_time_s, std::string_view kind, std::string_view text);
    Result<void> writeRejected(const RejectedRow& rejected);
    Result<void> writeLinkSample(const LinkSample& sample);
    Result<void> writeVehicle(const Vehicle& vehicle);  // the last one counts
    Result<void> writePlan(const MissionPlan& plan);    // the last one counts
    // The last one counts; one that is equal to it adds nothing. Images below the mission's folder
    // are named relative to it.
    Result<void> writeSite(double receive_time_s, const Site& site);

    // Commits when the last commit is kCommitPeriod_s ago. To be called also while nothing comes.
    Result<void> commitIfDue(double receive_time_s);
    Result<void> commit();

    std::uint64_t bytesOnDisk() const;

  private:
    class Database;
    explicit MissionWriter(std::unique_ptr<Database> database);
    std::unique_ptr<Database> database_;
};

}  // namespace hedr
