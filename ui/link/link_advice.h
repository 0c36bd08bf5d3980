#pragma once

#include <QString>

#include "ui/clock.h"
#include "ui/link_state.h"

namespace hedr {

// What is wrong with the link in one or two sentences, empty where nothing is.
QString linkAdvice(const LiveBatch& last, const LinkVerdict& link, const Clock& clock);

}  // namespace hedr
