#pragma once

#include <QObject>
#include <QTimer>
#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>

#include "core/mission/mission_writer.h"
#include "radio/live_batch.h"
#include "radio/receiver.h"
#include "radio/recorder.h"
#include "radio/serial_source.h"

namespace hedr {

// Everything of the radio thread: port, recorder, receiver. Bytes are recorded before they are
// understood; what came of them goes to the GUI by value, once a frame.
class LiveLink : public QObject {
    Q_OBJECT

  public:
    struct Setup {
        Receiver::Setup receiver{};
        std::filesystem::path mission{};  // an existing mission is continued
    };

    explicit LiveLink(Setup setup, QObject* parent = nullptr);
    ~LiveLink() override;

  public slots:
    void open(const hedr::SerialAddress& address);
    void close();
    void noteStartedPlan(const QString& plan_file);

  signals:
    void batchReady(const hedr::LiveBatch& batch);

  private:
    void restoreMission();
    void handleOpened();
    void handleFailed(const Error& error);
    void handleBytes(const QByteArray& bytes);
    void sendBatch();
    LiveBatch currentBatch();
    double frameRate(ReceiveClock::time_point now);

    Setup setup_;
    Receiver receiver_;
    Recorder recorder_;
    SerialSource source_;
    QTimer frame_timer_;
    PortState port_ = PortState::kClosed;
    std::optional<Error> port_error_{};
    std::optional<ReceiveClock::time_point> last_byte_{};
    std::optional<ReceiveClock::time_point> last_frame_{};
    bool news_ = false;
};

}  // namespace hedr
