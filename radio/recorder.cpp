#include "radio/recorder.h"

#include <utility>

namespace hedr {

namespace {

constexpr double kRetryPeriod_s = 2.0;
constexpr double kRowPeriod_s = 0.01;  // a row per byte would cost more than the byte

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

void Recorder::addMark(double time_s, StreamKind mark) { rows_.push_back({time_s, mark, {}}); }

void Recorder::addEstimates(std::vector<NamedPoints> points) {
    for (NamedPoints& track : points) estimates_.push_back(std::move(track));
}

void Recorder::setVehicle(const Vehicle& vehicle) { vehicle_ = vehicle; }

void Recorder::setPlan(const MissionPlan& plan) { plan_ = plan; }

void Recorder::writeIfDue(double time_s) {
    if (time_s < next_write_s_) return;
    write();
    next_write_s_ = time_s + (state_.error ? kRetryPeriod_s : MissionWriter::kCommitPeriod_s);
}

void Recorder::write() {
    if (rows_.empty() && estimates_.empty() && !(writer_ && (vehicle_ || plan_))) return;
    const auto written = writePending();
    if (!written) {
        state_.error = written.error();
        writer_.reset();
        return;
    }
    for (const Row& row : rows_) recorded_ += row.bytes.size();
    for (const NamedPoints& track : estimates_) {
        recorded_ += track.points.size() * sizeof(TrackPoint);
    }
    rows_.clear();
    estimates_.clear();
    vehicle_.reset();
    plan_.reset();
    state_ = {file_.string(), size_before_ + recorded_, std::nullopt};
}

Result<void> Recorder::writePending() {
    std::error_code ignored;
    if (writer_ && !std::filesystem::exists(file_, ignored)) {
        writer_.reset();
        return fail(ErrorCode::kFileMissing, file_.string(), "it was removed while recording");
    }
    if (!writer_) {
        if (!rows_.empty()) header_.first_time_s = rows_.front().time_s;
        auto created = MissionWriter::create(file_, header_);
        if (!created) return tl::make_unexpected(created.error());
        writer_ = std::move(*created);
        if (recorded_ == 0) size_before_ = writer_->bytesOnDisk();
    }
    Result<void> done;
    const auto then = [&done](auto&& step) {
        if (done) done = step();
    };
    if (vehicle_) then([&] { return writer_->writeVehicle(*vehicle_); });
    if (plan_) then([&] { return writer_->writePlan(*plan_); });
    for (const Row& row : rows_) {
        then([&] {
            return row.kind == StreamKind::kBytes ? writer_->writeBytes(row.time_s, row.bytes)
                                                  : writer_->writeStreamMark(row.time_s, row.kind);
        });
    }
    for (const NamedPoints& track : estimates_) {
        then([&] { return writer_->writeEstimates(track.name, track.points); });
    }
    then([&] { return writer_->commit(); });
    return done;
}

}  // namespace hedr
