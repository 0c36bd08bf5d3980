#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/mission/mission_writer.h"
#include "radio/receiver.h"

namespace hedr {

struct RecorderState {
    std::string file;              // empty: not recording
    std::uint64_t bytes = 0;       // recorded; the file on disk grows in larger steps
    std::optional<Error> error{};  // what comes is kept in memory until the disk takes it again
    std::optional<std::uint64_t> free_bytes{};  // on its disk; none: not known
};

// From here on the operator is warned, and recording stops before the disk is full: others need
// room too, and a mission is closed in good order.
inline constexpr std::uint64_t kLittleRoomBytes = 1'000'000'000;
inline constexpr std::uint64_t kLeastRoomBytes = 8'000'000;

// Writes a mission twice a second. What could not be written is kept and tried again, so that a
// full disk costs nothing once there is room. Times are seconds since `header.start`.
class Recorder {
  public:
    Recorder(std::filesystem::path file, const MissionHeader& header);

    void setFile(std::filesystem::path file) { file_ = std::move(file); }  // before the first write
    void addBytes(double time_s, std::span<const std::uint8_t> bytes);
    void addMark(double time_s, StreamKind mark, std::vector<std::uint8_t> data = {});
    // Of each track the file gets a point now and then, and the last: the rest can be computed
    // again.
    void addEstimates(const std::vector<NamedPoints>& points);
    void addRejected(const RejectedRow& rejected) { rejected_.push_back(rejected); }
    void addLinkSample(const LinkSample& sample) { link_samples_.push_back(sample); }
    void setVehicle(const Vehicle& vehicle);
    void setPlan(const MissionPlan& plan);
    void setSite(double time_s, const Site& site);
    void addEvent(MissionEvent event);

    // To be called often; does nothing most times. The file is made when there is something in it.
    void writeIfDue(double time_s);
    void write() { write(true); }

    const RecorderState& state() const { return state_; }

  private:
    struct Row {
        double time_s;
        StreamKind kind;
        std::vector<std::uint8_t> bytes;
    };

    struct TimedSite {
        double time_s;
        Site site;
    };

    void write(bool with_estimates);
    bool hasNews() const;
    void lookForRoom();
    double firstTime_s() const;
    Result<void> writePending(bool with_estimates);
    Result<void> writeNotes();

    std::filesystem::path file_;
    MissionHeader header_;
    std::optional<MissionWriter> writer_{};
    RecorderState state_{};
    double next_write_s_ = 0.0;
    double next_estimates_s_ = 0.0;
    std::uint64_t size_before_ = 0;  // of a mission that is continued
    std::uint64_t recorded_ = 0;
    std::vector<Row> rows_;
    std::map<std::string, TrackPoint> estimates_;  // the latest of each track since the last write
    std::vector<LinkSample> link_samples_;
    std::vector<RejectedRow> rejected_;
    std::optional<Vehicle> vehicle_{};
    std::optional<MissionPlan> plan_{};
    std::optional<TimedSite> site_{};
    std::vector<MissionEvent> events_;
};

}  // namespace hedr
