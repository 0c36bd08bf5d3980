#include "radio/source/simulated_source.h"

#include <QPromise>
#include <QThreadPool>
#include <filesystem>
#include <utility>

#include "core/robot/sensor_csv.h"
#include "core/simulation/scenario.h"

namespace hedr {

SimulatedSource::SimulatedSource(LinkAddress address, double speed, MakeDrive make_drive,
                                 QObject* parent)
    : ByteSource(parent),
      address_(std::move(address)),
      speed_(speed),
      make_drive_(std::move(make_drive)),
      maker_(this),
      tick_(this) {
    tick_.setInterval(kPlayTick_ms);
    tick_.setTimerType(Qt::PreciseTimer);
    connect(&tick_, &QTimer::timeout, this, &SimulatedSource::play);
    connect(&maker_, &QFutureWatcherBase::finished, this, &SimulatedSource::begin);
}

// The worker knows nothing of the source, which may be gone before it is done.
void SimulatedSource::open() {
    close();
    making_ = true;
    const auto promise = std::make_shared<QPromise<Result<SimulatedDrive>>>();
    maker_.setFuture(promise->future());
    QThreadPool::globalInstance()->start([promise, make_drive = make_drive_] {
        promise->start();
        promise->addResult(make_drive());
        promise->finish();
    });
}

void SimulatedSource::close() {
    making_ = false;  // a drive that comes later is for nobody
    tick_.stop();
    robot_.reset();
    reports_.clear();
    said_.clear();
}

void SimulatedSource::begin() {
    if (!std::exchange(making_, false)) return;
    auto drive = maker_.future().takeResult();
    if (!drive) return end(drive.error());
    if (drive->reports.empty())
        return end({ErrorCode::kNoData, toText(address_).toStdString(), "it has no reports"});
    reports_ = std::move(drive->reports);
    next_report_ = 0;
    robot_ = std::make_unique<SimulatedRobot>(drive->vehicle, drive->start);
    pace_.emplace(reports_.front().robot_time_s, speed_);
    tick_.start();
    emit opened();
}

SimulatedRobot::Send SimulatedSource::saying() {
    return [this](std::span<const std::uint8_t> frame) {
        said_.append(reinterpret_cast<const char*>(frame.data()),
                     static_cast<qsizetype>(frame.size()));
    };
}

// The answer comes with the next tick, as from every robot: not before the question is sent.
void SimulatedSource::write(const QByteArray& bytes) {
    if (!robot_) return;
    robot_->hear({reinterpret_cast<const std::uint8_t*>(bytes.constData()),
                  static_cast<std::size_t>(bytes.size())},
                 saying());
}

void SimulatedSource::play() {
    const SimulatedRobot::Send say = saying();
    while (next_report_ < reports_.size() && said_.size() < kMostBytesPerTick &&
           reports_[next_report_].robot_time_s <= pace_->now_s()) {
        robot_->sense(reports_[next_report_++], say);
    }
    const QByteArray said = std::exchange(said_, {});
    if (!said.isEmpty()) emit bytesReceived(said);
    if (robot_ && next_report_ == reports_.size())
        end({ErrorCode::kReplayEnded, toText(address_).toStdString(), "its drive is over"});
}

void SimulatedSource::end(const Error& error) {
    close();
    emit failed(error);
}

std::unique_ptr<SimulatedSource> makeSource(const SimulatorAddress& address) {
    const auto simulate_it = [address]() -> Result<SimulatedDrive> {
        const auto scenario = scenarioByName(address.scenario.toStdString());
        if (!scenario) return tl::make_unexpected(scenario.error());
        SimulatedMission mission = simulate(*scenario, address.seed);
        return SimulatedDrive{mission.vehicle, mission.start, std::move(mission.sensors)};
    };
    return std::make_unique<SimulatedSource>(address, address.speed, simulate_it);
}

std::unique_ptr<SimulatedSource> makeLogSource(const RecordingAddress& address) {
    const std::filesystem::path file = address.file.toStdString();
    const auto load_it = [file]() -> Result<SimulatedDrive> {
        auto log = loadSensorLog(file);
        if (!log) return tl::make_unexpected(log.error());
        const auto vehicle = loadVehicle(file.parent_path() / "vehicle.toml");
        if (!vehicle) return tl::make_unexpected(vehicle.error());
        return SimulatedDrive{*vehicle, {}, std::move(log->reports)};
    };
    return std::make_unique<SimulatedSource>(address, address.speed, load_it);
}

}  // namespace hedr
