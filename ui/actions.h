#pragma once

#include <QKeySequence>
#include <QString>
#include <vector>

namespace hedr {

enum class ActionId {
    kConnect,
    kLink,
    kRobot,
    kAddRobot,
    kNextRobot,
    kPublish,
    kCalibrate,
    kFollow,
    kFit,
    kPlan,
    kOpenSite,
    kSaveSite,
    kAlign,
    kLayers,
    kFloorUp,
    kFloorDown,
    kRobotHere,
    kStraighten,
    kWalls,
    kCorridors,
    kTie,
    kUndo,
    kRedo,
    kCancel,
    kTheme,
    kZoomIn,
    kZoomOut,
    kNextTrail,
    kLeft,
    kRight,
    kUp,
    kDown,
    kQuit,
};

// Everything that an operator can do, in one table: rail, keys, tool tips and tests read it.
struct ActionEntry {
    ActionId id;
    QString text;
    QString tip;
    QString icon;  // of assets/icons
    QKeySequence key;
    bool on_rail = false;
    bool on_map_only = false;  // its key works while the map has the focus
};

std::vector<ActionEntry> actionTable();

}  // namespace hedr
