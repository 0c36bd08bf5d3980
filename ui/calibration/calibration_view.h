#pragma once

#include <QString>
#include <QStringList>
#include <vector>

#include "core/calibration/calibration.h"

namespace hedr {

// A button of the page as it is now. Without a text it is not there.
struct PageButton {
    QString text{};
    bool enabled = true;
    QString tip{};
};

inline constexpr QStringView kSwitchedOn = u"1";

// What the operator may say besides the samples.
struct PageEntry {
    QString label;           // "Whole turns, each time"
    QString text{};          // as it was typed
    QString empty_means{};   // "counted"
    QStringList known{};     // what was said before, to be completed
    bool is_switch = false;  // a box to be ticked: then its text is kSwitchedOn
};

// Everything that the page of a calibration shows.
struct CalibrationView {
    QString title;      // "Wheel parameters · squares (UMBmark)"
    QString context{};  // "PackBot 3 · concrete floor · step 2 of 3"
    Calibration calibration{};
    std::vector<PageEntry> entries{};
    QString progress_title{};       // "Counter-clockwise run 4 of 5"; empty: the step that is next
    PageButton leave{};             // "Cancel"
    PageButton primary{};           // the one thing to do now
    PageButton also{};              // the same and one thing more: "Accept, and write to the robot"
    PageButton secondary{};         // "Save as draft"
    PageButton procedure_action{};  // of this procedure alone: "Click on the map"
};

}  // namespace hedr
