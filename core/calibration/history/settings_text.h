#pragma once

#include "core/calibration/procedure_input.h"
#include "core/text/toml_keys.h"
#include "core/text/toml_lines.h"

namespace hedr {

// What the operator said, as the table "told" of a record; nothing where he said nothing.
void addTold(TomlLines& lines, const ProcedureSettings& told);
// Errors go to the keys.
ProcedureSettings readTold(TomlKeys keys);

}  // namespace hedr
