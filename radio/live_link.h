#pragma once

#include <QObject>
#include <QTimer>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>

#include "radio/link/clock_echo.h"
#include "radio/link/link_keys.h"
#include "radio/link/link_meter.h"
#include "radio/link/sensor_rate.h"
#include "radio/live_batch.h"
#include "radio/source/byte_source.h"

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
        std::filesystem::path keys{};  // the folder of the robots' keys; empty: none is known
    };

    explicit LiveLink(const Setup& setup, QObject* parent = nullptr);
    ~LiveLink() override;

  public slots:
    void open(const hedr::LinkAddress& address);
    void close();
    void setFramePeriod(std::chrono::milliseconds period);  // of the batches; 16 ms at first
    void notePlan(const hedr::MissionPlan& plan);
    void noteSite(const hedr::Site& site);
    // The robot is on that floor from now on.
    void noteFloor(const std::string& name);
    // `ticket` is the caller's, another for each request; progress comes with the batches.
    void ask(std::uint64_t ticket, const hedr::Request& request);
    void cancelRequest(std::uint64_t ticket);
    // Whether batches bring what the sensors said, for a calibration.
    void keepSensors(bool keep) { receiver_.keepSensors(keep); }

  signals:
    void batchReady(const hedr::LiveBatch& batch);

  private:
    void setSource(std::unique_ptr<ByteSource> source);
    Result<void> prepareToPlay(const std::filesystem::path& recording);
    void restoreMission();
    Result<MissionReader> goOnBeside(const MissionReader& damaged);
    void tellDirection();
    void noteNewNames(const Site& site);
    void feedWithFloors(const MissionReader& mission);
    void handleOpened();
    void handleFailed(const Error& error);
    void handleBytes(const QByteArray& bytes);
    void handleFrameTime();
    void noteRejected();
    void noteKeys(const Result<void>& kept);
    void noteGap();
    void noteRestart();
    void hearAnswers();
    void askRobot();
    void send(const std::vector<std::uint8_t>& spoken);
    void noteRequests();
    void takeLinkSample();
    void gatherNews();
    void warnOfAssumedWheels();
    void watchSensorRate();
    void warnOfRareSensors();
    void sendBatch();
    void countFrameRate();
    double time_s() const;

    Setup setup_;
    ReceiveClock::time_point begin_ = ReceiveClock::now();
    LinkKeys keys_;
    Receiver receiver_;
    Recorder recorder_;
    std::unique_ptr<ByteSource> source_{};  // of the last open()
    Requests requests_;
    ClockEcho clock_echo_;
    LinkMeter meter_;
    SensorRate sensor_rate_;
    std::uint64_t restarts_ = 0;  // of the robot, so far
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

Q_DECLARE_METATYPE(hedr::MissionPlan)
Q_DECLARE_METATYPE(hedr::Request)
