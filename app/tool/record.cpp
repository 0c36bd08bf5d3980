#include <QCoreApplication>
#include <QTimer>
#include <iostream>
#include <memory>

#include "app/stop_signals.h"
#include "app/tool/command.h"
#include "app/tool/record_report.h"
#include "radio/live_link.h"
#include "radio/robot_key.h"
#include "ui/link_state.h"

namespace hedr::tool {

namespace {

struct Options {
    std::string port;
    std::string out;
    std::string vehicle;
};

constexpr int kStopPoll_ms = 100;

CLI::Validator aLinkAddress() {
    return CLI::Validator(
        [](const std::string& text) {
            const auto address = parseLinkAddress(QString::fromStdString(text));
            return address ? std::string() : complaintAbout(address.error());
        },
        "", "address");
}

Result<LiveLink::Setup> setupFrom(const Options& options) {
    LiveLink::Setup setup;
    setup.mission = options.out;
    setup.keys = defaultKeyFolder();
    setup.header.start = std::chrono::system_clock::now();
    setup.header.program_version = QCoreApplication::applicationVersion().toStdString();
    if (!options.vehicle.empty()) {
        const auto vehicle = loadVehicleOrPreset(options.vehicle);
        if (!vehicle) return tl::make_unexpected(vehicle.error());
        setup.vehicle = *vehicle;
    }
    return setup;
}

// Why the recording cannot go on. A port that goes away is waited for, and so is a robot that is to
// connect; a port that was never there is an error. What is played comes back from a gap only.
std::optional<Error> endsIt(const LiveBatch& batch, bool was_open) {
    if (batch.recorder.error || !batch.port_error) return batch.recorder.error;
    const bool played = std::holds_alternative<RecordingAddress>(batch.address) ||
                        std::holds_alternative<SimulatorAddress>(batch.address);
    const bool waits =
        played ? batch.port_error->code == ErrorCode::kReplayGap : was_open || isAwaited(batch);
    return waits ? std::nullopt : batch.port_error;
}

// Until a signal comes, or the end of what is played.
Result<void> runRecord(const Options& options) {
    const auto setup = setupFrom(options);
    if (!setup) return tl::make_unexpected(setup.error());
    holdStopSignals();
    Result<void> outcome;
    RecordReport report(options.port, options.out);
    LiveLink link(*setup);
    QObject::connect(&link, &LiveLink::batchReady, [&](const LiveBatch& batch) {
        report.take(batch);
        const std::optional<Error> error = endsIt(batch, report.wasOpen());
        if (!error) return;
        if (error->code != ErrorCode::kReplayEnded) outcome = tl::make_unexpected(*error);
        QCoreApplication::quit();
    });
    QTimer stop_poll;
    QObject::connect(&stop_poll, &QTimer::timeout, [&] {
        report.tellLink();
        if (stopSignalled()) QCoreApplication::quit();
    });
    stop_poll.start(kStopPoll_ms);
    QTimer::singleShot(0, &link, [&] {
        link.open(parseLinkAddress(QString::fromStdString(options.port)).value());
    });
    QCoreApplication::exec();
    link.close();
    if (outcome) report.finish();
    return outcome;
}

}  // namespace

Job addRecord(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    app.add_option("--port", options->port,
                   "DEVICE[:BAUD], tcp://HOST:PORT or udp://HOST:PORT; to listen tcp://:PORT, "
                   "udp://:PORT; to play a mission or a sensors.csv file:///FILE[?speed=X]; "
                   "to simulate sim://SCENARIO[?seed=N&speed=X]")
        ->required()
        ->check(notEmpty())
        ->check(aLinkAddress());
    app.add_option("--out", options->out, "Mission file; one that is there is continued")
        ->required()
        ->check(notEmpty());
    app.add_option("--vehicle", options->vehicle, vehicleHelp() + "; else as the robot says");
    return [options] { return runRecord(*options); };
}

}  // namespace hedr::tool
