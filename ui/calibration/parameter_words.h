#pragma once

#include <QString>
#include <string_view>

#include "core/calibration/calibration.h"
#include "ui/calibration/evidence_units.h"

namespace hedr {

// What a key of the vehicle file is called and in which unit it is read. A key that is not in the
// table keeps its own name, without a unit.
struct ParameterWords {
    QString name;  // "Left wheel"
    ReadUnit unit;
};
ParameterWords parameterWords(std::string_view key);

// A found parameter in words. As many decimals as show two digits of its margin at 95 %.
struct FoundText {
    QString name{};
    QString value{};   // "0.5530 m"; "–" where nothing is known yet
    QString margin{};  // "± 0.0021", "+0.86 −0.64", "not measured yet", "goes with the others"
    QString was{};     // "was 0.4100 m", "was not set"
    friend bool operator==(const FoundText&, const FoundText&) = default;
};
FoundText foundText(const FoundParameter& found);

}  // namespace hedr
