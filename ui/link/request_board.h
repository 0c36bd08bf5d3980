#pragma once

#include <QString>
#include <cstdint>
#include <map>
#include <optional>
#include <span>

#include "radio/link/requests.h"
#include "radio/wire/parameters.h"
#include "ui/panels/status_tiles.h"

namespace hedr {

// What came of the requests to the robot so far: the latest about each parameter and command.
class RequestBoard {
  public:
    void apply(std::span<const RequestProgress> news);
    void clear() { *this = {}; }

    const RequestProgress* ofParameter(RobotParameter id) const;  // nullptr: never asked
    const RequestProgress* ofCommand(CommandKind kind) const;
    const RequestProgress* latestCommand() const;
    // As the robot said last.
    std::optional<std::int32_t> value(RobotParameter id) const;
    bool busy() const;
    std::vector<std::uint64_t> openTickets() const;

  private:
    std::map<std::uint8_t, RequestProgress> parameters_;
    std::map<std::uint8_t, std::int32_t> values_;
    std::map<CommandKind, RequestProgress> commands_;
    std::optional<CommandKind> latest_command_{};
};

QString parameterName(RobotParameter id);
QString parameterUnit(RobotParameter id);  // of the numbers below; may be empty
// Numbers as an operator reads and types them: millimetres, degrees.
QString parameterText(const ParameterMeaning& meaning, std::int32_t raw);
std::optional<std::int32_t> parameterFromText(const ParameterMeaning& meaning, const QString& text);

QString commandName(CommandKind kind);

// How far a request is in a few words, empty for one that is done; and how that is to be shown.
QString progressText(const RequestProgress& progress);
Tone progressTone(const RequestProgress& progress);

}  // namespace hedr
