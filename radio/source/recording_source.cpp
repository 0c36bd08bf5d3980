#include "radio/source/recording_source.h"

#include <utility>

namespace hedr {

RecordingSource::RecordingSource(const RecordingAddress& address, QObject* parent)
    : ByteSource(parent), address_(address), tick_(this) {
    tick_.setInterval(kPlayTick_ms);
    tick_.setTimerType(Qt::PreciseTimer);
    connect(&tick_, &QTimer::timeout, this, &RecordingSource::play);
}

void RecordingSource::open() {
    close();
    auto reader = MissionReader::open(address_.file.toStdString());
    if (!reader) return end(reader.error());
    reader_.emplace(std::move(*reader));
    tick_.start();
}

void RecordingSource::close() {
    tick_.stop();
    reader_.reset();
    pace_.reset();
    last_row_ = 0;
    at_end_ = false;
    open_ = false;
}

void RecordingSource::play() {
    const auto due = readDue();
    if (!due) return end(due.error());
    for (const Piece& piece : *due) {
        if (!tick_.isActive()) return;  // whoever was told has closed it
        tell(piece);
    }
    if (at_end_ && tick_.isActive())
        end({ErrorCode::kReplayEnded, name(), "the recording is at its end"});
}

// The rows whose time has come. They are told afterwards: whoever is told may close the file.
Result<std::vector<RecordingSource::Piece>> RecordingSource::readDue() {
    std::vector<Piece> due;
    qsizetype size = 0;
    at_end_ = true;
    const auto read = reader_->forEachStreamRow(
        [&](const StreamRow& row) {
            if (!pace_) pace_.emplace(row.receive_time_s, address_.speed);
            at_end_ = size < kMostBytesPerTick && row.receive_time_s <= pace_->now_s();
            if (!at_end_) return false;
            last_row_ = row.number;
            due.push_back({row.kind, QByteArray(reinterpret_cast<const char*>(row.data.data()),
                                                static_cast<qsizetype>(row.data.size()))});
            size += due.back().bytes.size();
            return true;
        },
        last_row_);
    if (!read) return tl::make_unexpected(read.error());
    return due;
}

void RecordingSource::tell(const Piece& piece) {
    const bool opens = piece.kind == StreamKind::kPortOpened;
    // The beginning of a damaged mission may be missing, its port opened before.
    if (opens || (piece.kind == StreamKind::kBytes && !open_)) {
        open_ = true;
        emit opened();
    }
    if (piece.kind == StreamKind::kBytes) emit bytesReceived(piece.bytes);
    if (piece.kind == StreamKind::kPortLost && std::exchange(open_, false)) {
        emit failed({ErrorCode::kReplayGap, name(), "the radio was gone when this was recorded"});
    }
}

void RecordingSource::end(const Error& error) {
    close();
    emit failed(error);
}

}  // namespace hedr
