#include "ui/site/align_method.h"

#include <QCoreApplication>

namespace hedr {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("AlignMethod", text); }

}  // namespace

std::vector<AlignMethodEntry> alignMethods() {
    using Method = AlignMethod;
    return {
        {Method::kPoints, tr("Points"),
         tr("Click a point on the plan, then where it is on the map. Two points are enough; more "
            "show how well it fits.")},
        {Method::kDistance, tr("Distance"),
         tr("Click both ends of a distance that you know, then type how long it is.")},
        {Method::kMove, tr("Move"),
         tr("Drag the plan, or use the arrow keys. Its corners scale it, the handle above it turns "
            "it.")},
        {Method::kTurn, tr("Turn"),
         tr("Choose the picture in which the plan lies the right way round.")},
        {Method::kTrail, tr("Trail"),
         tr("Choose the picture in which the robot has driven through the corridors.")},
    };
}

}  // namespace hedr
