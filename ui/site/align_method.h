#pragma once

#include <QString>
#include <vector>

namespace hedr {

// How an operator says where a plan lies.
enum class AlignMethod { kPoints, kDistance, kMove, kTurn, kTrail };

struct AlignMethodEntry {
    AlignMethod method;
    QString name;
    QString hint;  // what to do, above the map
};

// In the order of the card's row.
std::vector<AlignMethodEntry> alignMethods();

}  // namespace hedr
