#pragma once

#include <QString>

#include "core/calibration/calibration.h"
#include "ui/panels/status_tiles.h"

namespace hedr {

// A verdict in words.
struct VerdictText {
    QString word{};      // "Better, 12.8 times"
    QString interval{};  // "95 %: 9 to 17 times"; empty where there is no proof
    QString reason{};
    Tone tone = Tone::kDim;
    friend bool operator==(const VerdictText&, const VerdictText&) = default;
};
VerdictText verdictText(const Calibration& calibration);

// "accepted", of a calibration that was done
QString verdictWord(Verdict verdict);
QString declinedWord();  // it was better, and was not taken over
Tone verdictTone(Verdict verdict);

}  // namespace hedr
