#include "core/calibration/history/calibration_record.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/calibration/history/settings_text.h"
#include "core/text/toml.h"
#include "core/text/toml_keys.h"
#include "core/text/toml_lines.h"

namespace hedr {

namespace {

constexpr std::int64_t kRecordFormat = 1;
constexpr NumberRule kFinite{[](double) { return true; }, "must be a finite number"};
constexpr NumberRule kNoLessThanZero{[](double v) { return v >= 0.0; }, "must not be negative"};
constexpr NumberRule kAboveZero{[](double v) { return v > 0.0; }, "must be positive"};
constexpr NumberRule kShare{[](double v) { return v >= -1.0 && v <= 1.0; }, "must be -1 to 1"};

struct VerdictName {
    Verdict verdict;
    std::string_view name;
};
constexpr std::array kVerdictNames{
    VerdictName{Verdict::kAccepted, "accepted"}, VerdictName{Verdict::kUnchanged, "unchanged"},
    VerdictName{Verdict::kNotProven, "not_proven"}, VerdictName{Verdict::kRefused, "refused"}};

std::string listOfTexts(const std::vector<std::string>& texts) {
    std::string list = "[";
    for (const std::string& text : texts) list += (list.size() > 1 ? ", " : "") + quotedToml(text);
    return list + "]";
}

void addEstimate(TomlLines& lines, const Estimate& estimate) {
    lines.add("now", estimate.value);
    lines.add("standard_error", estimate.standard_error);
    if (std::isfinite(estimate.degrees_of_freedom))
        lines.add("degrees_of_freedom", estimate.degrees_of_freedom);
    if (estimate.lopsided != 0.0) lines.add("lopsided", estimate.lopsided);
}

void addInterval(TomlLines& lines, const char* key, const Interval& interval) {
    std::string list = "[";
    list.append(tomlNumber(interval.low)).append(", ").append(tomlNumber(interval.high));
    lines.add(key, list.append("]"));
}

void addTrackWidth(TomlLines& lines, const TrackWidth& width) {
    lines.beginTable("[[track_width]]");
    lines.add("rate_rad_s", width.rate_rad_s);
    addEstimate(lines, width.wheelbase_m);
    lines.add("turns", std::to_string(width.turns));
}

void addProof(TomlLines& lines, const Proof& proof) {
    lines.beginTable("[proof]");
    lines.addText("what", proof.what);
    lines.addText("unit", proof.unit);
    lines.add("parts", std::to_string(proof.parts));
    lines.add("before", proof.before);
    lines.add("after", proof.after);
    lines.add("times_better", proof.times_better);
    addInterval(lines, "times_better_95", proof.times_better_95);
    addInterval(lines, "times_better_99", proof.times_better_99);
}

Verdict readVerdict(TomlKeys& keys) {
    const std::string name = keys.neededText("verdict");
    const auto found = std::ranges::find(kVerdictNames, name, &VerdictName::name);
    if (found != kVerdictNames.end()) return found->verdict;
    keys.refuse("verdict", "must be accepted, unchanged, not_proven or refused");
    return Verdict::kRefused;
}

Interval readInterval(TomlKeys& keys, const char* key) {
    std::array<double, 2> ends{};
    if (!keys.numbers(key, ends)) keys.refuse(key, "is missing");
    return {ends[0], ends[1]};
}

Estimate readEstimate(TomlKeys& keys) {
    Estimate estimate{.value = keys.neededNumber("now", kFinite),
                      .standard_error = keys.neededNumber("standard_error", kNoLessThanZero)};
    estimate.degrees_of_freedom =
        keys.number("degrees_of_freedom", estimate.degrees_of_freedom, kAboveZero);
    estimate.lopsided = keys.number("lopsided", 0.0, kShare);
    return estimate;
}

std::size_t readCount(TomlKeys& keys, const char* key) {
    return static_cast<std::size_t>(std::max<std::int64_t>(0, keys.neededInteger(key)));
}

TrackWidth readTrackWidth(TomlKeys keys) {
    TrackWidth width{.rate_rad_s = keys.neededNumber("rate_rad_s", kNoLessThanZero),
                     .wheelbase_m = readEstimate(keys),
                     .turns = readCount(keys, "turns")};
    keys.refuseOthers();
    return width;
}

RecordedParameter readParameter(TomlKeys keys) {
    RecordedParameter parameter{.key = keys.neededText("key")};
    if (keys.has("was")) parameter.was = keys.neededNumber("was", kFinite);
    parameter.now = readEstimate(keys);
    parameter.stays = keys.flag("stays", false);
    parameter.follows = keys.flag("follows", false);
    keys.refuseOthers();
    return parameter;
}

Proof readProof(TomlKeys keys) {
    Proof proof{.what = keys.neededText("what"), .unit = keys.neededText("unit")};
    proof.parts = readCount(keys, "parts");
    proof.before = keys.neededNumber("before", kNoLessThanZero);
    proof.after = keys.neededNumber("after", kNoLessThanZero);
    proof.times_better = keys.neededNumber("times_better", kNoLessThanZero);
    proof.times_better_95 = readInterval(keys, "times_better_95");
    proof.times_better_99 = readInterval(keys, "times_better_99");
    keys.refuseOthers();
    return proof;
}

RawSamples readRaw(TomlKeys keys) {
    RawSamples raw{keys.neededText("file"), keys.neededText("sha256"), keys.neededText("origin")};
    keys.refuseOthers();
    return raw;
}

CalibrationRecord readRecord(TomlKeys keys) {
    if (keys.neededInteger("format") != kRecordFormat) keys.refuse("format", "must be 1");
    CalibrationRecord record;
    record.procedure = keys.neededText("procedure");
    record.time_utc = keys.neededText("time_utc");
    record.who = keys.text("who", "");
    record.robot = keys.neededText("robot");
    record.surface = keys.text("surface", "");
    if (keys.has("temperature_c"))
        record.temperature_c = keys.neededNumber("temperature_c", kFinite);
    record.program_version = keys.text("program_version", "");
    record.verdict = readVerdict(keys);
    record.reason = keys.neededText("reason");
    record.taken_over = keys.flag("taken_over", false);
    record.remarks = keys.texts("remarks");
    record.vehicle_before = keys.neededText("vehicle_before");
    record.vehicle_after = keys.neededText("vehicle_after");
    if (auto told = keys.table("told")) record.told = readTold(*told);
    for (TomlKeys& each : keys.tables("found")) record.found.push_back(readParameter(each));
    for (TomlKeys& each : keys.tables("track_width"))
        record.track_widths.push_back(readTrackWidth(each));
    if (auto proof = keys.table("proof")) record.proof = readProof(*proof);
    for (TomlKeys& each : keys.tables("raw")) record.raw.push_back(readRaw(each));
    keys.refuseOthers();
    return record;
}

}  // namespace

std::string_view nameOf(Verdict verdict) {
    return std::ranges::find(kVerdictNames, verdict, &VerdictName::verdict)->name;
}

CalibrationRecord recordOf(const Calibration& calibration) {
    CalibrationRecord record{.procedure = std::string(calibration.procedure),
                             .verdict = calibration.verdict,
                             .reason = calibration.reason,
                             .track_widths = calibration.track_widths,
                             .proof = calibration.proof,
                             .remarks = calibration.remarks};
    for (const FoundParameter& found : calibration.found)
        record.found.push_back(
            {std::string(found.key), found.was, found.now, found.stays, found.follows});
    return record;
}

std::string formatRecord(const CalibrationRecord& record) {
    TomlLines lines;
    lines.add("format", std::to_string(kRecordFormat));
    lines.addText("procedure", record.procedure);
    lines.addText("time_utc", record.time_utc);
    lines.addText("who", record.who);
    lines.addText("robot", record.robot);
    lines.addText("surface", record.surface);
    if (record.temperature_c) lines.add("temperature_c", *record.temperature_c);
    lines.addText("program_version", record.program_version);
    lines.addText("verdict", nameOf(record.verdict));
    lines.addText("reason", record.reason);
    lines.addBool("taken_over", record.taken_over);
    lines.add("remarks", listOfTexts(record.remarks));
    lines.addText("vehicle_before", record.vehicle_before);
    lines.addText("vehicle_after", record.vehicle_after);
    addTold(lines, record.told);
    for (const RecordedParameter& found : record.found) {
        lines.beginTable("[[found]]");
        lines.addText("key", found.key);
        if (found.was) lines.add("was", *found.was);
        addEstimate(lines, found.now);
        if (found.stays) lines.addBool("stays", true);
        if (found.follows) lines.addBool("follows", true);
    }
    for (const TrackWidth& width : record.track_widths) addTrackWidth(lines, width);
    if (record.proof) addProof(lines, *record.proof);
    for (const RawSamples& raw : record.raw) {
        lines.beginTable("[[raw]]");
        lines.addText("file", raw.file);
        lines.addText("sha256", raw.sha256);
        lines.addText("origin", raw.origin);
    }
    return std::move(lines).take();
}

Result<CalibrationRecord> parseRecord(std::string_view toml, const std::string& name_for_errors) {
    const auto table = parseToml(toml, name_for_errors);
    if (!table) return tl::make_unexpected(table.error());
    FirstError error(name_for_errors);
    CalibrationRecord record = readRecord(TomlKeys(*table, error));
    if (error.found()) return tl::make_unexpected(*error.found());
    return record;
}

}  // namespace hedr
