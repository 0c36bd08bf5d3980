#pragma once

#include <QFutureWatcher>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "radio/simulated_robot.h"
#include "radio/source/byte_source.h"
#include "radio/source/play_pace.h"

namespace hedr {

// What a simulated robot lives through.
struct SimulatedDrive {
    Vehicle vehicle{};
    Pose<World> start{};
    std::vector<SensorReport> reports{};
};

// A robot in this process that runs the firmware header on given sensor values: it speaks in its
// own time and answers requests. At the end of its drive it fails with kReplayEnded.
class SimulatedSource : public ByteSource {
    Q_OBJECT

  public:
    // Computed on another thread, for it may take seconds; the source is open once it is there.
    using MakeDrive = std::function<Result<SimulatedDrive>()>;

    SimulatedSource(LinkAddress address, double speed, MakeDrive make_drive,
                    QObject* parent = nullptr);

    void open() override;
    void close() override;
    void write(const QByteArray& bytes) override;
    LinkAddress address() const override { return address_; }

  private:
    void begin();
    void play();
    void end(const Error& error);
    SimulatedRobot::Send saying();

    LinkAddress address_;
    double speed_;
    MakeDrive make_drive_;
    QFutureWatcher<Result<SimulatedDrive>> maker_;
    bool making_ = false;
    QTimer tick_;
    std::vector<SensorReport> reports_{};
    std::size_t next_report_ = 0;
    std::optional<PlayPace> pace_{};
    std::unique_ptr<SimulatedRobot> robot_{};  // while the source is open
    QByteArray said_{};                        // and not yet received
};

// Errors of the drive: kUnknownName.
std::unique_ptr<SimulatedSource> makeSource(const SimulatorAddress& address);
// Of a sensors.csv, with the vehicle.toml beside it. Errors of the drive: those of loadSensorLog
// and loadVehicle.
std::unique_ptr<SimulatedSource> makeLogSource(const RecordingAddress& address);

}  // namespace hedr
