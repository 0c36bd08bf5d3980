#pragma once

#include <QTimer>
#include <optional>

#include "core/mission/mission_reader.h"
#include "radio/source/byte_source.h"
#include "radio/source/play_pace.h"

namespace hedr {

// The bytes of a mission, at the times at which they came. Where the port was lost, and at the end,
// it fails as a port would: kReplayGap, kReplayEnded; else with the errors of MissionReader. Nobody
// hears a request.
class RecordingSource : public ByteSource {
    Q_OBJECT

  public:
    explicit RecordingSource(const RecordingAddress& address, QObject* parent = nullptr);

    void open() override;
    void close() override;
    void write(const QByteArray&) override {}
    LinkAddress address() const override { return address_; }
    bool canAnswer() const override { return false; }

  private:
    struct Piece {
        StreamKind kind{};
        QByteArray bytes{};
    };

    void play();
    Result<std::vector<Piece>> readDue();
    void tell(const Piece& piece);
    void end(const Error& error);
    std::string name() const { return address_.file.toStdString(); }

    RecordingAddress address_;
    QTimer tick_;
    std::optional<MissionReader> reader_{};
    std::optional<PlayPace> pace_{};  // from the first row on
    std::int64_t last_row_ = 0;
    bool at_end_ = false;
    bool open_ = false;
};

}  // namespace hedr
