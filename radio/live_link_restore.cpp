#include <algorithm>
#include <chrono>
#include <limits>
#include <utility>

#include "core/mission/mission_reader.h"
#include "radio/live_link.h"
#include "radio/recomputation.h"

// How a live link begins with what was recorded before; all else is in live_link.cpp.
namespace hedr {

namespace {

// How long ago the mission began, by the wall clock.
ReceiveClock::duration timeSinceStart(const MissionReader& mission,
                                      std::chrono::system_clock::time_point now) {
    const auto info = mission.info();
    return info ? std::chrono::duration_cast<ReceiveClock::duration>(now - info->start)
                : ReceiveClock::duration{};
}

bool sameMission(const MissionReader& one, const MissionReader& other) {
    const auto a = one.info();
    const auto b = other.info();
    return a && b && a->start == b->start;
}

void rename(std::vector<FloorChange>& floors, const std::string& earlier_and_new) {
    const auto end = earlier_and_new.find('\n');
    if (end == std::string::npos) return;
    for (FloorChange& change : floors) {
        if (change.floor == earlier_and_new.substr(0, end))
            change.floor = earlier_and_new.substr(end + 1);
    }
}

bool warnedOfWheels(const MissionReader& mission) {
    const std::vector<MissionEvent> events = mission.events().value_or(std::vector<MissionEvent>());
    return std::ranges::any_of(events, [](const MissionEvent& event) {
        return event.kind == kWarningEvent && event.text.starts_with(kWheelsWarning);
    });
}

}  // namespace

// The program was ended in mid-mission: its state is in the bytes.
void LiveLink::restoreMission() {
    std::error_code ignored;
    if (!std::filesystem::exists(setup_.mission, ignored)) return;
    auto reader = MissionReader::open(setup_.mission);
    if (reader && reader->salvaged()) reader = goOnBeside(*reader);
    if (!reader) return;  // the recorder will say what is wrong with the file
    const auto vehicle = reader->vehicle();
    if (!setup_.vehicle && vehicle && *vehicle) {
        receiver_ = Receiver(
            {.vehicle = *vehicle, .start = {}, .settings = {}, .verifier = keys_.verifier()});
    }
    receiver_.verifier().useRecord(rejectedIn(*reader).value_or(std::vector<RejectedFrame>()));
    feedWithFloors(*reader);
    receiver_.verifier().useKeys();
    receiver_.takeRejected();
    receiver_.takeAnswers();
    vehicle_noted_ = receiver_.vehicle().has_value();
    batch_.wheels_assumed = !setup_.vehicle && warnedOfWheels(*reader);
    // What the operator has loaded before connecting is newer than what the mission holds.
    if (!site_noted_) batch_.restored_site = reader->site().value_or(std::optional<Site>());
    const ReceiveClock::duration earlier = timeSinceStart(*reader, setup_.header.start);
    batch_.mission_begin = begin_ - earlier;
    batch_.link_samples = reader->linkSamples().value_or(std::vector<LinkSample>());
    for (LinkSample& sample : batch_.link_samples) {  // on this run's clock, as those to come
        sample.receive_time_s -= std::chrono::duration<double>(earlier).count();
    }
    rate_frames_ = receiver_.health().good_frames;
    news_ = true;
}

// A damaged file stays as it is. The mission goes on in what was written of it: now, or when it
// went on the last time.
Result<MissionReader> LiveLink::goOnBeside(const MissionReader& damaged) {
    const std::filesystem::path file = setup_.mission;
    constexpr int kMost = 100;
    for (int number = 1; number < kMost; ++number) {
        const std::filesystem::path beside = recoveredFile(file, number);
        std::error_code ignored;
        if (!std::filesystem::exists(beside, ignored)) {
            if (const auto left = salvageMission(file, beside); !left)
                return tl::make_unexpected(left.error());
        }
        auto reader = MissionReader::open(beside);
        if (!reader || reader->salvaged() || !sameMission(*reader, damaged)) continue;
        batch_.warnings.push_back(
            {ErrorCode::kMissionMoved, beside.string(),
             file.filename().string() + ": " + describe(*damaged.salvaged())});
        setup_.mission = beside;
        recorder_.setFile(beside);
        return reader;
    }
    return fail(ErrorCode::kFileUnwritable, file.string(),
                "its folder is full of what was recovered");
}

// Lets the receiver hear the mission, takes its points, and says where among them the floors are.
void LiveLink::feedWithFloors(const MissionReader& mission) {
    const std::vector<MissionEvent> events = mission.events().value_or(std::vector<MissionEvent>());
    auto next = events.begin();
    double last_t_s = std::numeric_limits<double>::lowest();
    const auto take_points = [&] {
        for (NamedPoints& track : receiver_.takePoints()) {
            last_t_s = std::max(last_t_s, track.points.back().t_s);
            batch_.tracks.push_back(std::move(track));
        }
    };
    const auto pass_until = [&](double receive_time_s) {
        for (; next != events.end() && next->receive_time_s <= receive_time_s; ++next) {
            if (next->kind == kFloorRenamedEvent) rename(batch_.restored_floors, next->text);
            if (next->kind != kFloorEvent) continue;
            take_points();
            batch_.restored_floors.push_back({next->text, last_t_s});
        }
    };
    (void)feedMission(mission, receiver_,
                      [&](const StreamRow& row) { pass_until(row.receive_time_s); });
    pass_until(std::numeric_limits<double>::max());
    take_points();
}

// A recording is believed as it was: counters of signatures that were heard once are not new.
Result<void> LiveLink::prepareToPlay(const std::filesystem::path& recording) {
    std::error_code ignored;
    if (std::filesystem::equivalent(recording, setup_.mission, ignored))
        return fail(ErrorCode::kBadValue, recording.string(),
                    "it is the mission that is being recorded to");
    if (const auto reader = MissionReader::open(recording)) {
        receiver_.verifier().useRecord(rejectedIn(*reader).value_or(std::vector<RejectedFrame>()));
        if (const auto& left = reader->salvaged()) {
            batch_.warnings.push_back(
                {ErrorCode::kMissionIncomplete, recording.string(), describe(*left)});
            news_ = true;
        }
    }
    return {};
}

}  // namespace hedr
