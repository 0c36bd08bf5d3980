#pragma once

#include <QString>

#include "core/result.h"

namespace hedr {

// What happened, where, and what to do, in one sentence or two short ones. Needs QtCore only, so
// the command line says the same words as the window.
QString errorText(const Error& error);
// The line for a terminal that such a text has after a colon; empty where there is none.
QString lineToCopy(const QString& text);

}  // namespace hedr
