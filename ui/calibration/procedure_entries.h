#pragma once

#include <QStringList>
#include <vector>

#include "core/calibration/procedures.h"
#include "ui/calibration/calibration_view.h"

namespace hedr {

// What was typed on the page of a procedure is a text for each of its fields, in their order; the
// floor, where it matters, is the first.

// Before anything was typed: on the floor of last time.
QStringList firstTyped(const Procedure& procedure, const QString& last_surface);

// The fields, with what was typed so far and the floors that are known; one that is no number is
// said to be none.
std::vector<PageEntry> procedureEntries(const Procedure& procedure, const QStringList& typed,
                                        const QStringList& surfaces = {});

// What was typed as the procedure takes it; what is no number counts as not typed.
ProcedureSettings settingsTyped(const Procedure& procedure, const QStringList& typed);
QString surfaceTyped(const Procedure& procedure, const QStringList& typed);  // may be empty

bool asksForEnds(const Procedure& procedure);
bool takesClosedDrives(const Procedure& procedure);
std::size_t runsTyped(const Procedure& procedure, const QStringList& typed);  // up to the last one
QStringList withoutEnds(const Procedure& procedure, const QStringList& typed);
// With the ends that are others than they were `before` in the fields of their runs: what was typed
// into the others stays.
QStringList withEnds(const Procedure& procedure, QStringList typed,
                     const std::vector<UmbmarkEnd>& before, const std::vector<UmbmarkEnd>& ends);

}  // namespace hedr
