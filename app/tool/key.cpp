#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/tool/command.h"
#include "app/tool/json_line.h"
#include "radio/robot_key.h"
#include "ui/error_text.h"

namespace hedr::tool {

namespace {

namespace fs = std::filesystem;

struct Options {
    std::string name;
    std::string out;
    std::string format = "hex";
    bool json = false;
};

void sayFile(const Options& options, const std::string& name, const fs::path& file) {
    if (options.json) {
        std::cout << jsonLine({{"name", name}, {"file", file.string()}});
    } else {
        std::cout << file.string() << '\n';
    }
}

// A folder that is misspelt would be made otherwise, and the secret left in it.
Result<void> checkFolderIsThere(const std::string& file) {
    const fs::path folder = fs::path(file).parent_path();
    std::error_code ignored;
    if (folder.empty() || fs::is_directory(folder, ignored)) return {};
    return fail(ErrorCode::kFileUnwritable, file, "there is no folder " + folder.string());
}

Result<void> make(const Options& options) {
    if (auto checked = checkFolderIsThere(options.out); !checked) return checked;
    const fs::path file =
        options.out.empty() ? keyFileOf(defaultKeyFolder(), options.name) : fs::path(options.out);
    auto written = writeSecretFile(file, keyText(newKey(options.name)));
    if (written) sayFile(options, options.name, file);
    return written;
}

Result<void> list(const Options& options) {
    const StoredKeys stored = loadKeys(defaultKeyFolder());
    auto keys = nlohmann::ordered_json::array();
    for (const StoredKey& entry : stored.keys) {
        keys.push_back({{"name", entry.key.name}, {"file", entry.file.string()}});
        if (!options.json) std::cout << entry.key.name << '\n';
    }
    if (options.json) std::cout << jsonLine({{"keys", keys}});
    if (stored.refused.empty()) return {};
    for (std::size_t i = 1; i < stored.refused.size(); ++i) {
        warn(stored.refused[i]);
    }
    return tl::make_unexpected(stored.refused.front());
}

Result<void> show(const Options& options) {
    const auto key = loadKeyNamed(options.name);
    if (!key) return tl::make_unexpected(key.error());
    if (options.json) {
        std::cout << jsonLine({{"name", key->name}, {"key", hexOf(key->key)}});
    } else {
        std::cout << (options.format == "c" ? cHeaderOf(*key) : hexOf(key->key) + '\n');
    }
    return {};
}

// The key goes to the robot with its program, over the cable: a way over the wire would send it
// through the air, or be a door for whoever restarts the robot first.
Result<void> install(const Options& options) {
    if (auto checked = checkFolderIsThere(options.out); !checked) return checked;
    const auto key = loadKeyNamed(options.name);
    if (!key) return tl::make_unexpected(key.error());
    auto written = writeSecretFile(options.out, cHeaderOf(*key));
    if (written) sayFile(options, key->name, options.out);
    return written;
}

CLI::Validator aRobotName() {
    return CLI::Validator(
        [](const std::string& name) {
            const auto good = checkRobotName(name);
            return good ? std::string() : complaintAbout(good.error());
        },
        "", "robot's name");
}

void addJson(CLI::App& app, Options& options) {
    app.add_flag("--json", options.json, "One JSON object on standard output");
}

void addMake(CLI::App& app, Options& options) {
    app.add_option("NAME", options.name, "The robot, as it calls itself in its hello")
        ->required()
        ->check(aRobotName());
    app.add_option("--out", options.out, "Another place than the folder of keys")
        ->check(notEmpty());
    addJson(app, options);
}

void addNameOrFile(CLI::App& app, Options& options) {
    app.add_option("NAME", options.name, "A robot that has a key, or a file *.key")
        ->required()
        ->check(notEmpty());
}

void addShow(CLI::App& app, Options& options) {
    addNameOrFile(app, options);
    app.add_option("--format", options.format, "hex, or c for firmware")
        ->check(oneOf({"hex", "c"}));
    addJson(app, options);
}

void addInstall(CLI::App& app, Options& options) {
    options.out = "hedr_key.h";
    addNameOrFile(app, options);
    app.add_option("--out", options.out, "The header for the robot's program (hedr_key.h)")
        ->check(notEmpty());
    addJson(app, options);
}

using AddOptions = void (*)(CLI::App& app, Options& options);
using Run = Result<void> (*)(const Options& options);

Verb keyVerb(const char* name, const char* description, AddOptions add, Run run) {
    return {name, description, [add, run](CLI::App& app) -> Job {
                const auto options = std::make_shared<Options>();
                add(app, *options);
                return [options, run] { return run(*options); };
            }};
}

}  // namespace

Job addKey(CLI::App& app) {
    return addVerbs(app, {keyVerb("make", "Make a new key for a robot", addMake, make),
                          keyVerb("list", "Name the robots that have a key", addJson, list),
                          keyVerb("show", "Print a key", addShow, show),
                          keyVerb("install", "Write a key as a header for the robot's program",
                                  addInstall, install)});
}

}  // namespace hedr::tool
