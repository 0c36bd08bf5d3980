#include "ui/site/plan_glance.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <algorithm>

#include "core/site/plan.h"
#include "ui/error_text.h"
#include "ui/map/plan_layer.h"

namespace hedr {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("PlanGlance", text); }

QImage imageOf(const PlanLevel& level) {
    const bool grey = level.channels == 1;
    return {level.pixels->data(), level.width_px, level.height_px, level.width_px * level.channels,
            grey ? QImage::Format_Grayscale8 : QImage::Format_ARGB32};
}

QImage pictureOf(const PlanImage& plan, int side_px) {
    const auto coarse = std::ranges::find_if(plan.levels, [&](const PlanLevel& level) {
        return std::max(level.width_px, level.height_px) < 2 * side_px;
    });
    const PlanLevel& level = coarse == plan.levels.end() ? plan.levels.back() : *coarse;
    const QSize size = QSize(level.width_px, level.height_px);
    return imageOf(level)
        .scaled(size.scaled(side_px, side_px, Qt::KeepAspectRatio).boundedTo(size),
                Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
        .copy();
}

// Its name stands above; where it is is seen as well.
PlanGlance unreadable(Error error) {
    error.subject = QFileInfo(QString::fromStdString(error.subject)).fileName().toStdString();
    return {{}, errorText(error), error.code};
}

}  // namespace

PlanGlance glanceAt(const PlanFileWish& wish, int side_px) {
    const auto plan = loadPlan(wish.file.toStdString());
    if (!plan) return unreadable(plan.error());
    const PlanLevel& full = plan->levels.front();
    return {pictureOf(*plan, side_px), tr("%1 × %2 px, %3, %4 m per pixel")
                                           .arg(full.width_px)
                                           .arg(full.height_px)
                                           .arg(QFileInfo(wish.file).suffix().toUpper())
                                           .arg(plan->placement.resolution_m, 0, 'g', 3)};
}

std::vector<QString> pagesToChooseFrom(const QString&) { return {}; }

QImage themedPicture(const QImage& picture, const Theme& theme) {
    QImage themed = picture.convertToFormat(QImage::Format_RGB32);
    for (int y = 0; y < themed.height(); ++y) {
        auto* row = reinterpret_cast<QRgb*>(themed.scanLine(y));
        std::transform(row, row + themed.width(), row,
                       [&](QRgb colour) { return themedColour(colour, theme); });
    }
    return themed;
}

}  // namespace hedr
