#include "radio/recorder.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace hedr {

namespace {

constexpr double kRetryPeriod_s = 2.0;
constexpr double kEstimatesPeriod_s = 5.0;
constexpr double kRowPeriod_s = 0.02;  // a row per byte would cost more than the byte

}  // namespace

Recorder::Recorder(std::filesystem::path file, const MissionHeader& header)
    : file_(std::move(file)), header_(header) {}

void Recorder::addBytes(double time_s, std::span<const std::uint8_t> bytes) {
    const bool joins = !rows_.empty() && rows_.back().kind == StreamKind::kBytes &&
                       time_s - rows_.back().time_s < kRowPeriod_s;
    if (!joins) rows_.push_back({time_s, StreamKind::kBytes, {}});
    std::vector<std::uint8_t>& row = rows_.back().bytes;
    row.insert(row.end(), bytes.begin(), bytes.end());
}

void Recorder::addMark(double time_s, StreamKind mark, std::vector<std::uint8_t> data) {
    rows_.push_back({time_s, mark, std::move(data)});
}

void Recorder::addEstimates(const std::vector<NamedPoints>& points) {
    for (const NamedPoints& track : points) {
        if (!track.points.empty()) estimates_.insert_or_assign(track.name, track.points.back());
    }
}

void Recorder::setVehicle(const Vehicle& vehicle) { vehicle_ = vehicle; }

void Recorder::setPlan(const MissionPlan& plan) { plan_ = plan; }

void Recorder::setSite(double time_s, const Site& site) { site_ = {time_s, site}; }

void Recorder::addEvent(MissionEvent event) { events_.push_back(std::move(event)); }

void Recorder::writeIfDue(double time_s) {
    if (time_s < next_write_s_) return;
    const bool with_estimates = time_s >= next_estimates_s_;
    write(with_estimates);
    if (with_estimates) next_estimates_s_ = time_s + kEstimatesPeriod_s;
    next_write_s_ = time_s + (state_.error ? kRetryPeriod_s : MissionWriter::kCommitPeriod_s);
}

void Recorder::lookForRoom() {
    std::error_code error;
    const auto folder = std::filesystem::absolute(file_).parent_path();
    const auto space = std::filesystem::space(folder, error);
    state_.free_bytes = error ? std::nullopt : std::optional<std::uint64_t>(space.available);
}

// What the operator notes does not make a file of a mission in which nothing came.
bool Recorder::hasNews() const {
    const bool notes = vehicle_ || plan_ || site_ || !events_.empty();
    return !rows_.empty() || !estimates_.empty() || (writer_ && (notes || !link_samples_.empty()));
}

void Recorder::write(bool with_estimates) {
    if (!hasNews()) return;
    lookForRoom();
    const auto written = writePending(with_estimates);
    if (!written) {
        state_.error = written.error();
        writer_.reset();
        return;
    }
    for (const Row& row : rows_) recorded_ += row.bytes.size();
    if (with_estimates) recorded_ += estimates_.size() * sizeof(TrackPoint);
    rows_.clear();
    if (with_estimates) estimates_.clear();
    link_samples_.clear();
    rejected_.clear();
    vehicle_.reset();
    plan_.reset();
    site_.reset();
    events_.clear();
    state_.file = file_.string();
    state_.bytes = size_before_ + recorded_;
    state_.error.reset();
}

double Recorder::firstTime_s() const {
    double first_s = rows_.empty() ? std::numeric_limits<double>::max() : rows_.front().time_s;
    if (site_) first_s = std::min(first_s, site_->time_s);
    if (!events_.empty()) first_s = std::min(first_s, events_.front().receive_time_s);
    return first_s;
}

Result<void> Recorder::writePending(bool with_estimates) {
    if (state_.free_bytes && *state_.free_bytes < kLeastRoomBytes) {
        std::string left = std::to_string(*state_.free_bytes / 1'000'000);
        return fail(ErrorCode::kDiskFull, file_.string(), left.append(" MB are left"));
    }
    std::error_code ignored;
    if (writer_ && !std::filesystem::exists(file_, ignored)) {
        writer_.reset();
        return fail(ErrorCode::kFileMissing, file_.string(), "it was removed while recording");
    }
    if (!writer_) {
        header_.first_time_s = firstTime_s();
        auto created = MissionWriter::create(file_, header_);
        if (!created) return tl::make_unexpected(created.error());
        writer_ = std::move(*created);
        if (recorded_ == 0) size_before_ = writer_->bytesOnDisk();
    }
    Result<void> done;
    const auto then = [&done](auto&& step) {
        if (done) done = step();
    };
    then([&] { return writeNotes(); });
    for (const Row& row : rows_) {
        then([&] {
            return row.kind == StreamKind::kBytes
                       ? writer_->writeBytes(row.time_s, row.bytes)
                       : writer_->writeStreamMark(row.time_s, row.kind, row.bytes);
        });
    }
    for (const auto& latest : estimates_) {
        if (!with_estimates) break;
        then([&] { return writer_->writeEstimates(latest.first, std::span(&latest.second, 1)); });
    }
    for (const LinkSample& sample : link_samples_) {
        then([&] { return writer_->writeLinkSample(sample); });
    }
    for (const RejectedRow& rejected : rejected_) {
        then([&] { return writer_->writeRejected(rejected); });
    }
    then([&] { return writer_->commit(); });
    return done;
}

Result<void> Recorder::writeNotes() {
    Result<void> done;
    const auto then = [&done](auto&& step) {
        if (done) done = step();
    };
    if (vehicle_) then([&] { return writer_->writeVehicle(*vehicle_); });
    if (plan_) then([&] { return writer_->writePlan(*plan_); });
    if (site_) then([&] { return writer_->writeSite(site_->time_s, site_->site); });
    for (const MissionEvent& event : events_) {
        then([&] { return writer_->writeEvent(event.receive_time_s, event.kind, event.text); });
    }
    return done;
}

}  // namespace hedr
