#include "ui/site/plan_glance.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QPageSize>
#include <algorithm>
#include <cmath>

#include "core/site/plan.h"
#include "core/site/site_file.h"
#include "ui/error_text.h"
#include "ui/map/plan_layer.h"

namespace hedr {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("PlanGlance", text); }

// With pixels of its own.
QImage imageOf(const PlanLevel& level) {
    const bool grey = level.channels == 1;
    const QImage shared(level.pixels->data(), level.width_px, level.height_px,
                        qsizetype{level.width_px} * level.channels,
                        grey ? QImage::Format_Grayscale8 : QImage::Format_ARGB32);
    return shared.copy();
}

// A page of a file that may have many: coarse, whatever its paper.
Result<PlanLevel> pagePicture(const PlanFileWish& wish) {
    constexpr double kPicture_dpi = 30.0;  // 350 px for A4
    PlanChoice coarse = wish.choice;
    coarse.dpi = kPicture_dpi;
    return loadPlan(wish.file.toStdString(), {}, {}, coarse).and_then([](const PlanImage& plan) {
        return readWhole(plan.levels.front());
    });
}

QImage fitted(const QImage& image, int side_px) {
    const QSize size = image.size().scaled(side_px, side_px, Qt::KeepAspectRatio);
    return image.scaled(size.boundedTo(image.size()), Qt::IgnoreAspectRatio,
                        Qt::SmoothTransformation);
}

QString paperOf(const PlanPage& page) {
    const QSizeF size(page.paper_width_mm, page.paper_height_mm);
    constexpr int kSlack_mm = 3;
    for (const auto id : {QPageSize::A0, QPageSize::A1, QPageSize::A2, QPageSize::A3, QPageSize::A4,
                          QPageSize::A5}) {
        const QSizeF paper = QPageSize::size(id, QPageSize::Millimeter);
        for (const QSizeF& turned : {paper, paper.transposed()}) {
            const QSizeF off = size - turned;
            if (std::abs(off.width()) < kSlack_mm && std::abs(off.height()) < kSlack_mm) {
                return QPageSize::name(id);
            }
        }
    }
    return tr("%1 × %2 mm").arg(qRound(size.width())).arg(qRound(size.height()));
}

// What is known of its size without loading it.
QString sizeInWords(const PlanDescription& plan) {
    const PlanPage& page = plan.pages.front();
    const QString format = QString::fromStdString(plan.format);
    if (plan.pages.size() > 1) {
        return tr("%1, %2 pages").arg(format).arg(plan.pages.size());
    }
    if (page.paper_width_mm > 0.0) return tr("%1, %2").arg(format, paperOf(page));
    QString pixels = tr("%1 × %2 px, %3").arg(page.width_px).arg(page.height_px).arg(format);
    if (!plan.resolution_m) return pixels;
    return tr("%1, %2 m per pixel").arg(pixels).arg(*plan.resolution_m, 0, 'g', 3);
}

// Its name stands above; where it is is seen as well.
PlanGlance unreadable(Error error) {
    error.subject = QFileInfo(QString::fromStdString(error.subject)).fileName().toStdString();
    return {{}, errorText(error), error.code};
}

// With the picture of its first image.
PlanGlance glanceAtSite(const std::string& file, int side_px) {
    const auto site = readSite(file);
    if (!site) return unreadable(site.error());
    std::vector<SitePlan> plans;
    for (const SiteFloor& floor : site->floors) {
        plans.insert(plans.end(), floor.plans.begin(), floor.plans.end());
    }
    const QString words =
        tr("Site, floors: %1, images: %2").arg(site->floors.size()).arg(plans.size());
    if (plans.empty()) return {{}, words, std::nullopt};
    const auto picture = planThumbnail(plans.front().image_file, side_px);
    return {picture ? fitted(imageOf(*picture), side_px) : QImage(), words, std::nullopt};
}

}  // namespace

PlanGlance glanceAt(const PlanFileWish& wish, int side_px) {
    const std::string file = wish.file.toStdString();
    if (file.ends_with(kSiteFileExtension)) return glanceAtSite(file, side_px);
    const auto plan = describePlan(file);
    if (!plan) return unreadable(plan.error());
    const auto picture = wish.choice.page > 1 ? pagePicture(wish) : planThumbnail(file, side_px);
    if (!picture) return unreadable(picture.error());
    return {fitted(imageOf(*picture), side_px), sizeInWords(*plan), std::nullopt};
}

std::vector<QString> pagesToChooseFrom(const QString& file) {
    const auto plan = describePlan(file.toStdString());
    if (!plan || plan->pages.front().paper_width_mm <= 0.0) return {};
    std::vector<QString> pages;
    for (const PlanPage& page : plan->pages) pages.push_back(paperOf(page));
    return pages;
}

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
