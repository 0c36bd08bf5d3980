#include "ui/calibration/procedure_entries.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace hedr {

namespace {

// Without `empty_means` it is a switch, whose value counts only as set.
struct EntryRow {
    ProcedureSetting setting;
    const char* label;
    const char* empty_means;
    void (*set)(ProcedureSettings& settings, double value);
};

constexpr std::array kEntryRows{
    EntryRow{ProcedureSetting::kTurns, QT_TRANSLATE_NOOP("ProcedureEntries", "Turns each time"),
             QT_TRANSLATE_NOOP("ProcedureEntries", "counted"),
             [](ProcedureSettings& settings, double value) { settings.turns = value; }},
    EntryRow{ProcedureSetting::kPushed, QT_TRANSLATE_NOOP("ProcedureEntries", "Pushed by, m"), "1",
             [](ProcedureSettings& settings, double value) { settings.distance_m = value; }},
    EntryRow{
        ProcedureSetting::kOnBefore, QT_TRANSLATE_NOOP("ProcedureEntries", "On before that, min"),
        "0",
        [](ProcedureSettings& settings, double value) { settings.on_before_s = 60.0 * value; }},
    EntryRow{ProcedureSetting::kRoomChanges,
             QT_TRANSLATE_NOOP("ProcedureEntries", "The room may warm or cool meanwhile"), nullptr,
             [](ProcedureSettings& settings, double) { settings.room_changes = true; }},
    EntryRow{ProcedureSetting::kSpun, QT_TRANSLATE_NOOP("ProcedureEntries", "Spun by, turns"), "1",
             [](ProcedureSettings& settings, double value) { settings.turns = value; }},
    EntryRow{ProcedureSetting::kStraightRuns,
             QT_TRANSLATE_NOOP("ProcedureEntries", "Straight runs of, m"),
             QT_TRANSLATE_NOOP("ProcedureEntries", "any drive"),
             [](ProcedureSettings& settings, double value) { settings.distance_m = value; }},
};

bool takes(const Procedure& procedure, ProcedureSetting setting) {
    return std::ranges::find(procedure.settings, setting) != procedure.settings.end();
}

// Those of the procedure; not every setting is for the page.
std::vector<EntryRow> rowsOf(const Procedure& procedure) {
    std::vector<EntryRow> rows;
    for (const EntryRow& row : kEntryRows) {
        if (takes(procedure, row.setting)) rows.push_back(row);
    }
    return rows;
}

QString entryWords(const char* text) {
    return QCoreApplication::translate("ProcedureEntries", text);
}

std::optional<double> numberIn(QString text) {
    bool ok = false;
    const double value = text.replace(',', '.').toDouble(&ok);
    return ok && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<double> positiveNumber(const QString& text) {
    const auto value = numberIn(text);
    return value && *value > 0.0 ? value : std::nullopt;
}

qsizetype floorFields(const Procedure& procedure) { return procedure.depends_on_floor ? 1 : 0; }

// Of run 1.
qsizetype firstEndField(const Procedure& procedure) {
    return floorFields(procedure) + static_cast<qsizetype>(rowsOf(procedure).size());
}

QString typedAt(const QStringList& typed, qsizetype field) { return typed.value(field).trimmed(); }

PageEntry floorEntry(const QString& text, const QStringList& surfaces) {
    return {QCoreApplication::translate("ProcedureEntries", "Floor"), text,
            QCoreApplication::translate("ProcedureEntries", "carpet, tiles …"), surfaces};
}

PageEntry rowEntry(const EntryRow& row, const QString& text) {
    const QString label = entryWords(row.label);
    if (!row.empty_means) return {.label = label, .text = text, .is_switch = true};
    if (text.isEmpty() || positiveNumber(text)) return {label, text, entryWords(row.empty_means)};
    return {
        QCoreApplication::translate("ProcedureEntries", "%1: a number above 0, please").arg(label),
        text,
        {}};
}

// Two numbers between blanks or a semicolon, "0.12 -0.03".
std::optional<Vector<Robot>> placeTyped(const QString& text) {
    static const QRegularExpression kBetween(QStringLiteral("[\\s;]+"));
    const QStringList numbers = text.split(kBetween, Qt::SkipEmptyParts);
    if (numbers.size() != 2) return std::nullopt;
    const auto x_m = numberIn(numbers[0]);
    const auto y_m = numberIn(numbers[1]);
    if (!x_m || !y_m) return std::nullopt;
    return Vector<Robot>{*x_m, *y_m};
}

// As one would type it; empty: that run has none.
QString endText(const std::vector<UmbmarkEnd>& ends, std::size_t run) {
    constexpr int kDecimals = 3;  // a millimetre
    const auto end = std::ranges::find(ends, run, &UmbmarkEnd::run);
    if (end == ends.end()) return {};
    return QStringLiteral("%1 %2")
        .arg(end->way.x, 0, 'f', kDecimals)
        .arg(end->way.y, 0, 'f', kDecimals);
}

PageEntry endEntry(qsizetype run, const QString& text) {
    const QString label =
        QCoreApplication::translate("ProcedureEntries", "Run %1 ended at x y, m").arg(run);
    if (text.isEmpty() || placeTyped(text)) return {label, text, QStringLiteral("0.12 -0.03")};
    return {QCoreApplication::translate("ProcedureEntries", "%1: two numbers, please").arg(label),
            text,
            {}};
}

}  // namespace

QStringList firstTyped(const Procedure& procedure, const QString& last_surface) {
    return procedure.depends_on_floor ? QStringList{last_surface} : QStringList{};
}

std::vector<PageEntry> procedureEntries(const Procedure& procedure, const QStringList& typed,
                                        const QStringList& surfaces) {
    std::vector<PageEntry> entries;
    qsizetype field = floorFields(procedure);
    if (field > 0) entries.push_back(floorEntry(surfaceTyped(procedure, typed), surfaces));
    for (const EntryRow& row : rowsOf(procedure))
        entries.push_back(rowEntry(row, typedAt(typed, field++)));
    if (!asksForEnds(procedure)) return entries;
    const auto runs = static_cast<qsizetype>(runsTyped(procedure, typed));
    for (qsizetype run = 1; run <= runs + 1; ++run)
        entries.push_back(endEntry(run, typedAt(typed, field + run - 1)));
    return entries;
}

ProcedureSettings settingsTyped(const Procedure& procedure, const QStringList& typed) {
    ProcedureSettings settings;
    qsizetype field = floorFields(procedure);
    for (const EntryRow& row : rowsOf(procedure)) {
        if (const auto value = positiveNumber(typedAt(typed, field++))) row.set(settings, *value);
    }
    if (!asksForEnds(procedure)) return settings;
    std::size_t run = 1;
    for (; field < typed.size(); ++field, ++run) {
        if (const auto way = placeTyped(typed[field])) settings.ends.push_back({run, *way});
    }
    return settings;
}

QString surfaceTyped(const Procedure& procedure, const QStringList& typed) {
    return procedure.depends_on_floor ? typedAt(typed, 0) : QString();
}

bool asksForEnds(const Procedure& procedure) { return takes(procedure, ProcedureSetting::kEnds); }

bool takesClosedDrives(const Procedure& procedure) {
    return takes(procedure, ProcedureSetting::kClosedDrives);
}

std::size_t runsTyped(const Procedure& procedure, const QStringList& typed) {
    qsizetype runs = typed.size() - firstEndField(procedure);
    while (runs > 0 && typedAt(typed, firstEndField(procedure) + runs - 1).isEmpty()) --runs;
    return static_cast<std::size_t>(std::max<qsizetype>(runs, 0));
}

QStringList withoutEnds(const Procedure& procedure, const QStringList& typed) {
    return typed.mid(0, firstEndField(procedure));
}

QStringList withEnds(const Procedure& procedure, QStringList typed,
                     const std::vector<UmbmarkEnd>& before, const std::vector<UmbmarkEnd>& ends) {
    std::size_t last_run = 0;
    for (const auto& each : {before, ends}) {
        if (!each.empty()) last_run = std::max(last_run, each.back().run);
    }
    for (std::size_t run = 1; run <= last_run; ++run) {
        if (endText(before, run) == endText(ends, run)) continue;
        const qsizetype field = firstEndField(procedure) + static_cast<qsizetype>(run) - 1;
        while (typed.size() <= field) typed << QString();
        typed[field] = endText(ends, run);
    }
    return typed;
}

}  // namespace hedr
