#include "ui/calibration/procedure_entries.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>
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
};

// Those of the procedure; not every setting is for the page.
std::vector<EntryRow> rowsOf(const Procedure& procedure) {
    std::vector<EntryRow> rows;
    for (const EntryRow& row : kEntryRows) {
        const bool counts =
            std::ranges::find(procedure.settings, row.setting) != procedure.settings.end();
        if (counts) rows.push_back(row);
    }
    return rows;
}

QString entryWords(const char* text) {
    return QCoreApplication::translate("ProcedureEntries", text);
}

std::optional<double> positiveNumber(QString text) {
    bool ok = false;
    const double value = text.replace(',', '.').toDouble(&ok);
    return ok && value > 0.0 ? std::optional(value) : std::nullopt;
}

QString typedAt(const QStringList& typed, std::size_t index) {
    return typed.value(static_cast<qsizetype>(index)).trimmed();
}

}  // namespace

std::vector<PageEntry> procedureEntries(const Procedure& procedure, const QStringList& typed) {
    std::vector<PageEntry> entries;
    for (const EntryRow& row : rowsOf(procedure)) {
        const QString text = typedAt(typed, entries.size());
        const bool good = text.isEmpty() || positiveNumber(text);
        const QString label = entryWords(row.label);
        entries.push_back(
            {good ? label
                  : QCoreApplication::translate("ProcedureEntries", "%1: a number above 0, please")
                        .arg(label),
             text, entryWords(row.empty_means)});
    }
    return entries;
}

ProcedureSettings settingsTyped(const Procedure& procedure, const QStringList& typed) {
    ProcedureSettings settings;
    const std::vector<EntryRow> rows = rowsOf(procedure);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (const auto value = positiveNumber(typedAt(typed, i))) rows[i].set(settings, *value);
    }
    return settings;
}

}  // namespace hedr
