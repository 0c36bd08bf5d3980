#include "ui/link/request_board.h"

#include <QCoreApplication>
#include <cmath>

#include "core/geometry/angle.h"

namespace hedr {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("RequestBoard", text); }

// What one SI unit is in the unit that is shown, and how many digits say something.
struct Shown {
    double per_si;
    int decimals;
};

Shown shownIn(const ParameterMeaning& meaning) {
    switch (meaning.dimension) {
        case Dimension::kLength:
            return {1e3, 3};
        case Dimension::kAngle:
            return {degFromRad(1.0), 3};
        case Dimension::kAngularAcceleration:
            return {degFromRad(1.0), 5};
        case Dimension::kNumber:
            break;
    }
    return {1.0, meaning.unit < 1.0 ? 3 : 0};
}

QString refusalText(AcknowledgeResult reason) {
    switch (reason) {
        case AcknowledgeResult::kUnknownCommand:
            return tr("this robot does not know the command");
        case AcknowledgeResult::kUnknownParameter:
            return tr("this robot does not have it");
        case AcknowledgeResult::kOutOfRange:
            return tr("refused: out of its range");
        case AcknowledgeResult::kNotWhileMoving:
            return tr("refused while the robot moves");
        case AcknowledgeResult::kNotSupported:
        case AcknowledgeResult::kDone:
            break;
    }
    return tr("refused by the robot");
}

}  // namespace

void RequestBoard::apply(std::span<const RequestProgress> news) {
    for (const RequestProgress& progress : news) {
        if (const auto* command = std::get_if<RobotCommand>(&progress.wish)) {
            commands_.insert_or_assign(command->kind, progress);
            latest_command_ = command->kind;
            continue;
        }
        const auto* get = std::get_if<ParameterGet>(&progress.wish);
        const auto* set = std::get_if<ParameterSet>(&progress.wish);
        if (!get && !set) continue;
        const std::uint8_t id = get ? get->id : set->id;
        parameters_.insert_or_assign(id, progress);
        if (progress.value) values_.insert_or_assign(id, *progress.value);
    }
}

const RequestProgress* RequestBoard::ofParameter(RobotParameter id) const {
    const auto found = parameters_.find(static_cast<std::uint8_t>(id));
    return found == parameters_.end() ? nullptr : &found->second;
}

const RequestProgress* RequestBoard::ofCommand(CommandKind kind) const {
    const auto found = commands_.find(kind);
    return found == commands_.end() ? nullptr : &found->second;
}

const RequestProgress* RequestBoard::latestCommand() const {
    return latest_command_ ? ofCommand(*latest_command_) : nullptr;
}

std::optional<std::int32_t> RequestBoard::value(RobotParameter id) const {
    const auto found = values_.find(static_cast<std::uint8_t>(id));
    return found == values_.end() ? std::nullopt : std::optional(found->second);
}

bool RequestBoard::busy() const { return !openTickets().empty(); }

std::vector<std::uint64_t> RequestBoard::openTickets() const {
    std::vector<std::uint64_t> tickets;
    const auto gather = [&tickets](const auto& all) {
        for (const auto& [subject, progress] : all) {
            if (!isOver(progress.state)) tickets.push_back(progress.ticket);
        }
    };
    gather(parameters_);
    gather(commands_);
    return tickets;
}

QString parameterName(RobotParameter id) {
    switch (id) {
        case RobotParameter::kLeftWheelDiameterUm:
            return tr("Left wheel diameter");
        case RobotParameter::kRightWheelDiameterUm:
            return tr("Right wheel diameter");
        case RobotParameter::kWheelbaseUm:
            return tr("Wheelbase");
        case RobotParameter::kTicksPerRevolutionMilli:
            return tr("Ticks per revolution");
        case RobotParameter::kHedrGainUradS2:
            return tr("HEDR gain");
        case RobotParameter::kDominantDirections:
            return tr("Directions");
        case RobotParameter::kDominantOffset:
            return tr("Corridor heading");
    }
    return {};
}

QString parameterUnit(RobotParameter id) {
    for (const ParameterMeaning& meaning : kParameterMeanings) {
        if (meaning.id != id) continue;
        switch (meaning.dimension) {
            case Dimension::kLength:
                return tr("mm");
            case Dimension::kAngle:
                return tr("°");
            case Dimension::kAngularAcceleration:
                return tr("°/s²");
            case Dimension::kNumber:
                break;
        }
    }
    return {};
}

QString parameterText(const ParameterMeaning& meaning, std::int32_t raw) {
    const Shown shown = shownIn(meaning);
    return QString::number(parameterInSi(meaning, raw) * shown.per_si, 'f', shown.decimals);
}

std::optional<std::int32_t> parameterFromText(const ParameterMeaning& meaning,
                                              const QString& text) {
    bool is_number = false;
    const double value = QString(text).trimmed().replace(u',', u'.').toDouble(&is_number);
    if (!is_number || !std::isfinite(value)) return std::nullopt;
    return parameterOnWire(meaning, value / shownIn(meaning).per_si);
}

QString commandName(CommandKind kind) {
    switch (kind) {
        case CommandKind::kMeasureBias:
            return tr("Measure bias");
        case CommandKind::kResetPose:
            return tr("Give it our pose");
        case CommandKind::kHedrOn:
            return tr("HEDR on");
        case CommandKind::kHedrOff:
            return tr("HEDR off");
        case CommandKind::kNone:
            break;
    }
    return {};
}

QString progressText(const RequestProgress& progress) {
    const bool writes = std::holds_alternative<ParameterSet>(progress.wish);
    switch (progress.state) {
        case RequestState::kWaiting:
            return tr("waiting");
        case RequestState::kAsked:
            return progress.tries > 1 ? tr("asked %1 times").arg(progress.tries) : tr("asked");
        case RequestState::kReadingBack:
            return tr("written, reading back");
        case RequestState::kDone:
            return writes ? tr("written and read back") : QString();
        case RequestState::kRefused:
            return refusalText(progress.reason);
        case RequestState::kDiffers:
            return tr("not taken over: the robot kept its value");
        case RequestState::kNoAnswer:
            return tr("no answer, asked %1 times").arg(progress.tries);
        case RequestState::kCanceled:
            return tr("canceled");
    }
    return {};
}

Tone progressTone(const RequestProgress& progress) {
    switch (progress.state) {
        case RequestState::kDone:
            return Tone::kGood;
        case RequestState::kRefused:
        case RequestState::kDiffers:
        case RequestState::kNoAnswer:
            return Tone::kWarning;
        default:
            return Tone::kDim;
    }
}

}  // namespace hedr
