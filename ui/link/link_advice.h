#pragma once

#include <QString>

#include "ui/clock.h"
#include "ui/live_model.h"

namespace hedr {

// What is wrong with the link in one or two sentences, empty where nothing is.
QString linkAdvice(const LiveModel& model, const Clock& clock);

}  // namespace hedr
