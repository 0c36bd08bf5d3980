#include "app/options.h"

#include <QCommandLineParser>
#include <QFileInfo>
#include <QImageWriter>

#include "radio/source/link_address.h"

namespace hedr {

namespace {

constexpr int kWrongUsage = 2;

tl::unexpected<Instead> wrongUsage(const QString& what) {
    return tl::make_unexpected(Instead{what + "\nhedr-ocu --help lists the options.", kWrongUsage});
}

double secondsOf(const QString& text, bool& ok) {
    constexpr double kLongest_s = 1e6;
    const double seconds = text.toDouble(&ok);
    ok = ok && seconds >= 0.0 && seconds <= kLongest_s;
    return seconds;
}

}  // namespace

tl::expected<Options, Instead> parseOptions(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription("Shows a tele-operated robot live on the floor plan.");
    const QCommandLineOption help = parser.addHelpOption();
    const QCommandLineOption version = parser.addVersionOption();
    parser.addOptions({
        {"port",
         "Connect at once: a serial port, tcp://HOST:PORT, udp://HOST:PORT, or to listen "
         "udp://:PORT, tcp://:PORT. Without a baud rate it is found out. A mission or a "
         "sensors.csv is played: file:///FILE[?speed=X], or its name. sim://SCENARIO"
         "[?seed=N&speed=X] is a simulated robot. Once for each robot.",
         "ADDRESS"},
        {"demo", "A simulated robot in the sample building."},
        {"plan", "Floor plan: an image, its .toml, or a ROS map .yaml.", "FILE"},
        {"vehicle", "vehicle.toml or a preset; else as the robot says.", "FILE"},
        {"out", "Mission file to record to; one that is there is continued.", "MISSION"},
        {"screenshot", "Save a picture of the window, and end unless --exit-after is given.",
         "FILE"},
        {"after", "The picture is taken after so many seconds (1).", "SECONDS"},
        {"exit-after", "End the program after so many seconds.", "SECONDS"},
    });
    if (!parser.parse(arguments)) return wrongUsage(parser.errorText());
    if (parser.isSet(help)) return tl::make_unexpected(Instead{parser.helpText(), 0});
    if (parser.isSet(version)) {
        return tl::make_unexpected(Instead{
            QCoreApplication::applicationName() + ' ' + QCoreApplication::applicationVersion(), 0});
    }
    if (!parser.positionalArguments().isEmpty()) {
        return wrongUsage("\"" + parser.positionalArguments().first() + "\" is not an option.");
    }
    Options options{.ports = parser.values("port"),
                    .demo = parser.isSet("demo"),
                    .plan = parser.value("plan"),
                    .vehicle = parser.value("vehicle"),
                    .mission = parser.value("out"),
                    .screenshot = parser.value("screenshot")};
    if (options.demo && !options.ports.isEmpty())
        return wrongUsage("--demo brings its own --port.");
    for (const QString& port : options.ports) {
        if (port.isEmpty()) return wrongUsage("--port is empty.");
        if (options.ports.count(port) > 1)
            return wrongUsage("--port " + port + " is given twice: one robot has one port.");
        if (const auto address = parseLinkAddress(port); !address) {
            return wrongUsage("--port " + QString::fromStdString(address.error().subject) + ' ' +
                              QString::fromStdString(address.error().detail) + '.');
        }
    }
    for (const char* name : {"plan", "vehicle", "out", "screenshot"}) {
        if (parser.isSet(name) && parser.value(name).isEmpty()) {
            return wrongUsage(QStringLiteral("--%1 is empty.").arg(name));
        }
    }
    bool ok = true;
    const QByteArray kind = QFileInfo(options.screenshot).suffix().toLower().toLatin1();
    if (!options.screenshot.isEmpty() && !QImageWriter::supportedImageFormats().contains(kind)) {
        return wrongUsage(
            QStringLiteral("--screenshot needs the name of a picture, such as live.png"));
    }
    if (parser.isSet("after")) options.screenshot_after_s = secondsOf(parser.value("after"), ok);
    if (!ok) return wrongUsage("--after needs a number of seconds.");
    if (parser.isSet("exit-after"))
        options.exit_after_s = secondsOf(parser.value("exit-after"), ok);
    if (!ok) return wrongUsage("--exit-after needs a number of seconds.");
    return options;
}

}  // namespace hedr
