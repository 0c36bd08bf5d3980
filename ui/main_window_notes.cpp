#include <QAction>

#include "ui/error_text.h"
#include "ui/main_window.h"
#include "ui/map/map_view.h"
#include "ui/panels/banner.h"
#include "ui/panels/choice_note.h"
#include "ui/panels/plan_progress_card.h"
#include "ui/site/site_desk.h"

// What the window tells in banners, notes and progress cards; what it does is in main_window.cpp.
namespace hedr {
namespace {

constexpr int kNote_ms = 15000;  // long enough to be read twice

}  // namespace

void MainWindow::showPlanProgress(std::optional<double> progress) {
    if (progress) plan_progress_->setProgress(*progress);
    plan_progress_->setVisible(progress.has_value());
    refresh();
}

void MainWindow::showCopyProgress(std::optional<double> progress) {
    if (progress) copy_progress_->setProgress(*progress);
    if (copy_progress_->isVisibleTo(map_) == progress.has_value()) return;
    copy_progress_->setVisible(progress.has_value());
    placeOverlays();
}

void MainWindow::showError(const Error& error) {
    error_banner_->add(errorText(error), BannerTone::kAlarm);
    placeOverlays();
}

void MainWindow::showWarning(const Error& warning, const FleetRobot& about) {
    const QString text = errorText(warning);
    const QString whose = fleet_.several() ? tr("%1: %2").arg(fleet_.callSign(about), text) : text;
    error_banner_->add(whose, BannerTone::kWarning);
    placeOverlays();
}

void MainWindow::showSaved(const std::vector<std::filesystem::path>& files) {
    QStringList names;
    for (const auto& file : files) names << QString::fromStdString(file.filename().string());
    showNote(tr("Saved as %1 in the folder %2.")
                 .arg(names.join(tr(" and ")),
                      QString::fromStdString(files.front().parent_path().string())),
             BannerTone::kNews);
}

void MainWindow::showRefusal(const QString& why) { showNote(why, BannerTone::kWarning); }

void MainWindow::showNote(const QString& text, BannerTone tone) {
    note_banner_->setText(text, tone);
    text.isEmpty() ? note_timer_.stop() : note_timer_.start(kNote_ms);
    placeOverlays();
}

void MainWindow::offerResuming(const QString& text) {
    resume_note_->setText(text);
    resume_note_->setVisible(!text.isEmpty());
    placeOverlays();
}

void MainWindow::showFloorNote() {
    const SiteModel& site = desk_->site();
    const bool apart = !site.showsRobotFloor() && !model().trails().empty() && !desk_->open();
    if (apart) {
        const auto& floors = site.site().floors;
        floor_note_->setText(
            tr("This is %1. The robot is on %2.")
                .arg(QString::fromStdString(site.floor().name),
                     QString::fromStdString(floors.at(site.robotFloorIndex()).name)));
    }
    floor_note_->setVisible(apart);
    robot_here_->setEnabled(apart);
}

}  // namespace hedr
