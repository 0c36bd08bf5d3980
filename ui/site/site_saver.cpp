#include "ui/site/site_saver.h"

#include <QDir>
#include <algorithm>

#include "core/site/site_file.h"
#include "ui/site/site_model.h"

namespace hedr {
namespace {

namespace fs = std::filesystem;

struct KindText {
    PlanCopyKind kind;
    const char* title;
    const char* name;
    const char* suffix;
};

constexpr KindText kKinds[] = {
    {PlanCopyKind::kGeoTiff, QT_TRANSLATE_NOOP("SiteSaver", "Save a copy as a GeoTIFF"), "GeoTIFF",
     ".tif"},
    {PlanCopyKind::kPng, QT_TRANSLATE_NOOP("SiteSaver", "Save a copy with a world file"),
     QT_TRANSLATE_NOOP("SiteSaver", "Image, with its world file beside it"), ".png"},
    {PlanCopyKind::kRosMap, QT_TRANSLATE_NOOP("SiteSaver", "Save a copy as a ROS map"),
     QT_TRANSLATE_NOOP("SiteSaver", "ROS map, with its image beside it"), ".yaml"},
};

QString beside(const fs::path& image, const QString& after_name) {
    return QString::fromStdString((image.parent_path() / image.stem()).string()) + after_name;
}

// The file's own holds as long as the plan lies where its file says.
std::optional<GeoTie> tieOf(const Site& site, const SitePlan& plan, const PlanImage& image) {
    if (site.geo_tie) return site.geo_tie;
    return plan.placement == image.placement ? image.geo_tie : std::nullopt;
}

}  // namespace

SiteSaver::SiteSaver(const SiteModel& site, QWidget* window)
    : QObject(window), site_(site), window_(window) {}

void SiteSaver::askForCopy(std::size_t plan, PlanCopyKind kind) {
    const SitePlan& wanted = site_.floor().plans.at(plan);
    const PlanImage* image = site_.wholeImage(wanted);
    if (!image) return;
    const auto tie = tieOf(site_.site(), wanted, *image);
    if (kind == PlanCopyKind::kGeoTiff && !tie) {
        emit refused(
            tr("A GeoTIFF says where on the globe it is. Tie the site to the globe "
               "first (G), then save it."));
        return;
    }
    PlanCopy copy{.plan = *image, .crop = wanted.crop, .geo_tie = tie, .kind = kind};
    copy.plan.placement = wanted.placement;
    const KindText& text = *std::ranges::find(kKinds, kind, &KindText::kind);
    auto* dialog = ask({tr(text.title), tr(text.name), QString::fromLatin1(text.suffix),
                        beside(wanted.image_file, tr("-copy") + QLatin1String(text.suffix))});
    connect(dialog, &QFileDialog::fileSelected, this, [this, copy](const QString& file) mutable {
        copy.file = file.toStdString();
        emit copyChosen(copy);
    });
}

void SiteSaver::askForSite() {
    const QString suffix = QString::fromLatin1(kSiteFileExtension);
    QString proposal = QDir::home().filePath(tr("site") + suffix);
    for (const SiteFloor& floor : site_.site().floors) {
        if (floor.plans.empty()) continue;
        proposal = beside(floor.plans.front().image_file, suffix);
        break;
    }
    auto* dialog = ask({tr("Save the site"), tr("Site"), suffix, proposal});
    connect(dialog, &QFileDialog::fileSelected, this, &SiteSaver::siteChosen);
}

SaveDialog* SiteSaver::ask(const SaveQuestion& question) {
    auto* dialog = new SaveDialog(question, theme_, window_);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
    return dialog;
}

}  // namespace hedr
