#include <QCoreApplication>
#include <array>
#include <iostream>
#include <string>
#include <utility>

#include "app/tool/command.h"
#include "ui/error_text.h"

namespace {

using hedr::tool::Job;

constexpr int kWorkFailed = 1;
constexpr int kWrongUsage = 2;

struct Entry {
    const char* name;
    const char* description;
    Job (*add)(CLI::App& app);
};

constexpr std::array kCommands{
    Entry{"simulate", "Simulate a mission: sensors, truth, vehicle and plan",
          hedr::tool::addSimulate},
    Entry{"fuse", "Compute a track from a sensor log or a mission", hedr::tool::addFuse},
    Entry{"evaluate", "Compare a track with the truth", hedr::tool::addEvaluate},
    Entry{"reproduce", "A paper's experiment, simulated: its figures beside ours",
          hedr::tool::addReproduce},
    Entry{"tune", "Find the gains of a GH filter on a log with truth", hedr::tool::addTune},
    Entry{"replay", "Act as the robot: send a log over a serial line", hedr::tool::addReplay},
    Entry{"record", "Record a serial port to a mission file", hedr::tool::addRecord},
    Entry{"info", "Say what a mission file holds", hedr::tool::addInfo},
    Entry{"recover", "Write what is left of a damaged mission to a new file",
          hedr::tool::addRecover},
    Entry{"calibrate", "Find the parameters of a robot, and look after its history",
          hedr::tool::addCalibrate},
    Entry{"plan", "Work on a floor plan: what it is, where it lies, other formats",
          hedr::tool::addPlan},
    Entry{"key", "Make the keys with which a robot and its laptop sign", hedr::tool::addKey},
};

// Empty where the first word is a subcommand or an option.
std::string complaintAboutSubcommand(const std::string& word) {
    std::string names;
    for (const Entry& entry : kCommands) {
        if (word == entry.name) return {};
        names += (names.empty() ? "" : ", ") + std::string(entry.name);
    }
    return word.starts_with('-') ? "" : "\"" + word + "\" is no subcommand; known are " + names;
}

hedr::Result<void> withinMemory(const Job& job) {
    try {
        return job();
    } catch (const std::bad_alloc&) {
        return hedr::fail(hedr::ErrorCode::kFileTooLarge, "what was asked for",
                          "it does not fit into memory");
    }
}

int run(const Job& job) {
    auto done = withinMemory(job);
    // What was printed is the result, too: a full disk may show only now.
    if (done && !std::cout.flush())
        done = hedr::fail(hedr::ErrorCode::kFileUnwritable, "standard output", "it takes no more");
    if (done) return 0;
    std::cerr << "hedr: " << hedr::errorText(done.error()).toStdString() << '\n';
    return kWorkFailed;
}

}  // namespace

int main(int argc, char** argv) {
    const QCoreApplication application(argc, argv);
    QCoreApplication::setApplicationName("hedr");
    QCoreApplication::setApplicationVersion(HEDR_VERSION);
    CLI::App app{"hedr: where is my robot? Dead reckoning with heuristics, on the command line."};
    app.require_subcommand(1);
    app.set_version_flag("--version", "hedr " HEDR_VERSION);
    std::array<std::pair<CLI::App*, Job>, kCommands.size()> jobs;
    for (std::size_t i = 0; i < kCommands.size(); ++i) {
        CLI::App* sub = app.add_subcommand(kCommands[i].name, kCommands[i].description);
        jobs[i] = {sub, kCommands[i].add(*sub)};
    }
    const std::string complaint = argc > 1 ? complaintAboutSubcommand(argv[1]) : "";
    if (!complaint.empty()) {
        std::cerr << complaint << '\n';
        return kWrongUsage;
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : kWrongUsage;
    }
    for (const auto& [sub, job] : jobs) {
        if (sub->parsed()) return run(job);
    }
    return kWrongUsage;
}
