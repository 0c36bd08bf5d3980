#include "core/calibration/history/settings_text.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace hedr {

namespace {

constexpr NumberRule kFinite{[](double v) { return std::isfinite(v); }, "must be a finite number"};
constexpr NumberRule kNoLessThanZero{[](double v) { return v >= 0.0; }, "must not be negative"};

void addEnd(TomlLines& lines, const UmbmarkEnd& end) {
    lines.beginTable("[[told.ends]]");
    lines.add("run", std::to_string(end.run));
    lines.add("x_m", end.way.x);
    lines.add("y_m", end.way.y);
    if (end.said) lines.addText("direction", nameOf(*end.said));
}

std::optional<Turning> readDirection(TomlKeys& keys) {
    const std::string name = keys.text("direction", "");
    if (name.empty()) return std::nullopt;
    for (const Turning turning : {Turning::kClockwise, Turning::kCounterClockwise}) {
        if (name == nameOf(turning)) return turning;
    }
    keys.refuse("direction", "must be clockwise or counter-clockwise");
    return std::nullopt;
}

UmbmarkEnd readEnd(TomlKeys keys) {
    const std::int64_t run = keys.neededInteger("run");
    if (run < 1) keys.refuse("run", "must be a whole number from 1 on");
    UmbmarkEnd end{static_cast<std::size_t>(std::max<std::int64_t>(run, 1)),
                   {keys.neededNumber("x_m", kFinite), keys.neededNumber("y_m", kFinite)},
                   readDirection(keys)};
    keys.refuseOthers();
    return end;
}

}  // namespace

void addTold(TomlLines& lines, const ProcedureSettings& told) {
    if (told == ProcedureSettings{}) return;
    lines.beginTable("[told]");
    if (told.turns) lines.add("turns", *told.turns);
    if (told.closed) lines.addBool("closed", true);
    if (told.distance_m) lines.add("distance_m", *told.distance_m);
    if (told.on_before_s != 0.0) lines.add("on_before_s", told.on_before_s);
    if (told.room_changes) lines.addBool("room_changes", true);
    for (const UmbmarkEnd& end : told.ends) addEnd(lines, end);
}

ProcedureSettings readTold(TomlKeys keys) {
    ProcedureSettings told;
    if (keys.has("turns")) told.turns = keys.neededNumber("turns", kFinite);
    told.closed = keys.flag("closed", false);
    if (keys.has("distance_m")) told.distance_m = keys.neededNumber("distance_m", kFinite);
    told.on_before_s = keys.number("on_before_s", 0.0, kNoLessThanZero);
    told.room_changes = keys.flag("room_changes", false);
    for (TomlKeys& each : keys.tables("ends")) told.ends.push_back(readEnd(each));
    keys.refuseOthers();
    return told;
}

}  // namespace hedr
