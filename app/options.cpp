#include "app/options.h"

#include <QCommandLineParser>
#include <QFileInfo>
#include <QImageWriter>

#include "radio/source/link_address.h"

namespace hedr {

namespace {

constexpr int kWrongUsage = 2;

Instead instead(const QString& what) {
    return {what + "\nhedr-ocu --help lists the options.", kWrongUsage};
}

tl::unexpected<Instead> wrongUsage(const QString& what) {
    return tl::make_unexpected(instead(what));
}

double secondsOf(const QString& text, bool& ok) {
    constexpr double kLongest_s = 1e6;
    const double seconds = text.toDouble(&ok);
    ok = ok && seconds >= 0.0 && seconds <= kLongest_s;
    return seconds;
}

Result<std::vector<PublishTarget>> publishTargets(const QStringList& texts) {
    std::vector<PublishTarget> targets;
    targets.reserve(static_cast<std::size_t>(texts.size()));
    for (const QString& text : texts) {
        const auto target = parsePublishTarget(text);
        if (!target) return tl::make_unexpected(target.error());
        targets.push_back(*target);
    }
    return targets;
}

QString whyWrong(const Error& error) {
    return QString::fromStdString(error.subject) + ' ' + QString::fromStdString(error.detail) + '.';
}

QList<QCommandLineOption> optionTable() {
    return {
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
        {"publish",
         "Tell other programs where the robot is; may be repeated. nmea and json wait for them on "
         "this computer, cot sends to this computer; with an address, others too: "
         "nmea=tcp://:PORT, "
         "json=tcp://@ADDRESS:PORT, cot=udp://HOST:PORT.",
         "TARGET"},
        {"screenshot", "Save a picture of the window, and end unless --exit-after is given.",
         "FILE"},
        {"after", "The picture is taken after so many seconds (1).", "SECONDS"},
        {"exit-after", "End the program after so many seconds.", "SECONDS"},
    };
}

// What is wrong with the ports; none: nothing.
std::optional<Instead> wrongPort(const QStringList& ports) {
    for (const QString& port : ports) {
        if (port.isEmpty()) return instead("--port is empty.");
        if (ports.count(port) > 1)
            return instead("--port " + port + " is given twice: one robot has one port.");
        if (const auto address = parseLinkAddress(port); !address)
            return instead("--port " + whyWrong(address.error()));
    }
    return std::nullopt;
}

}  // namespace

tl::expected<Options, Instead> parseOptions(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription("Shows a tele-operated robot live on the floor plan.");
    const QCommandLineOption help = parser.addHelpOption();
    const QCommandLineOption version = parser.addVersionOption();
    parser.addOptions(optionTable());
    if (!parser.parse(arguments)) return wrongUsage(parser.errorText());
    if (parser.isSet(help) || parser.isSet("help-all"))
        return tl::make_unexpected(Instead{parser.helpText(), 0});
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
    if (const auto wrong = wrongPort(options.ports)) return tl::make_unexpected(*wrong);
    const auto publish = publishTargets(parser.values("publish"));
    if (!publish) return wrongUsage("--publish " + whyWrong(publish.error()));
    options.publish = *publish;
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
