#pragma once

#include <QObject>
#include <QTimer>
#include <filesystem>
#include <optional>

#include "radio/live_batch.h"
#include "radio/source/serial_source.h"

namespace hedr {

class MissionReader;

// Everything of the radio thread: port, recorder, receiver. Bytes go to the recorder before they
// are understood; what came of them goes to the GUI by value, once a frame.
class LiveLink : public QObject {
    Q_OBJECT

  public:
    struct Setup {
        std::optional<Vehicle> vehicle{};  // none: as the robot says
        std::filesystem::path mission;     // one that is there already is continued
        MissionHeader header{};
    };

    explicit LiveLink(const Setup& setup, QObject* parent = nullptr);
    ~LiveLink() override;

  public slots:
    void open(const hedr::SerialAddress& address);
    void close();
    void notePlan(const hedr::MissionPlan& plan);
    void noteSite(const hedr::Site& site);
    // The robot is on that floor from now on.
    void noteFloor(const std::string& name);

  signals:
    void batchReady(const hedr::LiveBatch& batch);

  private:
    void restoreMission();
    void tellDirection();
    void noteNewNames(const Site& site);
    void feedWithFloors(const MissionReader& mission);
    void handleOpened();
    void handleFailed(const Error& error);
    void handleBytes(const QByteArray& bytes);
    void handleFrameTime();
    void gatherNews();
    void sendBatch();
    void countFrameRate();
    double time_s() const;

    Setup setup_;
    ReceiveClock::time_point begin_ = ReceiveClock::now();
    Receiver receiver_;
    Recorder recorder_;
    SerialSource source_;
    QTimer frame_timer_;
    LiveBatch batch_{};
    bool news_ = false;
    bool restored_ = false;
    bool site_noted_ = false;
    std::vector<std::string> floor_names_{};  // of the site that was noted last
    std::optional<double> direction_rad_{};   // of the site that was noted last
    bool vehicle_noted_ = false;
    double rate_since_s_ = 0.0;
    std::uint64_t rate_frames_ = 0;
};

}  // namespace hedr

Q_DECLARE_METATYPE(hedr::SerialAddress)
Q_DECLARE_METATYPE(hedr::MissionPlan)
