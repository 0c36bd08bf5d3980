#pragma once

#include <QString>
#include <vector>

#include "ui/clock.h"
#include "ui/live_model.h"
#include "ui/theme.h"

namespace hedr {

enum class Tone { kPlain, kDim, kGood, kWarning, kAlarm };
enum class Mark { kNone, kRing, kDisc, kTriangle, kCross, kRecording };

QColor colourOf(Tone tone, const Theme& theme);

// What a click on a tile shows more of.
enum class TileKind { kPlain, kLink };

// One tile of the strip: a small label, one large value, one line of detail.
struct StatusTile {
    QString label;
    QString value;
    QString detail;  // parts between " · ", the less needed ones last
    Tone tone = Tone::kPlain;
    Mark mark = Mark::kNone;
    QString widest_value{};  // room for it is kept, so that the strip stays still
    QString note{};          // for the tool tip, below the detail
    TileKind kind = TileKind::kPlain;
    friend bool operator==(const StatusTile&, const StatusTile&) = default;
};

std::vector<StatusTile> statusTiles(const LiveModel& model, ReceiveClock::time_point now);

}  // namespace hedr
