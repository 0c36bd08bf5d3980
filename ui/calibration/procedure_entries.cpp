#include "ui/calibration/procedure_entries.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace hedr {

namespace {

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

QString typedAt(const QStringList& typed, std::size_t index) {
    return typed.value(static_cast<qsizetype>(index)).trimmed();
}

PageEntry numberEntry(const EntryRow& row, const QString& text) {
    const QString label = entryWords(row.label);
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

PageEntry endEntry(qsizetype run, const QString& text) {
    const QString label =
        QCoreApplication::translate("ProcedureEntries", "Run %1 ended at x y, m").arg(run);
    if (text.isEmpty() || placeTyped(text)) return {label, text, QStringLiteral("0.12 -0.03")};
    return {QCoreApplication::translate("ProcedureEntries", "%1: two numbers, please").arg(label),
            text,
            {}};
}

}  // namespace

std::vector<PageEntry> procedureEntries(const Procedure& procedure, const QStringList& typed) {
    std::vector<PageEntry> entries;
    for (const EntryRow& row : rowsOf(procedure))
        entries.push_back(numberEntry(row, typedAt(typed, entries.size())));
    if (!takes(procedure, ProcedureSetting::kEnds)) return entries;
    const auto first = static_cast<qsizetype>(entries.size());
    qsizetype runs = typed.size() - first;
    while (runs > 0 && typed[first + runs - 1].trimmed().isEmpty()) --runs;
    for (qsizetype run = 1; run <= runs + 1; ++run)
        entries.push_back(endEntry(run, typed.value(first + run - 1).trimmed()));
    return entries;
}

ProcedureSettings settingsTyped(const Procedure& procedure, const QStringList& typed) {
    ProcedureSettings settings;
    const std::vector<EntryRow> rows = rowsOf(procedure);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (const auto value = positiveNumber(typedAt(typed, i))) rows[i].set(settings, *value);
    }
    if (!takes(procedure, ProcedureSetting::kEnds)) return settings;
    for (auto i = static_cast<qsizetype>(rows.size()); i < typed.size(); ++i) {
        const auto run = static_cast<std::size_t>(i) - rows.size() + 1;
        if (const auto way = placeTyped(typed[i])) settings.ends.push_back({run, *way});
    }
    return settings;
}

}  // namespace hedr
