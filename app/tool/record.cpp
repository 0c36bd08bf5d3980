#include <QCoreApplication>
#include <QTimer>
#include <iostream>
#include <memory>
#include <utility>

#include "app/stop_signals.h"
#include "app/tool/command.h"
#include "radio/live_link.h"
#include "radio/robot_key.h"
#include "ui/error_text.h"

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

struct ToldOfTrust {
    bool key_error = false;
    bool no_key = false;
};

// Once each; the recording goes on, for every byte is kept.
void tellOfTrust(const LiveBatch& batch, ToldOfTrust& told) {
    if (batch.key_error && !std::exchange(told.key_error, true)) warn(*batch.key_error);
    const bool strange = batch.signing.no_key + batch.signing.bad_tag > 0;
    if (strange && batch.signing.signed_frames == 0 && !std::exchange(told.no_key, true)) {
        std::cerr << "hedr: The robot signs what it says, and this computer has no key for it: "
                     "nothing of it is believed. Copy its key file into "
                  << defaultKeyFolder().string()
                  << " and start again. What is recorded until then can be "
                     "computed with hedr fuse --key.\n";
    }
}

// Until a signal comes, or the end of what is played. A port that goes away is waited for; one that
// was never there is an error.
Result<void> runRecord(const Options& options) {
    const auto setup = setupFrom(options);
    if (!setup) return tl::make_unexpected(setup.error());
    holdStopSignals();
    Result<void> outcome;
    bool was_open = false;
    ToldOfTrust told;
    LiveLink link(*setup);
    QObject::connect(&link, &LiveLink::batchReady, [&](const LiveBatch& batch) {
        if (!was_open && batch.port == PortState::kOpen) {
            was_open = true;
            std::cerr << "Recording " << options.port << " to " << options.out
                      << ", Ctrl+C ends it\n";
        }
        for (const Error& warning : batch.warnings) warn(warning);
        tellOfTrust(batch, told);
        const bool over = batch.port_error && batch.port_error->code == ErrorCode::kReplayEnded;
        const std::optional<Error> error = batch.recorder.error ? batch.recorder.error
                                           : was_open           ? std::nullopt
                                                                : batch.port_error;
        if (over && !error) QCoreApplication::quit();
        if (!error) return;
        outcome = tl::make_unexpected(*error);
        QCoreApplication::quit();
    });
    QTimer stop_poll;
    QObject::connect(&stop_poll, &QTimer::timeout, [] {
        if (stopSignalled()) QCoreApplication::quit();
    });
    stop_poll.start(kStopPoll_ms);
    QTimer::singleShot(0, &link, [&] {
        link.open(parseLinkAddress(QString::fromStdString(options.port)).value());
    });
    QCoreApplication::exec();
    link.close();
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
