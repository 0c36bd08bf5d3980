#pragma once

#include <QImage>
#include <QString>
#include <optional>
#include <vector>

#include "core/result.h"
#include "ui/plan_file_wish.h"
#include "ui/theme.h"

namespace hedr {

// What is seen of a plan's file before it is loaded.
struct PlanGlance {
    QImage picture{};  // null: there is none
    QString words{};   // "2016 × 1134 px, JPEG, scale not known", or why it cannot be read
    std::optional<ErrorCode> error{};
};

// A small picture of a file's page, or of the first image of a site, at most `side_px` wide and
// high. Takes as long as reading the file may take: for a worker.
PlanGlance glanceAt(const PlanFileWish& wish, int side_px);

// The pages of a file to choose from, "A3" or "420 × 297 mm" each; none where there is nothing to
// choose, also of a file that cannot be read: loading it tells why. For a worker.
std::vector<QString> pagesToChooseFrom(const QString& file);

// A picture as the map would show it.
QImage themedPicture(const QImage& picture, const Theme& theme);

}  // namespace hedr
