#include "core/robot/vehicle_edit.h"

#include <optional>

#include "core/robot/vehicle_keys.h"
#include "core/text/number.h"
#include "core/text/trimmed.h"

namespace hedr {

namespace {

std::string numberText(double value) {
    std::string text;
    appendNumber(text, value);
    return text;
}

struct Line {
    std::string_view text;  // without its end
    std::string_view end;
};

Line nextLine(std::string_view& rest) {
    const std::size_t end = rest.find('\n');
    const std::size_t length = end == std::string_view::npos ? rest.size() : end;
    Line line{rest.substr(0, length), rest.substr(length, end == std::string_view::npos ? 0 : 1)};
    rest.remove_prefix(length + line.end.size());
    return line;
}

bool isSection(std::string_view line) { return trimmed(line).starts_with('['); }

std::string_view keyAsWritten(std::string_view line) {
    return trimmed(line.substr(0, line.find('=')));
}

bool setsKey(std::string_view line, std::string_view key) {
    if (line.find('=') == std::string_view::npos) return false;
    std::string_view name = keyAsWritten(line);
    if (name.size() >= 2 && (name[0] == '"' || name[0] == '\'') && name.back() == name[0])
        name = name.substr(1, name.size() - 2);
    return name == key;
}

// What follows the value: blanks and a comment.
std::string_view behindValue(std::string_view line) {
    const std::size_t begin = line.find_first_not_of(" \t", line.find('=') + 1);
    const std::size_t end = line.find_first_of(" \t\r#", begin);
    return end == std::string_view::npos ? std::string_view() : line.substr(end);
}

// Where a file comes from another system, its lines end as they did.
std::string_view lineEnd(std::string_view toml) {
    const std::size_t end = toml.find('\n');
    return end != std::string_view::npos && end > 0 && toml[end - 1] == '\r' ? "\r\n" : "\n";
}

// A key stands once, before the first section; what is not there yet is added there.
std::string withNumber(std::string_view toml, const std::string& key, double value) {
    std::string result;
    bool done = false;
    const auto set = [&](std::string_view written, std::string_view behind) {
        if (!result.empty() && result.back() != '\n') result += lineEnd(toml);
        result.append(written).append(" = ").append(numberText(value)).append(behind);
        done = true;
    };
    for (std::string_view rest = toml; !rest.empty();) {
        const Line line = nextLine(rest);
        if (!done && isSection(line.text)) set(key, lineEnd(toml));
        if (!done && setsKey(line.text, key)) {
            set(keyAsWritten(line.text), behindValue(line.text));
            result.append(line.end);
            continue;
        }
        result.append(line.text).append(line.end);
    }
    if (!done) set(key, lineEnd(toml));
    return result;
}

std::string withoutNumber(std::string_view toml, const std::string& key) {
    std::string result;
    bool in_section = false;
    for (std::string_view rest = toml; !rest.empty();) {
        const Line line = nextLine(rest);
        in_section = in_section || isSection(line.text);
        if (!in_section && setsKey(line.text, key)) continue;
        result.append(line.text).append(line.end);
    }
    return result;
}

void noteChanges(std::span<const VehicleKey> keys, const Vehicle& before, const Vehicle& after,
                 std::vector<NumberChange>& changes) {
    for (const VehicleKey& key : keys) {
        const NumberChange change{std::string(key.name), vehicleNumber(before, key.name),
                                  vehicleNumber(after, key.name)};
        if (change.before != change.after) changes.push_back(change);
    }
}

}  // namespace

std::vector<NumberChange> numberChanges(const Vehicle& before, const Vehicle& after) {
    std::vector<NumberChange> changes;
    noteChanges(vehicleKeys(), before, after, changes);
    for (const VehicleKeyGroup& group : vehicleKeyGroups())
        noteChanges(group.keys, before, after, changes);
    return changes;
}

Result<std::string> withNumbersOf(const Vehicle& changed, std::string_view toml,
                                  const std::string& name_for_errors) {
    const auto before = parseVehicle(toml, name_for_errors);
    if (!before) return tl::make_unexpected(before.error());
    std::string text(toml);
    for (const NumberChange& change : numberChanges(*before, changed)) {
        text = change.after ? withNumber(text, change.key, *change.after)
                            : withoutNumber(text, change.key);
    }
    const auto after = parseVehicle(text, name_for_errors);
    return after && *after == changed ? text : formatVehicle(changed);
}

}  // namespace hedr
