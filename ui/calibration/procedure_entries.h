#pragma once

#include <QStringList>
#include <vector>

#include "core/calibration/procedures.h"
#include "ui/calibration/calibration_view.h"

namespace hedr {

// The fields of a procedure's page, with what was typed so far, in their order; one that is no
// number is said to be none.
std::vector<PageEntry> procedureEntries(const Procedure& procedure, const QStringList& typed);

// What was typed as the procedure takes it; what is no number counts as not typed.
ProcedureSettings settingsTyped(const Procedure& procedure, const QStringList& typed);

}  // namespace hedr
