#include <QApplication>
#include <QFileInfo>
#include <QTimer>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>

#include "app/appearance.h"
#include "app/demo_robot.h"
#include "app/options.h"
#include "app/session.h"
#include "app/stop_signals.h"
#include "ui/error_text.h"
#include "ui/main_window.h"

namespace {

using namespace std::chrono_literals;

constexpr int kWorkFailed = 1;

int failWith(const hedr::Error& error) {
    std::cerr << "hedr-ocu: " << hedr::errorText(error).toStdString() << '\n';
    return kWorkFailed;
}

std::chrono::milliseconds milliseconds(double seconds) {
    return std::chrono::milliseconds(std::llround(seconds * 1e3));
}

int takeScreenshot(QWidget& window, const QString& file) {
    if (window.grab().save(file)) return 0;
    return failWith({hedr::ErrorCode::kFileUnwritable, file.toStdString(), {}});
}

// `outcome`: the exit code for what was to be done meanwhile.
void schedule(QWidget& window, const hedr::Options& options, int& outcome) {
    if (!options.screenshot.isEmpty()) {
        QTimer::singleShot(milliseconds(options.screenshot_after_s), &window, [&] {
            outcome = takeScreenshot(window, options.screenshot);
            if (!options.exit_after_s) QApplication::quit();
        });
    }
    if (options.exit_after_s) {
        QTimer::singleShot(milliseconds(*options.exit_after_s), &window,
                           [] { QApplication::quit(); });
    }
}

void quitOnSignals(QTimer& poll) {
    QObject::connect(&poll, &QTimer::timeout, [] {
        if (hedr::stopSignalled()) QApplication::quit();
    });
    poll.start(200ms);
}

int run(const hedr::Options& options) {
    hedr::Session::Setup setup{.robots_last = !options.demo};
    if (!options.mission.isEmpty())
        setup.mission = std::filesystem::absolute(options.mission.toStdString());
    if (!options.vehicle.isEmpty()) {
        const auto vehicle = hedr::loadVehicleOrPreset(options.vehicle.toStdString());
        if (!vehicle) return failWith(vehicle.error());
        setup.vehicle = *vehicle;
        if (QFileInfo(options.vehicle).isFile()) setup.vehicle_file = options.vehicle.toStdString();
    }
    std::unique_ptr<hedr::DemoRobot> demo;
    if (options.demo) {
        auto started = hedr::DemoRobot::start();
        if (!started) return failWith(started.error());
        demo = std::move(*started);
    }
    hedr::MainWindow window;
    hedr::Session session(window, setup);
    hedr::rememberAppearance(window);
    window.show();
    int outcome = 0;
    schedule(window, options, outcome);
    QTimer signal_poll;
    quitOnSignals(signal_poll);

    const bool of_demo = options.plan.isEmpty() && demo;
    const QString plan = of_demo ? demo->planFile() : options.plan;
    if (!plan.isEmpty()) session.openPlan({.file = plan, .lasting = !of_demo});
    const QStringList ports = demo ? QStringList{demo->port()} : options.ports;
    session.connectToAll(ports);
    session.publishTo(options.publish);
    if (ports.isEmpty() && options.mission.isEmpty()) session.offerResuming();
    const int exit_code = QApplication::exec();
    hedr::saveGeometry(window);
    return exit_code != 0 ? exit_code : outcome;
}

// Before there is a window: help and complaints need no screen.
auto optionsFrom(int argc, char** argv) {
    const QCoreApplication application(argc, argv);
    QCoreApplication::setOrganizationName("hedr");
    QCoreApplication::setApplicationName("hedr-ocu");
    QCoreApplication::setApplicationVersion(HEDR_VERSION);
    return hedr::parseOptions(QCoreApplication::arguments());
}

bool hasScreen() {
    return qEnvironmentVariableIsSet("DISPLAY") || qEnvironmentVariableIsSet("WAYLAND_DISPLAY") ||
           qEnvironmentVariableIsSet("QT_QPA_PLATFORM");
}

}  // namespace

int main(int argc, char** argv) {
    hedr::holdStopSignals();
    const auto options = optionsFrom(argc, argv);
    if (!options) {
        (options.error().exit_code == 0 ? std::cout : std::cerr)
            << options.error().text.toStdString() << '\n';
        return options.error().exit_code;
    }
    if (!hasScreen()) {
        if (!options->exit_after_s && options->screenshot.isEmpty()) {
            std::cerr
                << "hedr-ocu: There is no screen: neither DISPLAY nor WAYLAND_DISPLAY is set. "
                   "Start it on a desktop, or give --screenshot or --exit-after to run it without "
                   "a window.\n";
            return kWorkFailed;
        }
        qputenv("QT_QPA_PLATFORM", "offscreen");
    }
    const QApplication application(argc, argv);
    return run(*options);
}
