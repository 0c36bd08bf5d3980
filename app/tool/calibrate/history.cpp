#include <filesystem>
#include <iomanip>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/tool/calibrate/verbs.h"
#include "app/tool/json_line.h"
#include "core/calibration/history/vehicle_history.h"
#include "core/calibration/history/vehicle_update.h"
#include "core/robot/vehicle_edit.h"
#include "core/text/clean_text.h"

namespace hedr::tool {

namespace {

struct HistoryOptions {
    std::string vehicle;
    std::vector<std::string> entries;
    std::string out;
    std::string who;
    bool before = false;
    bool json = false;
};

Result<HistoryEntry> entryOf(const HistoryOptions& options, std::size_t number) {
    return historyEntry(historyFolderOf(options.vehicle), options.entries[number]);
}

nlohmann::ordered_json jsonOf(const ProcedureSettings& told) {
    auto object = nlohmann::ordered_json::object();
    if (told.turns) object["turns"] = *told.turns;
    if (told.closed) object["closed"] = true;
    if (told.distance_m) object["distance_m"] = *told.distance_m;
    if (told.on_before_s != 0.0) object["on_before_s"] = told.on_before_s;
    if (told.room_changes) object["room_changes"] = true;
    for (const UmbmarkEnd& end : told.ends) {
        nlohmann::ordered_json ended{{"run", end.run}, {"x_m", end.way.x}, {"y_m", end.way.y}};
        if (end.said) ended["direction"] = nameOf(*end.said);
        object["ends"].push_back(std::move(ended));
    }
    return object;
}

nlohmann::ordered_json jsonOf(const HistoryEntry& entry) {
    if (!entry.record) {
        return {{"entry", entry.name},
                {"damage", entry.record.error().subject + ": " + entry.record.error().detail}};
    }
    const CalibrationRecord& record = *entry.record;
    auto found = nlohmann::ordered_json::array();
    for (const RecordedParameter& each : record.found) {
        const Interval interval = each.now.interval();
        found.push_back({{"key", each.key},
                         {"was", each.was ? nlohmann::ordered_json(*each.was) : nullptr},
                         {"now", each.now.value},
                         {"standard_error", each.now.standard_error},
                         {"interval_95", {interval.low, interval.high}},
                         {"stays", each.stays},
                         {"follows", each.follows}});
    }
    return {{"entry", entry.name},
            {"procedure", record.procedure},
            {"time_utc", record.time_utc},
            {"who", record.who},
            {"robot", record.robot},
            {"surface", record.surface},
            {"temperature_c",
             record.temperature_c ? nlohmann::ordered_json(*record.temperature_c) : nullptr},
            {"verdict", nameOf(record.verdict)},
            {"reason", record.reason},
            {"taken_over", record.taken_over},
            {"told", jsonOf(record.told)},
            {"found", found}};
}

void print(const HistoryEntry& entry) {
    std::cout << entry.name;
    if (!entry.record) {
        std::cout << "  " << complaintAbout(entry) << '\n';
        return;
    }
    const CalibrationRecord& record = *entry.record;
    std::cout << "  " << nameOf(record.verdict) << (record.taken_over ? ", taken over" : "");
    if (!record.who.empty()) std::cout << "  by " << cleanText(record.who);
    if (!record.surface.empty()) std::cout << "  on " << cleanText(record.surface);
    std::cout << '\n';
    for (const RecordedParameter& found : record.found) {
        std::cout << "    " << found.key << ' ';
        if (found.was) std::cout << *found.was;
        std::cout << " -> " << found.now.value << ' '
                  << (found.follows ? "goes with the others" : marginWords(found.now))
                  << (found.stays ? ", stays" : "") << '\n';
    }
}

Result<void> runHistory(const HistoryOptions& options) {
    const auto entries = historyBeside(options.vehicle);
    if (!entries) return tl::make_unexpected(entries.error());
    if (options.json) {
        auto list = nlohmann::ordered_json::array();
        for (const HistoryEntry& entry : *entries) list.push_back(jsonOf(entry));
        std::cout << jsonLine({{"entries", list}});
        return {};
    }
    if (entries->empty()) std::cout << options.vehicle << " has no history yet\n";
    for (const HistoryEntry& entry : *entries) print(entry);
    return {};
}

// What the vehicle file was after that calibration.
Result<Vehicle> vehicleAfter(const HistoryOptions& options, std::size_t number) {
    if (number >= options.entries.size()) return loadVehicle(options.vehicle);
    const auto entry = entryOf(options, number);
    if (!entry) return tl::make_unexpected(entry.error());
    if (!entry->record) return tl::make_unexpected(entry->record.error());
    return parseVehicle(entry->record->vehicle_after, entry->name);
}

nlohmann::ordered_json jsonOf(const std::optional<double>& value) {
    return value ? nlohmann::ordered_json(*value) : nullptr;
}

std::string textOf(const std::optional<double>& value) {
    std::ostringstream text;
    if (value) text << *value;
    return value ? text.str() : "none";
}

Result<void> runCompare(const HistoryOptions& options) {
    const auto first = vehicleAfter(options, 0);
    if (!first) return tl::make_unexpected(first.error());
    const auto second = vehicleAfter(options, 1);
    if (!second) return tl::make_unexpected(second.error());
    const std::vector<NumberChange> changes = numberChanges(*first, *second);
    if (options.json) {
        auto list = nlohmann::ordered_json::array();
        for (const NumberChange& change : changes) {
            list.push_back({{"key", change.key},
                            {"before", jsonOf(change.before)},
                            {"after", jsonOf(change.after)}});
        }
        std::cout << jsonLine({{"changes", list}});
        return {};
    }
    if (changes.empty()) std::cout << "no number differs\n";
    for (const NumberChange& change : changes) {
        std::cout << change.key << "  " << textOf(change.before) << " -> " << textOf(change.after)
                  << '\n';
    }
    return {};
}

Result<void> runRestore(const HistoryOptions& options) {
    const auto entry = entryOf(options, 0);
    if (!entry) return tl::make_unexpected(entry.error());
    const RestoreTo to = options.before ? RestoreTo::kBefore : RestoreTo::kAfter;
    auto restored = restoreVehicle(options.vehicle, *entry, to, nowUtc(), whoIsIt(options.who));
    if (!restored) return restored;
    std::cout << options.vehicle << " is as it was " << (options.before ? "before " : "after ")
              << entry->name << '\n';
    return {};
}

Result<void> runExport(const HistoryOptions& options) {
    const auto entry = entryOf(options, 0);
    if (!entry) return tl::make_unexpected(entry.error());
    auto exported = exportEntry(*entry, options.out);
    if (!exported) return exported;
    std::cout << options.out << " holds " << entry->name << '\n';
    return {};
}

}  // namespace

Result<std::vector<HistoryEntry>> historyBeside(const std::string& vehicle_file) {
    std::error_code ignored;
    const std::filesystem::path history = historyFolderOf(vehicle_file);
    if (!std::filesystem::exists(vehicle_file, ignored) &&
        !std::filesystem::exists(history, ignored))
        return fail(ErrorCode::kFileMissing, vehicle_file);
    return loadHistory(history);
}

std::string complaintAbout(const HistoryEntry& entry) {
    const Error& error = entry.record.error();
    return "cannot be read: " + error.subject + ": " + error.detail;
}

void addVehicleFile(CLI::App& app, std::string& vehicle_file) {
    app.add_option("--vehicle", vehicle_file, "The vehicle.toml beside which the history lies")
        ->required()
        ->check(notEmpty());
}

Job addCalibrateHistory(CLI::App& app) {
    const auto options = std::make_shared<HistoryOptions>();
    addVehicleFile(app, options->vehicle);
    app.add_flag("--json", options->json, "One JSON object instead of text");
    return [options] { return runHistory(*options); };
}

Job addCalibrateCompare(CLI::App& app) {
    const auto options = std::make_shared<HistoryOptions>();
    app.add_option("ENTRY", options->entries,
                   "One entry of the history, beside the vehicle file as it is now, or two")
        ->required()
        ->check(notEmpty())
        ->expected(1, 2);
    addVehicleFile(app, options->vehicle);
    app.add_flag("--json", options->json, "One JSON object instead of text");
    return [options] { return runCompare(*options); };
}

Job addCalibrateRestore(CLI::App& app) {
    const auto options = std::make_shared<HistoryOptions>();
    app.add_option("ENTRY", options->entries, "Its name or a part of it")
        ->required()
        ->check(notEmpty())
        ->expected(1);
    addVehicleFile(app, options->vehicle);
    app.add_flag("--before", options->before, "As it was before that calibration, not after it");
    app.add_option("--operator", options->who, "Who restores it, for the history")->check(aName());
    return [options] { return runRestore(*options); };
}

Job addCalibrateExport(CLI::App& app) {
    const auto options = std::make_shared<HistoryOptions>();
    app.add_option("ENTRY", options->entries, "Its name or a part of it")
        ->required()
        ->check(notEmpty())
        ->expected(1);
    addVehicleFile(app, options->vehicle);
    app.add_option("--out", options->out, "A new folder")->required()->check(notEmpty());
    return [options] { return runExport(*options); };
}

}  // namespace hedr::tool
