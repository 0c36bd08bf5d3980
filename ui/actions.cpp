#include "ui/actions.h"

#include <QCoreApplication>

namespace hedr {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("Actions", text); }

}  // namespace

std::vector<ActionEntry> actionTable() {
    using Id = ActionId;
    return {
        {Id::kFollow, tr("Follow"), tr("Keep the robot in sight"), "follow", Qt::Key_R, true},
        {Id::kFit, tr("Fit"), tr("Show the whole plan and trail"), "fit", Qt::Key_F, true},
        {Id::kPlan, tr("Plan"), tr("Open a floor plan"), "plan", Qt::Key_P, true},
        {Id::kOpenSite, tr("Open site"), tr("Open a site that was saved"), "folder",
         QKeySequence::Open},
        {Id::kSaveSite, tr("Save site"), tr("Save the site in a file of your own"), "save",
         QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S)},
        {Id::kAlign, tr("Align"), tr("Say where the plan lies"), "align", Qt::Key_A, true},
        {Id::kLayers, tr("Layers"), tr("Floors and images"), "layers", Qt::Key_L, true},
        {Id::kFloorUp, tr("Floor up"), tr("Look at the floor above"), "up", Qt::Key_PageUp},
        {Id::kFloorDown, tr("Floor down"), tr("Look at the floor below"), "down", Qt::Key_PageDown},
        {Id::kRobotHere, tr("Robot is here"), tr("The robot has come to the floor on the map"),
         "robot-here", Qt::Key_Return, false, true},
        {Id::kStraighten, tr("Straighten"), tr("Make the photo of a plan flat"), "straighten",
         Qt::Key_S},
        {Id::kWalls, tr("Walls"), tr("See and draw walls and free space"), "walls", Qt::Key_W},
        {Id::kCorridors, tr("Corridors"), tr("Tell HEDR where the corridors run"), "corridors",
         Qt::Key_H},
        {Id::kTie, tr("Globe"), tr("Tie the map to latitude and longitude"), "globe", Qt::Key_G},
        {Id::kTheme, tr("Night"), tr("Dark or light colours"), "night", Qt::Key_N, true},
        {Id::kConnect, tr("Connect"), tr("Connect to a robot, or disconnect"), "link", Qt::Key_C},
        {Id::kLink, tr("Link"), tr("See how good the link is, now and before"), "link", Qt::Key_I},
        {Id::kRobot, tr("Robot"), tr("Read and write its parameters, and give it commands"),
         "robot-here", Qt::Key_B},
        {Id::kCalibrate, tr("Calibrate"), tr("Measure the robot's gyro, wheels and compass"),
         "calibrate", Qt::Key_K},
        {Id::kAddRobot, tr("Another robot"), tr("Connect to one more robot"), "link",
         QKeySequence(Qt::SHIFT | Qt::Key_C)},
        {Id::kNextRobot, tr("Next robot"), tr("Turn to the next robot"), "robot-here", Qt::Key_V},
        {Id::kPublish, tr("Publish"), tr("Tell other programs where the robots are"), "globe",
         Qt::Key_O},
        {Id::kZoomIn, tr("Zoom in"), tr("Look closer"), "zoom-in", Qt::Key_Plus},
        {Id::kZoomOut, tr("Zoom out"), tr("See more"), "zoom-out", Qt::Key_Minus},
        {Id::kNextTrail, tr("Next trail"), tr("Show the robot where the next trail says"), "trail",
         Qt::Key_T},
        {Id::kLeft, tr("Left"), tr("Look further left"), "left", Qt::Key_Left, false, true},
        {Id::kRight, tr("Right"), tr("Look further right"), "right", Qt::Key_Right, false, true},
        {Id::kUp, tr("Up"), tr("Look further up"), "up", Qt::Key_Up, false, true},
        {Id::kDown, tr("Down"), tr("Look further down"), "down", Qt::Key_Down, false, true},
        {Id::kUndo, tr("Undo"), tr("Take back the last change of the plans"), "undo",
         QKeySequence::Undo},
        {Id::kRedo, tr("Redo"), tr("Make it again"), "redo", QKeySequence::Redo},
        {Id::kCancel, tr("Cancel"), tr("Leave the plans as they were"), "close", Qt::Key_Escape,
         false, true},
        {Id::kQuit, tr("Quit"), tr("Close the program"), "quit",
         QKeySequence(Qt::CTRL | Qt::Key_Q)},
    };
}

}  // namespace hedr
